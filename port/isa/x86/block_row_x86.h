/* SPDX-License-Identifier: MIT
 * port/isa/x86/block_row_x86.h - template: a row of block costs moved by a row. */
#include "../common/block_zone.h"

static inline __attribute__((always_inline)) vec cost_lanes(const void *row, ptrdiff_t at, int wide)
{
    return wide ? vec_load((const uint16_t *)row + at) : vec_widen((const uint8_t *)row + at);
}

/* What comes in with `in` and leaves with `out`, of one cell each. */
static inline __attribute__((always_inline)) vec cost_change(const stad_block_job *job, ptrdiff_t at, int wide)
{
    return vec_sub(cost_lanes(job->in, at, wide), cost_lanes(job->out, at, wide));
}

/* The whole row of `vecs` vectors of disparities from d on: hs(in) - hs(out) stays in registers while the columns go by. */
static inline __attribute__((always_inline)) void block_lanes(const stad_block_job *job, int32_t d, int vecs, int wide,
                                                              int16_t *block)
{
    const int32_t r = job->radius;
    ptrdiff_t plus = d + block_column(job, r), minus = d;
    vec hs[4];
    block += d;
    for (int v = 0; v < vecs; v++)
        hs[v] = vec_set(0);
    for (int32_t x = -r - 1; x < r; x++) /* the sum one column to the left of the first */
        for (int v = 0; v < vecs; v++)
            hs[v] = vec_add(hs[v], cost_change(job, d + block_column(job, x) + v * VEC_LANES, wide));
    for (int32_t x = 0; x < job->columns;) {
        const block_zone zone = block_zone_at(job, x);
        for (; x < zone.end; x++, block += job->disparities, plus += zone.plus, minus += zone.minus) {
            for (int v = 0; v < vecs; v++) {
                const ptrdiff_t at = v * VEC_LANES;
                hs[v] = vec_add(hs[v], vec_sub(cost_change(job, plus + at, wide), cost_change(job, minus + at, wide)));
                vec_store(block + at, vec_add(vec_load(block + at), hs[v]));
            }
        }
    }
}

static inline __attribute__((always_inline)) void block_row(const stad_block_job *job, int wide, int16_t *block)
{
    int32_t d = 0;
    for (; d + 4 * VEC_LANES <= job->disparities; d += 4 * VEC_LANES)
        block_lanes(job, d, 4, wide, block);
    for (; d + 2 * VEC_LANES <= job->disparities; d += 2 * VEC_LANES)
        block_lanes(job, d, 2, wide, block);
    if (d < job->disparities)
        block_lanes(job, d, 1, wide, block);
}

/* disparities is a multiple of VEC_LANES. */
void STAD_TIER(stad_block_row)(const stad_block_job *job, int16_t *block)
{
    if (job->wide)
        block_row(job, 1, block);
    else
        block_row(job, 0, block);
}
