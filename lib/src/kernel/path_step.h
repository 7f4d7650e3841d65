/* SPDX-License-Identifier: MIT
 * kernel/path_step.h - one pixel of one or two lanes, as kernel/path_row.c takes it. */
#ifndef STAD_KERNEL_PATH_STEP_H
#define STAD_KERNEL_PATH_STEP_H

#include "kernel/kernel.h"
#include "base/arith.h"

/* Of each lane: the costs it reads and writes, m + p2 before the step, its least cost after it. */
typedef struct stad_path_step {
    const int16_t *from[2];
    int16_t *to[2];
    int32_t disparities;
    int16_t p1, delta[2], least[2];
} stad_path_step;

/* L at p[0], between p[-1] and p[1]. */
static inline int16_t stad_path_cost(const int16_t *p, int16_t block, int16_t delta, int16_t p1)
{
    const int16_t side = (int16_t)(min_i16(min_i16(p[-1], p[1]), (int16_t)(delta - p1)) + p1);
    return (int16_t)(block + (min_i16(p[0], side) - delta));
}

/* S and one L more, both >= 0. */
static inline int16_t stad_path_sum(int16_t total, int16_t path)
{
    return (int16_t)(total + min_i16((int16_t)(STAD_COST_MAX - total), path));
}

void stad_path_step_two(const int16_t *restrict from_a, int16_t *restrict to_a, const int16_t *restrict from_b,
                        int16_t *restrict to_b, const int16_t *restrict block, int16_t *restrict total, stad_path_step *s);

#endif
