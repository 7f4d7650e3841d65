/* SPDX-License-Identifier: MIT
 * port/isa/x86/best_row_x86.h - template: winner and runner-up. disparities is a multiple of VEC_LANES. */

/* Lanes to leave out are raised to the top; read at an offset this masks winner - 1 .. winner + 1 of any vector. */
#define KEEP_8 INT16_MIN, INT16_MIN, INT16_MIN, INT16_MIN, INT16_MIN, INT16_MIN, INT16_MIN, INT16_MIN
#if VEC_LANES == 16
#    define KEEP KEEP_8, KEEP_8
#else
#    define KEEP KEEP_8
#endif
static const int16_t around_winner[2 * VEC_LANES + 3] = {KEEP, STAD_COST_MAX, STAD_COST_MAX, STAD_COST_MAX, KEEP};

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
    const vec wanted = vec_set(value), none = vec_set(0);
    int32_t first = -1, found = 0;
    for (int32_t d = n - n % (2 * VEC_LANES); d >= 0; d -= 2 * VEC_LANES) {
        if (d == n)
            continue;
        const vec a = vec_equal(vec_load(total + d), wanted);
        const vec b = d + VEC_LANES < n ? vec_equal(vec_load(total + d + VEC_LANES), wanted) : none;
        const uint32_t bits = vec_bits(a, b);
        found += __builtin_popcount(bits);
        first = bits ? d + __builtin_ctz(bits) : first;
    }
    *ties = found > 1;
    return first;
}

static inline int16_t runner_up(const int16_t *total, int32_t n, int32_t winner)
{
    vec least = vec_set(STAD_COST_MAX);
    for (int32_t d = 0; d < n; d += VEC_LANES) {
        const int32_t at = winner - 1 - d; /* lane of winner - 1 in this vector */
        const int32_t shift = VEC_LANES - (at < -3 ? -3 : at > VEC_LANES ? VEC_LANES : at);
        least = vec_min(least, vec_max(vec_load(total + d), vec_load(around_winner + shift)));
    }
    return (int16_t)vec_least_signed(least);
}

void STAD_TIER(stad_best_row)(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    int ties;
    for (int32_t i = 0; i < count; i++, total += disparities) {
        const int least = least_total(total, disparities);
        const int32_t index = least < STAD_COST_MAX ? first_equal(total, disparities, least, &ties) : -1;
        best[i].index = (int16_t)index;
        best[i].least = (int16_t)least;
        best[i].runner_up = runner_up(total, disparities, index);
    }
}

void STAD_TIER(stad_best_row_3way)(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    int ties;
    for (int32_t i = 0; i < count; i++, total += disparities) {
        const int least = least_total(total, disparities);
        const int32_t index = first_equal(total, disparities, least, &ties);
        best[i].index = (int16_t)index;
        best[i].least = (int16_t)least;
        if (ties)
            stad_best_row_3way_c(total, 1, disparities, best + i);
        else
            best[i].runner_up = runner_up(total, disparities, index);
    }
}
