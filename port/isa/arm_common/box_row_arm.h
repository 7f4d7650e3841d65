/* SPDX-License-Identifier: MIT
 * port/isa/arm_common/box_row_arm.h - template: vertical sums of cost rows, and the block costs slid along them. */

void STAD_TIER(stad_box_add_row_u8)(int16_t *sum, const uint8_t *cost, int32_t n, int32_t weight)
{
    int32_t i = 0;
    for (; i + 8 <= n; i += 8)
        vec_store(sum + i, vec_add(vec_load(sum + i), vec_mul_scalar(vec_widen(cost + i), weight)));
    stad_box_add_row_u8_c(sum + i, cost + i, n - i, weight);
}

void STAD_TIER(stad_box_add_row_u16)(int16_t *sum, const uint16_t *cost, int32_t n, int32_t weight)
{
    int32_t i = 0;
    for (; i + 8 <= n; i += 8)
        vec_store(sum + i, vec_add(vec_load(sum + i), vec_mul_scalar(vec_load(cost + i), weight)));
    stad_box_add_row_u16_c(sum + i, cost + i, n - i, weight);
}

void STAD_TIER(stad_box_move_row_u8)(int16_t *sum, const uint8_t *in, const uint8_t *out, int32_t n)
{
    int32_t i = 0;
    for (; i + 8 <= n; i += 8)
        vec_store(sum + i, vec_add(vec_load(sum + i), vec_sub_widened(in + i, out + i)));
    stad_box_move_row_u8_c(sum + i, in + i, out + i, n - i);
}

void STAD_TIER(stad_box_move_row_u16)(int16_t *sum, const uint16_t *in, const uint16_t *out, int32_t n)
{
    int32_t i = 0;
    for (; i + 8 <= n; i += 8)
        vec_store(sum + i, vec_add(vec_load(sum + i), vec_sub(vec_load(in + i), vec_load(out + i))));
    stad_box_move_row_u16_c(sum + i, in + i, out + i, n - i);
}

static inline const int16_t *sum_column(const stad_slide_job *job, int32_t x)
{
    const int32_t last = job->columns - 1;
    return job->sum + (ptrdiff_t)(x < 0 ? 0 : x < last ? x : last) * job->disparities;
}

static void slide_column(int16_t *to, const int16_t *from, const int16_t *in, const int16_t *out, int32_t n)
{
    for (int32_t d = 0; d < n; d += 8)
        vec_store(to + d, vec_add(vec_load(from + d), vec_sub(vec_load(in + d), vec_load(out + d))));
}

void STAD_TIER(stad_slide_row)(const stad_slide_job *job, int16_t *block)
{
    const int32_t n = job->disparities, r = job->radius;
    for (int32_t d = 0; d < n; d += 8) {
        vec run = vec_set(job->p2);
        for (int32_t j = -r; j <= r; j++)
            run = vec_add(run, vec_load(sum_column(job, job->x + j) + d));
        vec_store(block + d, run);
    }
    for (int32_t i = 1; i < job->count; i++, block += n)
        slide_column(block + n, block, sum_column(job, job->x + i + r), sum_column(job, job->x + i - r - 1), n);
}
