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

/* Four vectors from or to consecutive addresses: one instruction where there is one. */
#if !VEC_FOURS
typedef struct vec4 {
    vec val[4];
} vec4;

static inline vec4 vec4_load(const int16_t *p)
{
    vec4 v = {{vec_load(p), vec_load(p + 8), vec_load(p + 16), vec_load(p + 24)}};
    return v;
}

static inline void vec4_store(int16_t *p, vec4 v)
{
    vec_store(p, v.val[0]);
    vec_store(p + 8, v.val[1]);
    vec_store(p + 16, v.val[2]);
    vec_store(p + 24, v.val[3]);
}

/* Differences of 32 bytes. */
static inline vec4 vec4_sub_widened(const uint8_t *a, const uint8_t *b)
{
    vec4 v = {
        {vec_sub_widened(a, b), vec_sub_widened(a + 8, b + 8), vec_sub_widened(a + 16, b + 16), vec_sub_widened(a + 24, b + 24)}};
    return v;
}
#endif

static inline vec4 vec4_set(int32_t v)
{
    vec4 all = {{vec_set(v), vec_set(v), vec_set(v), vec_set(v)}};
    return all;
}

static inline vec4 vec4_add(vec4 a, vec4 b)
{
#pragma GCC unroll 4
    for (int j = 0; j < 4; j++)
        a.val[j] = vec_add(a.val[j], b.val[j]);
    return a;
}

static inline vec4 vec4_sub(vec4 a, vec4 b)
{
#pragma GCC unroll 4
    for (int j = 0; j < 4; j++)
        a.val[j] = vec_sub(a.val[j], b.val[j]);
    return a;
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

/* The whole run from the d-th disparity on, the running sums in registers: 32 disparities, then 8. `inside`: no column
 * repeats. */
#define SLIDE(name, type, set, load, store, add, sub)                                                                     \
    static inline __attribute__((always_inline)) void name(const stad_slide_job *job, int32_t d, int inside, int16_t *to) \
    {                                                                                                                     \
        const ptrdiff_t n = job->disparities;                                                                             \
        const int32_t r = job->radius, last = job->columns - 1;                                                           \
        const int16_t *in = sum_column(job, job->x - r) + d, *out = in;                                                   \
        type run = set(job->p2);                                                                                          \
        for (int32_t x = job->x - r; x <= job->x + r; x++) {                                                              \
            run = add(run, load(in));                                                                                     \
            in += inside ? n : to_next(job, x);                                                                           \
        }                                                                                                                 \
        store(to, run);                                                                                                   \
        for (int32_t i = job->count - 1, x = job->x; i > 0; i--, x++) {                                                   \
            run = sub(add(run, load(in)), load(out));                                                                     \
            to += n;                                                                                                      \
            store(to, run);                                                                                               \
            in += inside || x + r + 1 < last ? n : 0;                                                                     \
            out += inside || x >= r ? n : 0;                                                                              \
        }                                                                                                                 \
    }

SLIDE(slide_32, vec4, vec4_set, vec4_load, vec4_store, vec4_add, vec4_sub)
SLIDE(slide_8, vec, vec_set, vec_load, vec_store, vec_add, vec_sub)

static __attribute__((noinline)) void slide_inside(const stad_slide_job *job, int16_t *block)
{
    int32_t d = 0;
    for (; d + 32 <= job->disparities; d += 32)
        slide_32(job, d, 1, block + d);
    for (; d < job->disparities; d += 8)
        slide_8(job, d, 1, block + d);
}

static __attribute__((noinline)) void slide_edge(const stad_slide_job *job, int16_t *block)
{
    int32_t d = 0;
    for (; d + 32 <= job->disparities; d += 32)
        slide_32(job, d, 0, block + d);
    for (; d < job->disparities; d += 8)
        slide_8(job, d, 0, block + d);
}

void STAD_TIER(stad_slide_row)(const stad_slide_job *job, int16_t *block)
{
    if (job->x >= job->radius && job->x + job->count + job->radius <= job->columns)
        slide_inside(job, block);
    else
        slide_edge(job, block);
}
