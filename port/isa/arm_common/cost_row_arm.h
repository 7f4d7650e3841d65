/* SPDX-License-Identifier: MIT
 * port/isa/arm_common/cost_row_arm.h - template: pixel costs, 16 disparities at once, in bytes.
 *
 * disparities is a multiple of 8: where 16 do not divide it, the last 16 overlap the ones before and are written twice
 * with the same values; fewer than 16 are left to C. */

/* A left sample and its range, and where the right row's samples begin. */
typedef struct plane_pair {
    vec value, low;
    uint8_t value_u8, high_u8;
    const uint8_t *right;
} plane_pair;

static inline plane_pair pair_at(const stad_cost_job *job, int32_t plane, int32_t x)
{
    const ptrdiff_t width = job->width;
    const uint8_t *left = job->left + plane * 3 * width + x;
    plane_pair pair = {vec_set_u8(left[0]), vec_set_u8(left[width]), left[0], left[2 * width],
                       job->right + plane * 3 * width + (width - 1 - x + job->min_disparity)};
    return pair;
}

static inline vec distance(const plane_pair *p, ptrdiff_t width, int32_t d)
{
    const vec value = vec_load_u8(p->right + d), low = vec_load_u8(p->right + width + d);
    const vec high = vec_load_u8(p->right + 2 * width + d);
    const vec to_right = vec_max_u8(vec_sub_floor_u8(p->value, high), vec_sub_floor_scalar_u8(low, p->value_u8));
    const vec to_left = vec_max_u8(vec_sub_floor_scalar_u8(value, p->high_u8), vec_sub_floor_u8(p->low, value));
    return vec_min_u8(to_right, to_left);
}

/* Where the d-th group of 16 begins. */
static inline int32_t group_at(int32_t d, int32_t n)
{
    return d + 16 <= n ? d : n - 16;
}

static void column_u8(const stad_cost_job *job, int32_t x, int32_t channel, uint8_t *cost)
{
    const plane_pair gradient = pair_at(job, channel, x), intensity = pair_at(job, job->channels + channel, x);
    const int32_t n = job->disparities;
    for (int32_t d = 0; d < n; d += 16) {
        const int32_t at = group_at(d, n);
        const vec quarter = vec_shift_right_u8(distance(&intensity, job->width, at), 2);
        vec_store_u8(cost + at, vec_add_u8(distance(&gradient, job->width, at), quarter));
    }
}

void STAD_TIER(stad_cost_row_u8)(const stad_cost_job *job, uint8_t *cost)
{
    if (job->channels != 1 || job->disparities < 16) {
        stad_cost_row_u8_c(job, cost);
        return;
    }
    for (int32_t i = 0; i < job->count; i++, cost += job->disparities)
        column_u8(job, job->x + i, 0, cost);
}

/* Columns of several channels: each 16 disparities are summed over the channels before they are stored. */
static void column_u16(const stad_cost_job *job, int32_t x, uint16_t *cost)
{
    const int32_t n = job->disparities;
    for (int32_t d = 0; d < n; d += 16) {
        const int32_t at = group_at(d, n);
        vec first = vec_set(0), second = vec_set(0);
        for (int32_t c = 0; c < job->channels; c++) {
            const plane_pair gradient = pair_at(job, c, x), intensity = pair_at(job, job->channels + c, x);
            uint8_t g[16], q[16];
            vec_store_u8(g, distance(&gradient, job->width, at));
            vec_store_u8(q, vec_shift_right_u8(distance(&intensity, job->width, at), 2));
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
