/* SPDX-License-Identifier: MIT
 * path -> [BEST] -> select
 * kernel/best_row.c - winner and runner-up of every pixel: one pass for the least, one for its place, one for its rival. */
#include "kernel/kernel.h"
#include "base/arith.h"

static int16_t least_of(const int16_t *restrict total, int32_t from, int32_t to)
{
    int16_t least = STAD_COST_MAX;
    for (int32_t d = from; d < to; d++)
        least = min_i16(least, total[d]);
    return least;
}

static int32_t first_with(const int16_t *total, int32_t n, int16_t value)
{
    for (int32_t d = 0; d < n; d++)
        if (total[d] == value)
            return d;
    return -1;
}

/* SPEC 8, 3WAY: in each residue class modulo 8 the largest d with this value; of these the smallest. */
static int32_t lane_rule(const int16_t *total, int32_t n, int16_t value)
{
    int32_t winner = n;
    for (int32_t lane = 0; lane < 8; lane++) {
        int32_t d = lane + ((n - 1 - lane) & ~7); /* the largest d of the class: n is a multiple of 8 */
        while (d >= 0 && total[d] != value)
            d -= 8;
        if (d >= 0)
            winner = min_i32(winner, d);
    }
    return winner;
}

static stad_best with_runner_up(const int16_t *total, int32_t n, int32_t index, int16_t least)
{
    stad_best best = {narrow_i16(index), least, least_of(total, 0, index - 1)};
    best.runner_up = min_i16(best.runner_up, least_of(total, max_i32(index + 2, 0), n));
    return best;
}

void stad_best_row_c(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    for (int32_t i = 0; i < count; i++, total += disparities) {
        const int16_t least = least_of(total, 0, disparities);
        const int32_t index = least < STAD_COST_MAX ? first_with(total, disparities, least) : -1;
        best[i] = with_runner_up(total, disparities, index, least);
    }
}

void stad_best_row_3way_c(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    for (int32_t i = 0; i < count; i++, total += disparities) {
        const int16_t least = least_of(total, 0, disparities);
        best[i] = with_runner_up(total, disparities, lane_rule(total, disparities, least), least);
    }
}
