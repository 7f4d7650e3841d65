/* SPDX-License-Identifier: MIT
 * path -> [BEST] -> select
 * port/isa/scalar/best_row_scalar.c - winner and runner-up, eight disparities a turn: what beats the least so far is rare. */
#include <stddef.h>

#include "../common/best_3way.h"
#include "word.h"

typedef struct search {
    int32_t least;
    const int16_t *place;
} search;

WORD_INLINE void look(search *s, const int16_t *total)
{
    if (__builtin_expect(*total < s->least, 0)) {
        s->least = *total;
        s->place = total;
    }
}

/* The least of `count` costs and of what was found before; the first place wins. */
WORD_INLINE void look_through(search *s, const int16_t *total, int32_t count)
{
    const int16_t *end = total + count;
    for (; end - total >= 8; total += 8) {
        look(s, total);
        look(s, total + 1);
        look(s, total + 2);
        look(s, total + 3);
        look(s, total + 4);
        look(s, total + 5);
        look(s, total + 6);
        look(s, total + 7);
    }
    for (; total < end; total++)
        look(s, total);
}

void stad_best_row_scalar(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    for (int32_t i = 0; i < count; i++, total += disparities) {
        search s = {STAD_COST_MAX, total - 1}, rival = {STAD_COST_MAX, NULL};
        look_through(&s, total, disparities);
        const int32_t index = (int32_t)(s.place - total);
        look_through(&rival, total, index - 1);
        look_through(&rival, total + index + 2, disparities - index - 2);
        best[i].index = (int16_t)index;
        best[i].least = (int16_t)s.least;
        best[i].runner_up = (int16_t)rival.least;
    }
}

void stad_best_row_3way_scalar(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    stad_best_row_scalar(total, count, disparities, best);
    best_ties_3way(total, count, disparities, best);
}
