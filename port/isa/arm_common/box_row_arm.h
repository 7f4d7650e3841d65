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

static inline void move_eight(int16_t *sum, const uint8_t *in, const uint8_t *out)
{
    vec_store(sum, vec_add(vec_load(sum), vec_sub_widened(in, out)));
}

void STAD_TIER(stad_box_move_row_u8)(int16_t *sum, const uint8_t *in, const uint8_t *out, int32_t n)
{
    int32_t left = n;
    for (; left >= 32; left -= 32, sum += 32, in += 32, out += 32) {
        move_eight(sum, in, out);
        move_eight(sum + 8, in + 8, out + 8);
        move_eight(sum + 16, in + 16, out + 16);
        move_eight(sum + 24, in + 24, out + 24);
    }
    for (; left >= 8; left -= 8, sum += 8, in += 8, out += 8)
        move_eight(sum, in, out);
    stad_box_move_row_u8_c(sum, in, out, left);
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

/* `size` disparities of the whole run from the d-th on, the running sums in registers. size and `inside` (no column
 * repeats) are constants where it is inlined. */
static inline __attribute__((always_inline)) void slide_group(const stad_slide_job *job, int32_t d, int32_t size, int inside,
                                                              int16_t *to)
{
    const ptrdiff_t n = job->disparities;
    const int32_t r = job->radius;
    const int16_t *in = sum_column(job, job->x - r) + d, *out = in;
    vec run[4];
    for (int32_t k = 0; k < size / 8; k++)
        run[k] = vec_set(job->p2);
    for (int32_t x = job->x - r; x <= job->x + r; x++) {
#pragma GCC unroll 4
        for (int32_t k = 0; k < size / 8; k++)
            run[k] = vec_add(run[k], vec_load(in + 8 * k));
        in += inside ? n : to_next(job, x);
    }
    for (int32_t i = job->count, x = job->x;; x++) {
#pragma GCC unroll 4
        for (int32_t k = 0; k < size / 8; k++)
            vec_store(to + 8 * k, run[k]);
        if (--i == 0)
            break;
        to += n;
#pragma GCC unroll 4
        for (int32_t k = 0; k < size / 8; k++)
            run[k] = vec_sub(vec_add(run[k], vec_load(in + 8 * k)), vec_load(out + 8 * k));
        in += inside || x + r + 1 < job->columns - 1 ? n : 0;
        out += inside || x >= r ? n : 0;
    }
}

static __attribute__((noinline)) void slide_inside(const stad_slide_job *job, int16_t *block)
{
    int32_t d = 0;
    for (; d + 32 <= job->disparities; d += 32)
        slide_group(job, d, 32, 1, block + d);
    for (; d < job->disparities; d += 8)
        slide_group(job, d, 8, 1, block + d);
}

static __attribute__((noinline)) void slide_edge(const stad_slide_job *job, int16_t *block)
{
    int32_t d = 0;
    for (; d + 32 <= job->disparities; d += 32)
        slide_group(job, d, 32, 0, block + d);
    for (; d < job->disparities; d += 8)
        slide_group(job, d, 8, 0, block + d);
}

void STAD_TIER(stad_slide_row)(const stad_slide_job *job, int16_t *block)
{
    if (job->x >= job->radius && job->x + job->count + job->radius <= job->columns)
        slide_inside(job, block);
    else
        slide_edge(job, block);
}
