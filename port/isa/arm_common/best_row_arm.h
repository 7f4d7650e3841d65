/* SPDX-License-Identifier: MIT
 * port/isa/arm_common/best_row_arm.h - template: winner and runner-up.
 *
 * Each vector lane keeps the least cost of its residue class modulo 8 and where it stood: the first place (best_row), or
 * the last (3WAY, whose rule in SPEC 8 is just this). The winner is the smallest place among the lanes that hold the least. */

#define ALWAYS_INLINE static inline __attribute__((always_inline))

/* `size` disparities at a time; size, and n where it is known, are constants where this is inlined. */
ALWAYS_INLINE stad_best best_of(const int16_t *total, int32_t n, int32_t size, int last_wins)
{
    vec least = vec_set(STAD_COST_MAX), place = vec_count(), rival = least, here = place, from_winner;
    stad_best best;
    for (int32_t d = 0; d < n; d += size) {
#pragma GCC unroll 4
        for (int32_t k = 0; k < size; k += 8) {
            const vec cost = vec_load(total + d + k);
            place = last_wins ? vec_where_less(least, cost, place, here) : vec_where_less(cost, least, here, place);
            least = vec_min(least, cost);
            here = vec_add_scalar(here, 8);
        }
    }
    best.least = (int16_t)vec_least_signed(least);
    best.index = (int16_t)vec_least_signed(vec_where_equal(least, best.least, place));
    if (!last_wins && best.least == STAD_COST_MAX)
        best.index = -1;
    /* d - (index - 1), read as unsigned, is at most 2 at the winner and its neighbours alone */
    from_winner = vec_add_scalar(vec_count(), 1 - best.index);
    for (int32_t d = 0; d < n; d += size) {
#pragma GCC unroll 4
        for (int32_t k = 0; k < size; k += 8) {
            rival = vec_min_where_above(rival, vec_load(total + d + k), from_winner, 2);
            from_winner = vec_add_scalar(from_winner, 8);
        }
    }
    best.runner_up = (int16_t)vec_least_signed(rival);
    return best;
}

ALWAYS_INLINE void best_of_run(const int16_t *total, int32_t count, int32_t n, stad_best *best, int last_wins)
{
    if (n == 32)
        for (int32_t i = 0; i < count; i++)
            best[i] = best_of(total + 32 * (ptrdiff_t)i, 32, 32, last_wins);
    else if (n % 32 == 0)
        for (int32_t i = 0; i < count; i++)
            best[i] = best_of(total + n * (ptrdiff_t)i, n, 32, last_wins);
    else
        for (int32_t i = 0; i < count; i++)
            best[i] = best_of(total + n * (ptrdiff_t)i, n, 8, last_wins);
}

void STAD_TIER(stad_best_row)(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    best_of_run(total, count, disparities, best, 0);
}

void STAD_TIER(stad_best_row_3way)(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    best_of_run(total, count, disparities, best, 1);
}
