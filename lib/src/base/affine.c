/* SPDX-License-Identifier: MIT
 * base/affine.c - least squares of v = a + b x + c y in integers. */
#include "base/affine.h"

void stad_affine_add(stad_affine_sums *s, int32_t x, int32_t y, int32_t v)
{
    s->n++;
    s->x += x;
    s->y += y;
    s->v += v;
    s->xx += (int64_t)x * x;
    s->xy += (int64_t)x * y;
    s->yy += (int64_t)y * y;
    s->xv += (int64_t)x * v;
    s->yv += (int64_t)y * v;
}

/* A macro, for the value analysis to see through: it learns from a comparison, not from a call. */
#define OUTSIDE(v, bits) ((v) >= (int64_t)1 << (bits) || (v) <= -((int64_t)1 << (bits)))

/* numerator / determinant in Q20. Both are below 2^61, so the ratio is taken after shedding 20 bits where it must be. */
static int64_t ratio_q20(int64_t numerator, int64_t determinant)
{
    int shed = 0;
    for (; shed < 20 && OUTSIDE(numerator, 42); shed++)
        numerator /= 2;
    const int64_t scaled = numerator * ((int64_t)1 << 20), whole = determinant >> shed;
    return whole > 0 ? scaled / whole : (int64_t)1 << 40;
}

int stad_affine_solve(const stad_affine_sums *s, stad_affine *fit)
{
    if (s->n < 3 || s->n > STAD_AFFINE_MAX_POINTS)
        return 0;
    int64_t xx = s->xx - s->x * s->x / s->n, xy = s->xy - s->x * s->y / s->n, yy = s->yy - s->y * s->y / s->n;
    int64_t xv = s->xv - s->x * s->v / s->n, yv = s->yv - s->y * s->v / s->n;
    if (xx < 0 || yy < 0)
        return 0; /* sums that no points make */
    while (OUTSIDE(xx, 30) || OUTSIDE(yy, 30) || OUTSIDE(xy, 30) || OUTSIDE(xv, 30) || OUTSIDE(yv, 30)) {
        xx /= 2;
        xy /= 2;
        yy /= 2;
        xv /= 2;
        yv /= 2;
    }
    /* xy^2 <= xx yy; less than a thousandth of it left: the points are on a line. */
    const int64_t determinant = xx * yy - xy * xy;
    if (determinant <= 0 || determinant <= xx * yy / 1024)
        return 0;
    const int64_t b_q20 = ratio_q20(xv * yy - yv * xy, determinant), c_q20 = ratio_q20(yv * xx - xv * xy, determinant);
    if (OUTSIDE(b_q20, 29) || OUTSIDE(c_q20, 29))
        return 0;
    fit->b_q20 = (int32_t)b_q20;
    fit->c_q20 = (int32_t)c_q20;
    /* Q20 of the sum: < 2^34 * 2^20; the slopes' part < 2^29 * 2^27 = 2^56. */
    const int64_t a_q8 = (s->v * 1048576 - b_q20 * s->x - c_q20 * s->y) / s->n / 4096;
    if (OUTSIDE(a_q8, 30))
        return 0;
    fit->a_q8 = (int32_t)a_q8;
    return 1;
}

int64_t stad_affine_at_q8(const stad_affine *fit, int32_t x, int32_t y)
{
    return fit->a_q8 + ((int64_t)fit->b_q20 * x + (int64_t)fit->c_q20 * y) / 4096;
}
