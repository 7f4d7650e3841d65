/* SPDX-License-Identifier: MIT
 * port/isa/arm_common/cost_row_arm.h - template: pixel costs, 16 disparities at once, in bytes.
 *
 * disparities is a multiple of 8: where 16 do not divide it, the last 16 overlap the ones before and are written twice
 * with the same values; fewer than 16 are left to C. */

/* A left sample of a plane, lows and highs a width further each; values, lows and highs of the right row from the column
 * that disparity d meets. */
typedef struct plane_pair {
    const uint8_t *left, *right, *right_low, *right_high;
    ptrdiff_t width;
} plane_pair;

static inline plane_pair pair_at(const stad_cost_job *job, int32_t plane, int32_t x, int32_t d)
{
    const ptrdiff_t width = job->width;
    const uint8_t *right = job->right + plane * 3 * width + (width - 1 - x + job->min_disparity + d);
    const plane_pair pair = {job->left + plane * 3 * width + x, right, right + width, right + 2 * width, width};
    return pair;
}

/* To the next column. Each address in a register of its own, or compilers make one for every load. */
static inline __attribute__((always_inline)) void plane_next(plane_pair *p)
{
    p->left++;
    p->right--;
    p->right_low--;
    p->right_high--;
    __asm__("" : "+r"(p->right), "+r"(p->right_low), "+r"(p->right_high));
}

#if !VEC_FOURS
/* No loads of several vectors: each when it is needed. */
typedef struct vec_rows_u8 {
    int value, low, high;
} vec_rows_u8;
#    define vec_load_rows_u8(value, low, high, groups) {0, 0, 0}
#    define vec_row_u8(row, from, k)                   vec_load_u8((from) + 16 * (k))
#endif

/* The distances of `groups` times 16 disparities. */
static inline __attribute__((always_inline)) void distances(const plane_pair *p, int32_t groups, vec *out)
{
    const uint8_t value_u8 = p->left[0], low_u8 = p->left[p->width], high_u8 = p->left[2 * p->width];
    const vec value = vec_set_u8(value_u8), low = vec_set_u8(low_u8);
    const uint8_t *right = p->right, *right_low = p->right_low, *right_high = p->right_high;
    const vec_rows_u8 rows = vec_load_rows_u8(right, right_low, right_high, groups);
    (void)rows;
#pragma GCC unroll 2
    for (int32_t k = 0; k < groups; k++) {
        const vec there = vec_row_u8(rows.value, right, k);
        const vec to_right = vec_max_u8(vec_sub_floor_u8(value, vec_row_u8(rows.high, right_high, k)),
                                        vec_sub_floor_scalar_u8(vec_row_u8(rows.low, right_low, k), value_u8));
        const vec to_left = vec_max_u8(vec_sub_floor_scalar_u8(there, high_u8), vec_sub_floor_u8(low, there));
        out[k] = vec_min_u8(to_right, to_left);
    }
}

/* Where the d-th group of 16 begins. */
static inline int32_t group_at(int32_t d, int32_t n)
{
    return d + 16 <= n ? d : n - 16;
}

/* `groups` times 16 disparities of the whole run. */
static inline __attribute__((always_inline)) void run_u8(const stad_cost_job *job, int32_t d, int32_t groups, uint8_t *cost)
{
    plane_pair gradient = pair_at(job, 0, job->x, d), intensity = pair_at(job, 1, job->x, d);
    const ptrdiff_t n = job->disparities;
    for (uint32_t left = (uint32_t)job->count; left != 0; left--, cost += n) {
        vec whole[2], quarter[2];
        distances(&gradient, groups, whole);
        distances(&intensity, groups, quarter);
#pragma GCC unroll 2
        for (int32_t k = 0; k < groups; k++)
            vec_store_u8(cost + 16 * k, vec_add_quarter_u8(whole[k], quarter[k]));
        plane_next(&gradient);
        plane_next(&intensity);
    }
}

void STAD_TIER(stad_cost_row_u8)(const stad_cost_job *job, uint8_t *cost)
{
    int32_t d = 0;
    if (job->channels != 1 || job->disparities < 16) {
        stad_cost_row_u8_c(job, cost);
        return;
    }
    for (; d + 32 <= job->disparities; d += 32)
        run_u8(job, d, 2, cost + d);
    for (; d < job->disparities; d += 16)
        run_u8(job, group_at(d, job->disparities), 1, cost + group_at(d, job->disparities));
}

/* Columns of several channels: each 16 disparities are summed over the channels before they are stored. */
static void column_u16(const stad_cost_job *job, int32_t x, uint16_t *cost)
{
    const int32_t n = job->disparities;
    for (int32_t d = 0; d < n; d += 16) {
        const int32_t at = group_at(d, n);
        vec first = vec_set(0), second = vec_set(0);
        for (int32_t c = 0; c < job->channels; c++) {
            const plane_pair gradient = pair_at(job, c, x, at), intensity = pair_at(job, job->channels + c, x, at);
            uint8_t g[16], q[16];
            vec whole, quarter;
            distances(&gradient, 1, &whole);
            distances(&intensity, 1, &quarter);
            vec_store_u8(g, whole);
            vec_store_u8(q, vec_shift_right_u8(quarter, 2));
            first = vec_add(first, vec_add(vec_widen(g), vec_widen(q)));
            second = vec_add(second, vec_add(vec_widen(g + 8), vec_widen(q + 8)));
        }
        vec_store(cost + at, first);
        vec_store(cost + at + 8, second);
    }
}

void STAD_TIER(stad_cost_row_u16)(const stad_cost_job *job, uint16_t *cost)
{
    if (job->disparities < 16) {
        stad_cost_row_u16_c(job, cost);
        return;
    }
    for (int32_t i = 0; i < job->count; i++, cost += job->disparities)
        column_u16(job, job->x + i, cost);
}
