/* SPDX-License-Identifier: MIT
 * truth/polygon.h - convex polygons row by row. Corners are Q8, below 2^21. */
#ifndef STAD_TRUTH_POLYGON_H
#define STAD_TRUTH_POLYGON_H

#include "stad/truth.h"

/* Twice the signed area of a triangle, Q16: positive when it is clockwise on the screen. */
int64_t stad_polygon_turn(stad_corner a, stad_corner b, stad_corner c);

/* Where row y, in px, cuts the polygon: x from *low_q8 to *high_q8. 0 when it does not. */
int stad_polygon_cut(const stad_polygon *p, int32_t y, int32_t *low_q8, int32_t *high_q8);

/* The pixels of row y that lie inside by `margin` px in x and in y: first .. last. 0 when there are none. */
int stad_polygon_inner(const stad_polygon *p, int32_t y, int32_t margin, int32_t *first, int32_t *last);

/* The pixels of row y that lie inside or nearer than `margin` px to it in x or y. */
int stad_polygon_outer(const stad_polygon *p, int32_t y, int32_t margin, int32_t *first, int32_t *last);

/* The convex hull of `count` points, clockwise on the screen; `points` is sorted. 1, or 0 when it has more than
 * STAD_POLYGON_MAX corners or no area. */
int stad_polygon_hull(stad_corner *points, int32_t count, stad_polygon *hull);

#endif
