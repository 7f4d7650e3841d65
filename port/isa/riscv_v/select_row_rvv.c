/* SPDX-License-Identifier: MIT
 * refine -> [SELECT] -> check
 * port/isa/riscv_v/select_row_rvv.c - uniqueness of a run of winners at once, and their votes.
 *
 * Confidences are left to C, as are rows wider than 16383 columns: twice a column must fit 16 bits. Bounds: costs are int16, so
 * every product with 100 fits int32. */
#include <riscv_vector.h>

#include "kernel/kernel.h"

/* Votes of the winners from column x on that `may`; of equals for a right pixel the one furthest right counts.
 *
 * Winners may meet at a right pixel. Which one's disparity stayed there is read back: winners that meet differ in it. The
 * others try again against that one. */
static inline void vote(const stad_select_job *job, vint16m2_t index, vint16m2_t least, int32_t x, vbool8_t may, size_t vl)
{
    const vint16m2_t disparity = __riscv_vadd_vx_i16m2(index, (int16_t)job->min_disparity, vl);
    const vint16m2_t column = __riscv_vadd_vx_i16m2(__riscv_vreinterpret_v_u16m2_i16m2(__riscv_vid_v_u16m2(vl)), (int16_t)x, vl);
    const vuint16m2_t right = __riscv_vreinterpret_v_i16m2_u16m2(__riscv_vsub_vv_i16m2(column, disparity, vl));
    const vuint16m2_t at = __riscv_vsll_vx_u16m2(right, 1, vl);
    may = __riscv_vmand_mm_b8(may, __riscv_vmsltu_vx_u16m2_b8(right, (uint16_t)job->width, vl), vl);
    vint16m2_t held = __riscv_vluxei16_v_i16m2_m(may, job->vote_cost, at, vl);
    may = __riscv_vmand_mm_b8(may, __riscv_vmslt_vv_i16m2_b8(least, held, vl), vl);
    while (__riscv_vcpop_m_b8(may, vl) != 0) {
        __riscv_vsuxei16_v_i16m2_m(may, job->vote_disp, at, disparity, vl);
        const vint16m2_t stayed = __riscv_vluxei16_v_i16m2_m(may, job->vote_disp, at, vl);
        const vbool8_t lost = __riscv_vmand_mm_b8(may, __riscv_vmsne_vv_i16m2_b8(stayed, disparity, vl), vl);
        __riscv_vsuxei16_v_i16m2_m(__riscv_vmandn_mm_b8(may, lost, vl), job->vote_cost, at, least, vl);
        if (__riscv_vcpop_m_b8(lost, vl) == 0)
            return;
        held = __riscv_vluxei16_v_i16m2_m(lost, job->vote_cost, at, vl);
        const vbool8_t equal =
            __riscv_vmand_mm_b8(__riscv_vmseq_vv_i16m2_b8(least, held, vl), __riscv_vmsgt_vv_i16m2_b8(disparity, stayed, vl), vl);
        may = __riscv_vmand_mm_b8(lost, __riscv_vmor_mm_b8(__riscv_vmslt_vv_i16m2_b8(least, held, vl), equal, vl), vl);
    }
}

/* Which winners have a rival that is nearly as good; by_100: their costs times 100. */
static inline vbool8_t ambiguous_of(const stad_select_job *job, vint32m4_t by_100, vint16m2_t runner_up, size_t vl)
{
    const int16_t rest = (int16_t)(100 - job->uniqueness_ratio);
    if (!job->floor_rule)
        return __riscv_vmslt_vv_i32m4_b8(__riscv_vwmul_vx_i32m4(runner_up, rest, vl), by_100, vl);
    if (job->uniqueness_ratio <= 0)
        return __riscv_vmclr_m_b8(vl);
    const vint32m4_t limit = __riscv_vadd_vx_i32m4(__riscv_vdiv_vx_i32m4(by_100, rest, vl), 1, vl);
    return __riscv_vmslt_vv_i16m2_b8(runner_up, __riscv_vncvt_x_x_w_i16m2(limit, vl), vl);
}

void stad_select_row_rvv(stad_select_job *shared)
{
    const stad_select_job job = *shared; /* the rows written to might alias it */
    const int16_t shift = (int16_t)(16 * job.min_disparity);
    int32_t firm = 0, rejected = 0;
    if (job.confidence || job.width > 16383) {
        stad_select_row_c(shared);
        return;
    }
    for (size_t left = (size_t)job.count, vl; left > 0; left -= vl) {
        vl = __riscv_vsetvl_e16m2(left);
        const size_t i = left - vl;
        const vint16m2_t least = __riscv_vlse16_v_i16m2(&job.best[i].least, sizeof *job.best, vl);
        const vint16m2_t runner_up = __riscv_vlse16_v_i16m2(&job.best[i].runner_up, sizeof *job.best, vl);
        const vint32m4_t by_100 = __riscv_vwmul_vx_i32m4(least, 100, vl);
        const vbool8_t weak = __riscv_vmslt_vv_i32m4_b8(__riscv_vwmul_vx_i32m4(runner_up, 75, vl), by_100, vl);
        const vbool8_t clear = __riscv_vmnot_m_b8(ambiguous_of(&job, by_100, runner_up, vl), vl);
        const int32_t x = job.x + (int32_t)i, accepted = (int32_t)__riscv_vcpop_m_b8(clear, vl);
        firm += (int32_t)(vl - __riscv_vcpop_m_b8(weak, vl));
        rejected += (int32_t)vl - accepted;
        __riscv_vse16_v_i16m2_m(clear, job.disp + x, __riscv_vadd_vx_i16m2(__riscv_vle16_v_i16m2(job.fine + i, vl), shift, vl),
                                vl);
        vote(&job, __riscv_vlse16_v_i16m2(&job.best[i].index, sizeof *job.best, vl), least, x, clear, vl);
    }
    shared->firm = job.firm + firm;
    shared->rejected = job.rejected + rejected;
}
