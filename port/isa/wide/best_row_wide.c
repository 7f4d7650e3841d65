/* SPDX-License-Identifier: MIT
 * path -> [BEST] -> select
 * port/isa/wide/best_row_wide.c - winner and runner-up of every pixel, by three reductions over unsigned cells. */
#include "../common/best_3way.h"
#include "base/arith.h"
#include "wide.h"

#define LAST 0xFFFFu

/* All ones over three cells, none around them: read from REACH + 1 - index, over index - 1 .. index + 1. */
#define REACH     256
#define NONE_16   0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0
#define NONE_64   NONE_16, NONE_16, NONE_16, NONE_16
#define NONE_ELSE NONE_64, NONE_64, NONE_64, NONE_64
static const uint16_t around_winner[2 * REACH + 3] = {NONE_ELSE, LAST, LAST, LAST, NONE_ELSE};

/* S with its sign turned: unsigned order is its order. And back. */
static inline uint16_t rank_of(int16_t total)
{
    return (uint16_t)((uint16_t)total ^ 0x8000u);
}

static inline int16_t total_of(uint16_t rank)
{
    return narrow_i16(rank - 0x8000);
}

static uint16_t least_rank(const int16_t *total, int32_t disparities)
{
    const int32_t n = whole_16(disparities);
    uint16_t least = LAST;
    for (int32_t d = 0; d < n; d++)
        least = min_u16(least, rank_of(total[d]));
    return least;
}

/* The smallest d with this value, which some d has. */
static uint16_t first_with(const int16_t *total, int32_t disparities, int16_t value)
{
    const uint16_t n = (uint16_t)whole_16(disparities); /* as wide as the cells */
    uint16_t first = LAST;
    for (uint16_t d = 0; d < n; d++)
        first = min_u16(first, (uint16_t)(d | (uint16_t)((total[d] != value) * LAST)));
    return first;
}

static uint16_t rival_rank(const int16_t *total, int32_t disparities, const uint16_t *left_out)
{
    const int32_t n = whole_16(disparities);
    uint16_t least = LAST;
    for (int32_t d = 0; d < n; d++)
        least = min_u16(least, (uint16_t)(rank_of(total[d]) | left_out[d]));
    return least;
}

static stad_best best_of(const int16_t *total, int32_t n)
{
    const int16_t least = total_of(least_rank(total, n));
    const int16_t index = least < STAD_COST_MAX ? (int16_t)first_with(total, n, least) : -1;
    const stad_best best = {index, least, total_of(rival_rank(total, n, around_winner + REACH + 1 - index))};
    return best;
}

void stad_best_row_wide(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    if (!is_whole_16(disparities) || disparities > REACH) {
        stad_best_row_c(total, count, disparities, best);
        return;
    }
    for (int32_t i = 0; i < count; i++, total += disparities)
        best[i] = best_of(total, disparities);
}

void stad_best_row_3way_wide(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    stad_best_row_wide(total, count, disparities, best);
    best_ties_3way(total, count, disparities, best);
}
