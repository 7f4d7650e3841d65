/* SPDX-License-Identifier: MIT
 * path -> [BEST] -> select
 * port/isa/arm_dsp/best_row_dsp.c - winner and runner-up, two disparities an instruction. */
#include <stddef.h>

#include "../common/best_3way.h"
#include "pair_dsp.h"

/* Least costs and their first places among even and among odd disparities. */
typedef struct search {
    pair least, place, here;
} search;

PAIR_INLINE void look(search *s, pair cost)
{
    (void)__ssub16((int16x2_t)cost, (int16x2_t)s->least); /* sets GE where cost >= least */
    s->least = __sel(s->least, cost);
    s->place = __sel(s->place, s->here);
    s->here = __uadd16(s->here, 0x00020002u);
}

PAIR_INLINE stad_best winner_of(const int16_t *total, int32_t n)
{
    search s = {pair_set(STAD_COST_MAX), 0x00010000u, 0x00010000u};
    stad_best best;
    for (const int16_t *end = total + n; total != end; total += 8) {
        const quad a = quad_load(total), b = quad_load(total + 4);
        look(&s, a.low);
        look(&s, a.high);
        look(&s, b.low);
        look(&s, b.high);
    }
    const int32_t even = pair_low(s.least), odd = pair_high(s.least);
    const int odd_wins = odd < even || (odd == even && pair_high(s.place) < pair_low(s.place));
    best.least = (int16_t)(odd_wins ? odd : even);
    best.index = (int16_t)(odd_wins ? pair_high(s.place) : pair_low(s.place));
    best.runner_up = STAD_COST_MAX;
    return best;
}

PAIR_INLINE int32_t least_in(const int16_t *total, int32_t count, int32_t least)
{
    pair both = pair_set(least);
    for (; count >= 8; count -= 8, total += 8) {
        both = pair_min_i16(pair_min_i16(both, pair_load(total)), pair_load(total + 2));
        both = pair_min_i16(pair_min_i16(both, pair_load(total + 4)), pair_load(total + 6));
    }
    for (; count >= 2; count -= 2, total += 2)
        both = pair_min_i16(both, pair_load(total));
    if (count > 0)
        both = pair_min_i16(both, pair_set(*total));
    return pair_low(pair_min_i16(both, both >> 16 | both << 16));
}

void stad_best_row_dsp(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    for (int32_t i = 0; i < count; i++, total += disparities) {
        stad_best b = winner_of(total, disparities);
        if (b.least == STAD_COST_MAX)
            b.index = -1;
        b.runner_up = (int16_t)least_in(total, b.index - 1, b.runner_up);
        b.runner_up = (int16_t)least_in(total + b.index + 2, disparities - b.index - 2, b.runner_up);
        best[i] = b;
    }
}

void stad_best_row_3way_dsp(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    stad_best_row_dsp(total, count, disparities, best);
    best_ties_3way(total, count, disparities, best);
}
