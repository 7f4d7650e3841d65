/* SPDX-License-Identifier: MIT
 * path -> [BEST] -> select
 * port/isa/riscv_v/best_row_rvv.c - winner and runner-up, a strip of disparities at once. */
#include <riscv_vector.h>

#include "kernel/kernel.h"

static inline int16_t reduced(vint16m4_t v, int16_t least, size_t vl)
{
    return __riscv_vmv_x_s_i16m1_i16(__riscv_vredmin_vs_i16m4_i16m1(v, __riscv_vmv_s_x_i16m1(least, 1), vl));
}

static inline int16_t least_of(const int16_t *total, size_t n)
{
    int16_t least = STAD_COST_MAX;
    for (size_t at = 0, vl; at < n; at += vl) {
        vl = __riscv_vsetvl_e16m4(n - at);
        least = reduced(__riscv_vle16_v_i16m4(total + at, vl), least, vl);
    }
    return least;
}

/* The smallest d with this value, and in *ties how many there are. */
static inline int16_t first_with(const int16_t *total, size_t n, int16_t value, unsigned long *ties)
{
    long first = -1;
    *ties = 0;
    for (size_t at = 0, vl; at < n; at += vl) {
        vl = __riscv_vsetvl_e16m4(n - at);
        const vbool4_t same = __riscv_vmseq_vx_i16m4_b4(__riscv_vle16_v_i16m4(total + at, vl), value, vl);
        const long here = __riscv_vfirst_m_b4(same, vl);
        *ties += __riscv_vcpop_m_b4(same, vl);
        if (first < 0 && here >= 0)
            first = (long)at + here;
    }
    return (int16_t)first;
}

/* d - (index - 1), read as unsigned, is at most 2 at the winner and its neighbours alone: they become the largest cost. */
static inline int16_t runner_up(const int16_t *total, size_t n, int16_t index)
{
    int16_t least = STAD_COST_MAX;
    for (size_t at = 0, vl; at < n; at += vl) {
        vl = __riscv_vsetvl_e16m4(n - at);
        const vuint16m4_t from = __riscv_vadd_vx_u16m4(__riscv_vid_v_u16m4(vl), (uint16_t)((long)at + 1 - index), vl);
        const vbool4_t near = __riscv_vmsleu_vx_u16m4_b4(from, 2, vl);
        const vint16m4_t cost = __riscv_vle16_v_i16m4(total + at, vl);
        least = reduced(__riscv_vmerge_vxm_i16m4(cost, STAD_COST_MAX, near, vl), least, vl);
    }
    return least;
}

void stad_best_row_rvv(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    const size_t n = (size_t)disparities;
    unsigned long ties;
    for (int32_t i = 0; i < count; i++, total += n) {
        best[i].least = least_of(total, n);
        best[i].index = (int16_t)(best[i].least < STAD_COST_MAX ? first_with(total, n, best[i].least, &ties) : -1);
        best[i].runner_up = runner_up(total, n, best[i].index);
    }
}

/* SPEC 8's rule for 3WAY differs from the plain one only in ties. */
void stad_best_row_3way_rvv(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    const size_t n = (size_t)disparities;
    unsigned long ties;
    for (int32_t i = 0; i < count; i++, total += n) {
        best[i].least = least_of(total, n);
        best[i].index = first_with(total, n, best[i].least, &ties);
        if (ties > 1)
            stad_best_row_3way_c(total, 1, disparities, &best[i]);
        else
            best[i].runner_up = runner_up(total, n, best[i].index);
    }
}
