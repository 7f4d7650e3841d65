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

/* Column x of the sums, and how far to the next one: columns outside repeat the border. */
static inline const int16_t *sum_column(const stad_slide_job *job, int32_t x)
{
    const int32_t last = job->columns - 1;
    return job->sum + (ptrdiff_t)(x < 0 ? 0 : x < last ? x : last) * job->disparities;
}

static inline ptrdiff_t to_next(const stad_slide_job *job, int32_t x)
{
    return x >= 0 && x < job->columns - 1 ? job->disparities : 0;
}

/* Eight disparities of the whole run, the running sum in a register. `inside`: no column repeats. */
static inline __attribute__((always_inline)) void slide_eight(const stad_slide_job *job, int32_t d, int inside,
                                                              int16_t *to)
{
    const ptrdiff_t n = job->disparities;
    const int16_t *in = sum_column(job, job->x - job->radius) + d, *out = in;
    vec run = vec_set(job->p2);
    for (int32_t x = job->x - job->radius; x <= job->x + job->radius; x++) {
        run = vec_add(run, vec_load(in));
        in += inside ? n : to_next(job, x);
    }
    vec_store(to, run);
    for (int32_t i = job->count - 1, x = job->x; i > 0; i--, x++) {
        run = vec_add(run, vec_sub(vec_load(in), vec_load(out)));
        to += n;
        vec_store(to, run);
        in += inside ? n : to_next(job, x + job->radius + 1);
        out += inside ? n : to_next(job, x - job->radius);
    }
}

void STAD_TIER(stad_slide_row)(const stad_slide_job *job, int16_t *block)
{
    const int inside = job->x >= job->radius && job->x + job->count + job->radius <= job->columns;
    for (int32_t d = 0; d < job->disparities; d += 8) {
        if (inside)
            slide_eight(job, d, 1, block + d);
        else
            slide_eight(job, d, 0, block + d);
    }
}
