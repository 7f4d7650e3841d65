/* SPDX-License-Identifier: MIT
 * kernel/path_pair.c - one pixel of two lanes, which share a reading of the block costs and of the sums, and one loop.
 *
 * In a file of its own, because a compiler that inlines it no longer knows that its pointers do not overlap, and tests that
 * at every pixel. */
#include "kernel/path_step.h"

void stad_path_step_two(const int16_t *restrict from_a, int16_t *restrict to_a, const int16_t *restrict from_b,
                        int16_t *restrict to_b, const int16_t *restrict block, int16_t *restrict total, stad_path_step *s)
{
    const int32_t n = whole_8(s->disparities);
    const int16_t p1 = s->p1, delta_a = s->delta[0], delta_b = s->delta[1];
    int16_t least_a = STAD_COST_MAX, least_b = STAD_COST_MAX;
    for (int32_t d = 0; d < n; d++) {
        const int16_t a = stad_path_cost(from_a + d, block[d], delta_a, p1);
        const int16_t b = stad_path_cost(from_b + d, block[d], delta_b, p1);
        to_a[d] = a;
        to_b[d] = b;
        least_a = min_i16(least_a, a);
        least_b = min_i16(least_b, b);
        total[d] = stad_path_sum(stad_path_sum(total[d], a), b);
    }
    s->least[0] = least_a;
    s->least[1] = least_b;
}
