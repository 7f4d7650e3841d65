/* SPDX-License-Identifier: MIT
 * proof/prove_quad.c - a contour to a refined quadrilateral: contours of 24 points anywhere in images of up to 2048 px, any lines along
 * their sides and along the edges in the image.
 * SOURCES: mark/mark_quad.c mark/mark_refine.c mark/mark_line.c base/log.c
 * OPTIONS: -eva-min-loop-unroll 25
 * Lines are taken at their widest; prove_side.c and prove_mark.c show that they are no wider, the latter for corners of the range that
 * is asserted here. */
#include "mark/mark_work.h"
#include "proof/prove.h"

enum { POINTS = 24, SIZE = 2048, REACH = SIZE * 256 };

static mark_line any_line(int32_t reach)
{
    const mark_line line = {
        {any(-reach / 8, reach + reach / 8), any(-reach / 8, reach + reach / 8)}, any(-16384, 16384), any(-16384, 16384)};
    return line;
}

int stad_mark_side(const mark_work *w, int32_t i, int32_t k, mark_line *line)
{
    *line = any_line(SIZE * 16);
    return any(0, 1);
}

int stad_mark_edge_line(const mark_work *w, stad_corner a, stad_corner b, int32_t reach, mark_line *line)
{
    //@ assert -REACH / 8 <= a.x_q8 <= REACH + REACH / 8 && -REACH / 8 <= a.y_q8 <= REACH + REACH / 8;
    //@ assert -REACH / 8 <= b.x_q8 <= REACH + REACH / 8 && -REACH / 8 <= b.y_q8 <= REACH + REACH / 8;
    //@ assert 1 <= reach <= MARK_MAX_REACH;
    *line = any_line(REACH);
    return any(0, 1);
}

int main(void)
{
    static mark_point contour[POINTS];
    mark_work w = {0};
    mark_quad quad;
    w.contour = contour;
    w.contour_count = POINTS;
    for (int i = 0; i < POINTS; i++) {
        contour[i].x = (int16_t)any(0, SIZE);
        contour[i].y = (int16_t)any(0, SIZE);
    }
    if (stad_mark_quad(&w, any(0, 2 * SIZE * SIZE), &quad))
        stad_mark_refine(&w, &quad);
    return 0;
}
