/* SPDX-License-Identifier: MIT
 * proof/prove_polygon.c - where a row cuts a polygon of three or eight corners anywhere within 4096 px of an image of up to 2048 px,
 * the pixels inside and outside of it by margins of 0 and 1 px; the hull of three to six points.
 * SOURCES: truth/polygon.c
 * PRECISION: 1
 * KNOWN: division by zero. assert (int64_t)((int32_t)(b.y_q8 - a.y_q8))
 * GUARD: truth/polygon.c if (a.y_q8 != b.y_q8) {
 * OPTIONS: -eva-min-loop-unroll 33 -eva-slevel-function stad_polygon_hull:300,append:300,stad_polygon_outer:200,prove_rows:200
 * An interval has no hole: that the corners' y differ was asked just before the division. */
#include "truth/polygon.h"

#include "proof/prove.h"

enum { LOW = -4096 * 256, HIGH = (4096 + 2048) * 256 };

static void prove_rows(int corners)
{
    stad_polygon p;
    int32_t low, high, first, last;
    p.count = corners;
    for (int i = 0; i < corners; i++) {
        p.p[i].x_q8 = any(LOW, HIGH);
        p.p[i].y_q8 = any(LOW, HIGH);
    }
    if (stad_polygon_cut(&p, any(-16, 2048 + 16), &low, &high)) {
        //@ assert LOW <= low <= HIGH && LOW <= high <= HIGH;
    }
    for (int margin = 0; margin <= 1; margin++) {
        if (stad_polygon_inner(&p, any(0, 2047), margin, &first, &last)) {
            //@ assert LOW / 256 - 16 <= first <= HIGH / 256 + 16 && LOW / 256 - 16 <= last <= HIGH / 256 + 16;
        }
        if (stad_polygon_outer(&p, any(0, 2047), margin, &first, &last)) {
            //@ assert LOW / 256 - 16 <= first <= HIGH / 256 + 16 && LOW / 256 - 16 <= last <= HIGH / 256 + 16;
        }
    }
}

static void prove_hull(int count)
{
    stad_corner points[6];
    static stad_polygon hull;
    for (int i = 0; i < count; i++) {
        points[i].x_q8 = any(LOW, HIGH);
        points[i].y_q8 = any(LOW, HIGH);
    }
    stad_polygon_hull(points, count, &hull);
}

int main(void)
{
    prove_rows(3);
    prove_rows(8);
    for (int count = 3; count <= 6; count++)
        prove_hull(count);
    return 0;
}
