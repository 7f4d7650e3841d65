/* SPDX-License-Identifier: MIT
 * path -> [BEST] -> select
 * port/isa/riscv_v/best_row_rvv.c - winner and runner-up, a strip of disparities at once. */
#include <riscv_vector.h>

#include "kernel/kernel.h"

#define INLINE static inline __attribute__((always_inline))

INLINE int16_t reduced(vint16m4_t v, int16_t least, size_t vl)
{
    return __riscv_vmv_x_s_i16m1_i16(__riscv_vredmin_vs_i16m4_i16m1(v, __riscv_vmv_s_x_i16m1(least, 1), vl));
}

/* The least of a strip's costs and `least`, but for the winner and its neighbours: d - (index - 1), read as unsigned, is at
 * most 2 at them alone. */
INLINE int16_t rival_of(vint16m4_t cost, int16_t least, long first, long index, size_t vl)
{
    const vuint16m4_t from = __riscv_vadd_vx_u16m4(__riscv_vid_v_u16m4(vl), (uint16_t)(first + 1 - index), vl);
    const vbool4_t near = __riscv_vmsleu_vx_u16m4_b4(from, 2, vl);
    return reduced(__riscv_vmerge_vxm_i16m4(cost, STAD_COST_MAX, near, vl), least, vl);
}

/* All disparities in one strip; *ties: how many hold the least. */
INLINE stad_best best_of_strip(const int16_t *total, size_t vl, int ties_count, unsigned long *ties)
{
    const vint16m4_t cost = __riscv_vle16_v_i16m4(total, vl);
    const int16_t least = reduced(cost, STAD_COST_MAX, vl);
    const vbool4_t same = __riscv_vmseq_vx_i16m4_b4(cost, least, vl);
    const long index = !ties_count && least == STAD_COST_MAX ? -1 : __riscv_vfirst_m_b4(same, vl);
    stad_best best;
    if (ties_count)
        *ties = __riscv_vcpop_m_b4(same, vl);
    best.least = least;
    best.index = (int16_t)index;
    best.runner_up = rival_of(cost, STAD_COST_MAX, 0, index, vl);
    return best;
}

/* Several strips. */
INLINE stad_best best_of_strips(const int16_t *total, size_t n, int ties_count, unsigned long *ties)
{
    int16_t least = STAD_COST_MAX, rival = STAD_COST_MAX;
    long index = -1;
    stad_best best;
    for (size_t at = 0, vl; at < n; at += vl) {
        vl = __riscv_vsetvl_e16m4(n - at);
        least = reduced(__riscv_vle16_v_i16m4(total + at, vl), least, vl);
    }
    *ties = 0;
    for (size_t at = 0, vl; at < n && (ties_count || least < STAD_COST_MAX); at += vl) {
        vl = __riscv_vsetvl_e16m4(n - at);
        const vbool4_t same = __riscv_vmseq_vx_i16m4_b4(__riscv_vle16_v_i16m4(total + at, vl), least, vl);
        const long here = __riscv_vfirst_m_b4(same, vl);
        *ties += __riscv_vcpop_m_b4(same, vl);
        if (index < 0 && here >= 0)
            index = (long)at + here;
    }
    for (size_t at = 0, vl; at < n; at += vl) {
        vl = __riscv_vsetvl_e16m4(n - at);
        rival = rival_of(__riscv_vle16_v_i16m4(total + at, vl), rival, (long)at, index, vl);
    }
    best.least = least;
    best.index = (int16_t)index;
    best.runner_up = rival;
    return best;
}

void stad_best_row_rvv(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    const size_t n = (size_t)disparities, vl = __riscv_vsetvl_e16m4(n);
    unsigned long ties = 0;
    if (vl == n)
        for (int32_t i = 0; i < count; i++, total += n)
            best[i] = best_of_strip(total, vl, 0, &ties);
    else
        for (int32_t i = 0; i < count; i++, total += n)
            best[i] = best_of_strips(total, n, 0, &ties);
}

/* SPEC 8's rule for 3WAY differs from the plain one only in ties. */
void stad_best_row_3way_rvv(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    const size_t n = (size_t)disparities, vl = __riscv_vsetvl_e16m4(n);
    unsigned long ties = 0;
    for (int32_t i = 0; i < count; i++, total += n) {
        best[i] = vl == n ? best_of_strip(total, vl, 1, &ties) : best_of_strips(total, n, 1, &ties);
        if (ties > 1)
            stad_best_row_3way_c(total, 1, disparities, &best[i]);
    }
}
