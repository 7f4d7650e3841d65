/* SPDX-License-Identifier: MIT
 * port/isa/x86/best_row_x86.h - template: winner and runner-up. disparities is a multiple of VEC_LANES. */

/* Lanes to leave out are raised to the top: read from `centre - winner + 1`, this masks winner - 1 .. winner + 1. Beyond
 * MASK_REACH disparities the offset is held where nothing is masked. */
#define MASK_REACH 256
#define KEEP_8     INT16_MIN, INT16_MIN, INT16_MIN, INT16_MIN, INT16_MIN, INT16_MIN, INT16_MIN, INT16_MIN
#define KEEP_64    KEEP_8, KEEP_8, KEEP_8, KEEP_8, KEEP_8, KEEP_8, KEEP_8, KEEP_8
#define KEEP_REACH KEEP_64, KEEP_64, KEEP_64, KEEP_64
static const int16_t around_winner[2 * MASK_REACH + 3] = {KEEP_REACH, STAD_COST_MAX, STAD_COST_MAX, STAD_COST_MAX, KEEP_REACH};

static inline int least_total(const int16_t *total, int32_t n)
{
    vec least = vec_load(total);
    for (int32_t d = VEC_LANES; d < n; d += VEC_LANES)
        least = vec_min(least, vec_load(total + d));
    return vec_least_signed(least);
}

/* The smallest d with total[d] == value, and in *ties whether there are more. */
static inline int32_t first_equal(const int16_t *total, int32_t n, int value, int *ties)
{
    const vec wanted = vec_set(value), other = vec_set(value == 0 ? 1 : 0);
    int32_t first = -1, found = 0;
    for (int32_t d = (n - 1) / (2 * VEC_LANES) * (2 * VEC_LANES); d >= 0; d -= 2 * VEC_LANES) {
        const vec upper = d + VEC_LANES < n ? vec_load(total + d + VEC_LANES) : other;
        const uint64_t bits = vec_equal_bits(vec_load(total + d), upper, wanted);
        found += __builtin_popcountll(bits);
        first = bits ? d + __builtin_ctzll(bits) : first;
    }
    *ties = found > 1;
    return first;
}

static inline vec masked_far(const int16_t *total, int32_t d, int32_t winner)
{
    const int32_t at = d - (winner - 1); /* of this vector's first lane, from the first lane to mask */
    const int32_t held = at < -MASK_REACH ? -MASK_REACH : at > MASK_REACH - VEC_LANES + 3 ? MASK_REACH - VEC_LANES + 3 : at;
    return vec_max(vec_load(total + d), vec_load(around_winner + MASK_REACH + held));
}

static inline int16_t runner_up(const int16_t *total, int32_t n, int32_t winner)
{
    const int16_t *mask = around_winner + MASK_REACH - (winner - 1);
    vec least = vec_set(STAD_COST_MAX);
    for (int32_t d = 0; d < n; d += VEC_LANES)
        least = vec_min(least, n <= MASK_REACH - VEC_LANES ? vec_max(vec_load(total + d), vec_load(mask + d))
                                                           : masked_far(total, d, winner));
    return (int16_t)vec_least_signed(least);
}

/* least: that of `total`. */
static inline stad_best best_of(const int16_t *total, int32_t n, int least, int three_way)
{
    int ties;
    const int32_t first = first_equal(total, n, least, &ties);
    stad_best best = {(int16_t)(three_way || least < STAD_COST_MAX ? first : -1), (int16_t)least, 0};
    if (three_way && ties)
        stad_best_row_3way_c(total, 1, n, &best);
    else
        best.runner_up = runner_up(total, n, best.index);
    return best;
}

void STAD_TIER(stad_best_row)(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    for (int32_t i = 0; i < count; i++, total += disparities)
        best[i] = best_of(total, disparities, least_total(total, disparities), 0);
}

void STAD_TIER(stad_best_row_3way)(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    for (int32_t i = 0; i < count; i++, total += disparities)
        best[i] = best_of(total, disparities, least_total(total, disparities), 1);
}
