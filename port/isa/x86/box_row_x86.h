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

static inline int32_t clamp_column(int32_t x, int32_t columns)
{
    return x < 0 ? 0 : x < columns ? x : columns - 1;
}

/* The run's block costs of `vecs` vectors of disparities: their sums stay in registers while the columns go by. Inside the
 * image the columns taken in and given up just move on; near its edges they are clamped. */
static inline __attribute__((always_inline)) void slide_lanes(const stad_slide_job *job, int32_t d, int vecs, int inside,
                                                              int16_t *block)
{
    const ptrdiff_t n = job->disparities, r = job->radius;
    const int16_t *sum = job->sum + d, *in = sum + (job->x + r) * n, *out = sum + (job->x - r - 1) * n;
    vec run[2];
    for (int v = 0; v < vecs; v++)
        run[v] = vec_set(job->p2);
    for (int32_t j = job->x - job->radius; j <= job->x + job->radius; j++)
        for (int v = 0; v < vecs; v++)
            run[v] = vec_add(run[v], vec_load(sum + clamp_column(j, job->columns) * n + v * VEC_LANES));
    for (int32_t i = 0; i < job->count; i++, block += n) {
        if (i > 0 && !inside) {
            in = sum + clamp_column(job->x + i + job->radius, job->columns) * n;
            out = sum + clamp_column(job->x + i - job->radius - 1, job->columns) * n;
        }
        for (int v = 0; v < vecs; v++) {
            if (i > 0)
                run[v] = vec_add(run[v], vec_sub(vec_load(in + v * VEC_LANES), vec_load(out + v * VEC_LANES)));
            vec_store(block + d + v * VEC_LANES, run[v]);
        }
        in += n;
        out += n;
    }
}

/* disparities is a multiple of VEC_LANES; two vectors at a time, so that a cache line is taken whole. */
void STAD_TIER(stad_slide_row)(const stad_slide_job *job, int16_t *block)
{
    const int inside = job->x - job->radius >= 0 && job->x + job->count + job->radius <= job->columns;
    int32_t d = 0;
    for (; d + 2 * VEC_LANES <= job->disparities; d += 2 * VEC_LANES) {
        if (inside)
            slide_lanes(job, d, 2, 1, block);
        else
            slide_lanes(job, d, 2, 0, block);
    }
    if (d < job->disparities)
        slide_lanes(job, d, 1, inside, block);
}
