/* SPDX-License-Identifier: MIT
 * path -> [BEST] -> select
 * kernel/best_row.c - winner and runner-up of every pixel: one pass for the least, one for its place, one for its rival.
 * No pass leaves early, so that each is a reduction over all D. */
#include "kernel/kernel.h"
#include "base/arith.h"

static int16_t least_of(const int16_t *total, int32_t disparities)
{
    const int32_t n = whole_8(disparities);
    int16_t least = STAD_COST_MAX;
    for (int32_t d = 0; d < n; d++)
        least = min_i16(least, total[d]);
    return least;
}

/* The smallest d with this value, which some d has. */
static int16_t first_with(const int16_t *total, int32_t disparities, int16_t value)
{
    const uint16_t n = (uint16_t)whole_8(disparities); /* as wide as the cells */
    int16_t first = (int16_t)(n - 1);
    for (uint16_t d = 0; d < n; d++) {
        const int16_t miss = (int16_t)((total[d] != value) * STAD_COST_MAX);
        first = min_i16(first, max_i16((int16_t)d, miss));
    }
    return first;
}

static int16_t last_with(const int16_t *total, int32_t disparities, int16_t value)
{
    const uint16_t n = (uint16_t)whole_8(disparities);
    int16_t last = 0;
    for (uint16_t d = 0; d < n; d++) {
        const int16_t hit = (int16_t)((total[d] == value) * STAD_COST_MAX);
        last = max_i16(last, min_i16((int16_t)d, hit));
    }
    return last;
}

/* The least of those more than one away from index. */
static int16_t least_apart(const int16_t *total, int32_t disparities, int16_t index)
{
    const uint16_t n = (uint16_t)whole_8(disparities);
    const int16_t low = (int16_t)(index - 1), high = (int16_t)(index + 1);
    int16_t least = STAD_COST_MAX;
    for (uint16_t d = 0; d < n; d++) {
        const int16_t at = (int16_t)d;
        const int16_t below = at < low ? INT16_MIN : STAD_COST_MAX; /* INT16_MIN leaves a cost as it is */
        const int16_t above = at > high ? INT16_MIN : STAD_COST_MAX;
        least = min_i16(least, max_i16(total[d], min_i16(below, above)));
    }
    return least;
}

/* SPEC 8, 3WAY: in each residue class modulo 8 the largest d with this value; of these the smallest. Only a tie needs it. */
static int16_t lane_rule(const int16_t *total, int32_t n, int16_t value)
{
    const int16_t first = first_with(total, n, value);
    if (first == last_with(total, n, value))
        return first;
    int32_t winner = n;
    for (int32_t lane = 0; lane < 8; lane++) {
        int32_t d = lane + ((n - 1 - lane) & ~7); /* the largest d of the class: n is a multiple of 8 */
        while (d >= 0 && total[d] != value)
            d -= 8;
        if (d >= 0)
            winner = min_i32(winner, d);
    }
    return narrow_i16(winner);
}

void stad_best_row_c(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    for (int32_t i = 0; i < count; i++, total += disparities) {
        best[i].least = least_of(total, disparities);
        best[i].index = best[i].least < STAD_COST_MAX ? first_with(total, disparities, best[i].least) : -1;
        best[i].runner_up = least_apart(total, disparities, best[i].index);
    }
}

void stad_best_row_3way_c(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    for (int32_t i = 0; i < count; i++, total += disparities) {
        best[i].least = least_of(total, disparities);
        best[i].index = lane_rule(total, disparities, best[i].least);
        best[i].runner_up = least_apart(total, disparities, best[i].index);
    }
}
