/* SPDX-License-Identifier: MIT
 * base/affine.h - least squares of v = a + b x + c y in integers.
 *
 * x, y below 2^15 in size, v below 2^22, at most 2^12 points: then the largest product of two sums is 2^27 * 2^34 = 2^61. Which
 * units they are in is the caller's affair. */
#ifndef STAD_BASE_AFFINE_H
#define STAD_BASE_AFFINE_H

#include <stdint.h>

enum { STAD_AFFINE_MAX_POINTS = 4096 };

typedef struct stad_affine_sums {
    int64_t n, x, y, v, xx, xy, yy, xv, yv;
} stad_affine_sums;

/* v = (a_q8 / 2^8) + (b_q20 x + c_q20 y) / 2^20. */
typedef struct stad_affine {
    int32_t a_q8, b_q20, c_q20;
} stad_affine;

void stad_affine_add(stad_affine_sums *s, int32_t x, int32_t y, int32_t v);

/* 1, or 0 when the points lie on a line a slope is 512 or more, or |a| is 2^22 or more. */
int stad_affine_solve(const stad_affine_sums *s, stad_affine *fit);

/* The value at (x, y), times 2^8. */
int64_t stad_affine_at_q8(const stad_affine *fit, int32_t x, int32_t y);

#endif
