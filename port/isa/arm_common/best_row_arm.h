/* SPDX-License-Identifier: MIT
 * port/isa/arm_common/best_row_arm.h - template: winner and runner-up.
 *
 * Each vector lane keeps the least cost of its residue class modulo 8 and where it stood: the first place (best_row), or
 * the last (3WAY, whose rule in SPEC 8 is just this). The winner is the smallest place among the lanes that hold the least. */

static inline __attribute__((always_inline)) stad_best best_of(const int16_t *total, int32_t n, int last_wins)
{
    vec least = vec_load(total), place = vec_count(), here = place, rival = vec_set(STAD_COST_MAX), from_winner;
    stad_best best;
    for (int32_t d = 8; d < n; d += 8) {
        const vec cost = vec_load(total + d);
        here = vec_add_scalar(here, 8);
        place = last_wins ? vec_where_less(least, cost, place, here) : vec_where_less(cost, least, here, place);
        least = vec_min(least, cost);
    }
    best.least = (int16_t)vec_least_signed(least);
    best.index = (int16_t)vec_least_signed(vec_where_equal(least, best.least, place));
    if (!last_wins && best.least == STAD_COST_MAX)
        best.index = -1;
    /* d - (index - 1), read as unsigned, is at most 2 at the winner and its neighbours alone */
    from_winner = vec_add_scalar(vec_count(), 1 - best.index);
    for (int32_t d = 0; d < n; d += 8) {
        rival = vec_min_where_above(rival, vec_load(total + d), from_winner, 2);
        from_winner = vec_add_scalar(from_winner, 8);
    }
    best.runner_up = (int16_t)vec_least_signed(rival);
    return best;
}

void STAD_TIER(stad_best_row)(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    for (int32_t i = 0; i < count; i++, total += disparities)
        best[i] = best_of(total, disparities, 0);
}

void STAD_TIER(stad_best_row_3way)(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    for (int32_t i = 0; i < count; i++, total += disparities)
        best[i] = best_of(total, disparities, 1);
}
