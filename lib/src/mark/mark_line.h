/* SPDX-License-Identifier: MIT
 * mark/mark_line.h - a straight line through points, and where two lines meet.
 *
 * Widths: the square of a sum of coordinates must stay below 2^63. Refined edges: 64 points in Q8, 2^6 * 2^20 = 2^26 each sum.
 * Contours: 2^13 points in Q4, 2^13 * 2^16 = 2^29. */
#ifndef STAD_MARK_LINE_H
#define STAD_MARK_LINE_H

#include <stdint.h>

#include "stad/mark.h"

/* Sums over points taken from `origin`. */
typedef struct mark_moments {
    stad_corner origin;
    int64_t n, x, y, xx, xy, yy;
} mark_moments;

/* A point of the line and its unit vector. */
typedef struct mark_line {
    stad_corner p;
    int32_t dx_q14, dy_q14;
} mark_line;

void stad_mark_moments_first(mark_moments *m, stad_corner origin);
void stad_mark_moments_add(mark_moments *m, int32_t x_q8, int32_t y_q8);

/* The line of least squares across its own longer extent. 1, or 0 for fewer than 3 points or no extent. */
int stad_mark_line_fit(const mark_moments *m, mark_line *line);

/* Distance of a point, Q8 px, positive to the right of the direction. */
int32_t stad_mark_line_distance_q8(const mark_line *line, int32_t x_q8, int32_t y_q8);

/* 1, or 0 when they meet at less than about 7 degrees, or farther than a sixteenth of `reach` from the square 0 .. reach. */
int stad_mark_line_meet(const mark_line *a, const mark_line *b, int32_t reach, stad_corner *p);

/* The vector (x, y) as a unit vector in Q14. Returns its length. */
int32_t stad_mark_unit_q14(int64_t x, int64_t y, int32_t *ux_q14, int32_t *uy_q14);

#endif
