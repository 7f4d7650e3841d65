/* SPDX-License-Identifier: MIT
 * path -> [BEST] -> refine
 * port/isa/arm_mve/best_row_mve.c - winner and runner-up among 32 disparities, which stay in registers; least values are
 * gathered in core registers. Other sizes are left to the template. */
#include <arm_mve.h>

#include "kernel/kernel.h"

enum { GROUPS = 4 };

static inline __attribute__((always_inline)) stad_best best_of_32(const int16_t *total, int16x8_t places)
{
    int16x8_t cost[GROUPS];
    int16_t least = INT16_MAX, index = INT16_MAX, rival = INT16_MAX;
#pragma GCC unroll 4
    for (int g = 0; g < GROUPS; g++) {
        cost[g] = vld1q_s16(total + 8 * g);
        least = vminvq_s16(least, cost[g]);
    }
#pragma GCC unroll 4
    for (int g = 0; g < GROUPS; g++)
        index = vminvq_p_s16(index, vaddq_n_s16(places, (int16_t)(8 * g)), vcmpeqq_n_s16(cost[g], least));
    if (least == INT16_MAX)
        index = -1;
    /* d - (index - 1), read as unsigned, is at most 2 at the winner and its neighbours alone */
    uint16x8_t from = vreinterpretq_u16_s16(vaddq_n_s16(places, (int16_t)(1 - index)));
    uint16_t beside = 2, on = 8;
    __asm__("" : "+r"(beside), "+r"(on)); /* in core registers: vectors are short */
#pragma GCC unroll 4
    for (int g = 0; g < GROUPS; g++) {
        rival = vminvq_p_s16(rival, cost[g], vcmphiq_n_u16(from, beside));
        from = vaddq_n_u16(from, on);
    }
    const stad_best best = {index, least, rival};
    return best;
}

void stad_best_row_sized_mve(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    const int16x8_t places = vreinterpretq_s16_u16(vidupq_n_u16(0, 1));
    if (disparities != 8 * GROUPS) {
        stad_best_row_mve(total, count, disparities, best);
        return;
    }
    for (uint32_t left = (uint32_t)count; left != 0; left--, total += 8 * GROUPS)
        *best++ = best_of_32(total, places);
}
