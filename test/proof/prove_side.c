/* SPDX-License-Identifier: MIT
 * proof/prove_side.c - a side of a contour: 24 points anywhere in images of up to 2048 px, from any third of them to any at least six on.
 * SOURCES: mark/mark_side.c mark/mark_line.c base/log.c
 * PRECISION: 1
 * OPTIONS: -eva-min-loop-unroll 25 */
#include "mark/mark_work.h"
#include "proof/prove.h"

enum { POINTS = 24 };

int main(void)
{
    static mark_point contour[POINTS];
    mark_work w = {0};
    mark_line line;
    w.contour = contour;
    w.contour_count = POINTS;
    for (int i = 0; i < POINTS; i++) {
        contour[i].x = (int16_t)any(0, 2048);
        contour[i].y = (int16_t)any(0, 2048);
    }
    for (int i = 0; i < POINTS; i += 3)
        for (int k = i + 6; k <= i + POINTS; k++)
            stad_mark_side(&w, i, k, &line);
    return 0;
}
