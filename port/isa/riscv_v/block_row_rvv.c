/* SPDX-License-Identifier: MIT
 * cost -> [BLOCK] -> path
 * port/isa/riscv_v/block_row_rvv.c - a row of block costs moved by a row. */
#include <riscv_vector.h>

#include "kernel/kernel.h"
#include "../common/block_zone.h"

#define RVV_INLINE static inline __attribute__((always_inline))

/* What comes in with `in` and leaves with `out`, modulo 65536. */
RVV_INLINE vuint16m8_t change_u8(const uint8_t *in, const uint8_t *out, size_t vl)
{
    return __riscv_vwsubu_vv_u16m8(__riscv_vle8_v_u8m4(in, vl), __riscv_vle8_v_u8m4(out, vl), vl);
}

RVV_INLINE vuint16m8_t change_u16(const uint16_t *in, const uint16_t *out, size_t vl)
{
    return __riscv_vsub_vv_u16m8(__riscv_vle16_v_u16m8(in, vl), __riscv_vle16_v_u16m8(out, vl), vl);
}

/* The whole row of the strip's disparities, from the one at `at` on: hs(in) - hs(out) stays in registers. */
#define BLOCK(name, cost_t, change)                                                                                \
    static void name(const stad_block_job *job, size_t at, size_t vl, uint16_t *to)                                \
    {                                                                                                              \
        const cost_t *in = (const cost_t *)job->in + at, *out = (const cost_t *)job->out + at;                     \
        const cost_t *in_left = in, *out_left = out;                                                               \
        const ptrdiff_t n = job->disparities;                                                                      \
        const int32_t r = job->radius;                                                                             \
        vuint16m8_t hs = __riscv_vmv_v_x_u16m8(0, vl);                                                             \
        for (int32_t x = -r - 1; x < r; x++)                                                                       \
            hs = __riscv_vadd_vv_u16m8(hs, change(in + block_column(job, x), out + block_column(job, x), vl), vl); \
        in += block_column(job, r);                                                                                \
        out += block_column(job, r);                                                                               \
        for (int32_t x = 0; x < job->columns;) {                                                                   \
            const block_zone zone = block_zone_at(job, x);                                                         \
            for (; x < zone.end; x++, to += n) {                                                                   \
                hs = __riscv_vadd_vv_u16m8(hs, change(in, out, vl), vl);                                           \
                hs = __riscv_vsub_vv_u16m8(hs, change(in_left, out_left, vl), vl);                                 \
                __riscv_vse16_v_u16m8(to, __riscv_vadd_vv_u16m8(__riscv_vle16_v_u16m8(to, vl), hs, vl), vl);       \
                in += zone.plus;                                                                                   \
                out += zone.plus;                                                                                  \
                in_left += zone.minus;                                                                             \
                out_left += zone.minus;                                                                            \
            }                                                                                                      \
        }                                                                                                          \
    }

BLOCK(block_strip_u8, uint8_t, change_u8)
BLOCK(block_strip_u16, uint16_t, change_u16)

void stad_block_row_rvv(const stad_block_job *job, int16_t *block)
{
    const size_t n = (size_t)job->disparities;
    for (size_t at = 0, vl; at < n; at += vl) {
        vl = __riscv_vsetvl_e16m8(n - at);
        if (job->wide)
            block_strip_u16(job, at, vl, (uint16_t *)block + at);
        else
            block_strip_u8(job, at, vl, (uint16_t *)block + at);
    }
}
