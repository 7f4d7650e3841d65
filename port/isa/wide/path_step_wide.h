/* SPDX-License-Identifier: MIT
 * port/isa/wide/path_step_wide.h - one pixel of one, two or four lanes.
 *
 * The loops are in a file of their own: a compiler that inlines them no longer knows that their pointers do not overlap, and
 * then tests that at every pixel. */
#ifndef STAD_PATH_STEP_WIDE_H
#define STAD_PATH_STEP_WIDE_H

#include <stdint.h>

/* Costs of a lane at the pixel before and at this one; m + p2 before it, the least cost after it. */
typedef struct wide_lane {
    const uint16_t *restrict from;
    uint16_t *restrict to;
    uint16_t delta, least;
} wide_lane;

/* block: C. total: S, added to. disparities: a multiple of 16. All cells are within 0..32767. */
typedef struct wide_pixel {
    wide_lane a, b, c, d;
    const uint16_t *restrict block;
    uint16_t *restrict total;
    int32_t disparities;
    uint16_t p1;
} wide_pixel;

/* Lane a; a and b; all four. delta: a's. Returns a's least cost: both pass by register, because a path along the row waits for
 * them at every pixel. */
uint16_t stad_path_one_wide(wide_pixel *restrict pixel, uint16_t delta);
uint16_t stad_path_two_wide(wide_pixel *restrict pixel, uint16_t delta);
uint16_t stad_path_four_wide(wide_pixel *restrict pixel, uint16_t delta);

#endif
