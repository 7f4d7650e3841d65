/* SPDX-License-Identifier: MIT
 * port/isa/x86/box_row_x86.h - template: vertical sums of cost rows, and the block costs slid along them. */

void STAD_TIER(stad_box_add_row_u8)(int16_t *sum, const uint8_t *cost, int32_t n, int32_t weight)
{
    const vec w = vec_set(weight);
    int32_t i = 0;
    for (; i + VEC_LANES <= n; i += VEC_LANES)
        vec_store(sum + i, vec_add(vec_load(sum + i), vec_mul(w, vec_widen(cost + i))));
    stad_box_add_row_u8_c(sum + i, cost + i, n - i, weight);
}

void STAD_TIER(stad_box_add_row_u16)(int16_t *sum, const uint16_t *cost, int32_t n, int32_t weight)
{
    const vec w = vec_set(weight);
    int32_t i = 0;
    for (; i + VEC_LANES <= n; i += VEC_LANES)
        vec_store(sum + i, vec_add(vec_load(sum + i), vec_mul(w, vec_load(cost + i))));
    stad_box_add_row_u16_c(sum + i, cost + i, n - i, weight);
}

void STAD_TIER(stad_box_move_row_u8)(int16_t *sum, const uint8_t *in, const uint8_t *out, int32_t n)
{
    int32_t i = 0;
    for (; i + VEC_LANES <= n; i += VEC_LANES)
        vec_store(sum + i, vec_add(vec_load(sum + i), vec_sub(vec_widen(in + i), vec_widen(out + i))));
    stad_box_move_row_u8_c(sum + i, in + i, out + i, n - i);
}

void STAD_TIER(stad_box_move_row_u16)(int16_t *sum, const uint16_t *in, const uint16_t *out, int32_t n)
{
    int32_t i = 0;
    for (; i + VEC_LANES <= n; i += VEC_LANES)
        vec_store(sum + i, vec_add(vec_load(sum + i), vec_sub(vec_load(in + i), vec_load(out + i))));
    stad_box_move_row_u16_c(sum + i, in + i, out + i, n - i);
}

static inline int32_t clamp_column(int32_t x, int32_t columns)
{
    return x < 0 ? 0 : x < columns ? x : columns - 1;
}

/* disparities is a multiple of VEC_LANES. */
void STAD_TIER(stad_slide_row)(const stad_slide_job *job, int16_t *block)
{
    const int32_t n = job->disparities, r = job->radius, last = job->columns;
    for (int32_t d = 0; d < n; d += VEC_LANES) {
        vec run = vec_set(job->p2);
        for (int32_t j = -r; j <= r; j++)
            run = vec_add(run, vec_load(job->sum + (ptrdiff_t)clamp_column(job->x + j, last) * n + d));
        vec_store(block + d, run);
    }
    for (int32_t i = 1; i < job->count; i++, block += n) {
        const int16_t *in = job->sum + (ptrdiff_t)clamp_column(job->x + i + r, last) * n;
        const int16_t *out = job->sum + (ptrdiff_t)clamp_column(job->x + i - r - 1, last) * n;
        for (int32_t d = 0; d < n; d += VEC_LANES)
            vec_store(block + n + d, vec_add(vec_load(block + d), vec_sub(vec_load(in + d), vec_load(out + d))));
    }
}
