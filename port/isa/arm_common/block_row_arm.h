/* SPDX-License-Identifier: MIT
 * port/isa/arm_common/block_row_arm.h - template: a row of block costs moved by a row. */
#include "../common/block_zone.h"

#define vec_sub_costs(a, b) vec_sub(vec_load(a), vec_load(b))

/* The whole row from the d-th disparity on: hs(in) - hs(out) stays in registers while the columns go by. */
#define BLOCK(name, cost_t, type, set, load, store, add, sub, change)                             \
    static __attribute__((noinline)) void name(const stad_block_job *job, int32_t d, int16_t *to) \
    {                                                                                             \
        const ptrdiff_t n = job->disparities;                                                     \
        const int32_t r = job->radius;                                                            \
        const cost_t *in = (const cost_t *)job->in + d, *out = (const cost_t *)job->out + d;      \
        const cost_t *in_left = in, *out_left = out;                                              \
        type hs = set(0);                                                                         \
        for (int32_t x = -r - 1; x < r; x++)                                                      \
            hs = add(hs, change(in + block_column(job, x), out + block_column(job, x)));          \
        in += block_column(job, r);                                                               \
        out += block_column(job, r);                                                              \
        for (int32_t x = 0; x < job->columns;) {                                                  \
            const block_zone zone = block_zone_at(job, x);                                        \
            for (; x < zone.end; x++, to += n) {                                                  \
                hs = sub(add(hs, change(in, out)), change(in_left, out_left));                    \
                store(to, add(load(to), hs));                                                     \
                in += zone.plus;                                                                  \
                out += zone.plus;                                                                 \
                in_left += zone.minus;                                                            \
                out_left += zone.minus;                                                           \
            }                                                                                     \
        }                                                                                         \
    }

BLOCK(block_32, uint8_t, vec4, vec4_set, vec4_load, vec4_store, vec4_add, vec4_sub, vec4_sub_widened)
BLOCK(block_8, uint8_t, vec, vec_set, vec_load, vec_store, vec_add, vec_sub, vec_sub_widened)
BLOCK(block_8_wide, uint16_t, vec, vec_set, vec_load, vec_store, vec_add, vec_sub, vec_sub_costs)

void STAD_TIER(stad_block_row)(const stad_block_job *job, int16_t *block)
{
    int32_t d = 0;
    for (; !job->wide && d + 32 <= job->disparities; d += 32)
        block_32(job, d, block + d);
    for (; d < job->disparities; d += 8) {
        if (job->wide)
            block_8_wide(job, d, block + d);
        else
            block_8(job, d, block + d);
    }
}
