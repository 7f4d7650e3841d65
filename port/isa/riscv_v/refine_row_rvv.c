/* SPDX-License-Identifier: MIT
 * best -> [REFINE] -> select; select -> [CHECK] -> median
 * port/isa/riscv_v/refine_row_rvv.c - sub-pixel places, and the left-right check, by gathers. */
#include <riscv_vector.h>

#include "kernel/kernel.h"

/* Bound: an index of -1 belongs to no vector element that is loaded from; differences of three costs fit 32 bits. */
void stad_refine_row_rvv(const int16_t *total, const stad_best *best, int32_t count, int32_t disparities, int16_t *fine)
{
    const uint32_t column_bytes = 2 * (uint32_t)disparities;
    for (size_t left = (size_t)count, vl; left > 0; left -= vl, best += vl, fine += vl, total += vl * (size_t)disparities) {
        vl = __riscv_vsetvl_e16m2(left);
        const vint16m2_t index = __riscv_vlse16_v_i16m2(&best->index, sizeof *best, vl);
        const vint16m2_t here = __riscv_vlse16_v_i16m2(&best->least, sizeof *best, vl);
        const vbool8_t inside = __riscv_vmand_mm_b8(__riscv_vmsgt_vx_i16m2_b8(index, 0, vl),
                                                    __riscv_vmslt_vx_i16m2_b8(index, (int16_t)(disparities - 1), vl), vl);
        const vuint32m4_t column = __riscv_vmul_vx_u32m4(__riscv_vid_v_u32m4(vl), column_bytes, vl);
        const vuint32m4_t at =
            __riscv_vadd_vv_u32m4(column, __riscv_vreinterpret_v_i32m4_u32m4(__riscv_vwmul_vx_i32m4(index, 2, vl)), vl);
        const vint16m2_t zero = __riscv_vmv_v_x_i16m2(0, vl);
        const vint16m2_t before = __riscv_vluxei32_v_i16m2_mu(inside, zero, total - 1, at, vl);
        const vint16m2_t after = __riscv_vluxei32_v_i16m2_mu(inside, zero, total + 1, at, vl);
        const vint32m4_t bend =
            __riscv_vsub_vv_i32m4(__riscv_vwadd_vv_i32m4(before, after, vl), __riscv_vwmul_vx_i32m4(here, 2, vl), vl);
        const vint32m4_t curve = __riscv_vmax_vx_i32m4(bend, 1, vl);
        const vint32m4_t tilt = __riscv_vsll_vx_i32m4(__riscv_vwsub_vv_i32m4(before, after, vl), 4, vl);
        const vint32m4_t move =
            __riscv_vdiv_vv_i32m4(__riscv_vadd_vv_i32m4(tilt, curve, vl), __riscv_vadd_vv_i32m4(curve, curve, vl), vl);
        const vint16m2_t whole = __riscv_vsll_vx_i16m2(index, 4, vl);
        const vint16m2_t moved = __riscv_vadd_vv_i16m2(whole, __riscv_vncvt_x_x_w_i16m2(move, vl), vl);
        __riscv_vse16_v_i16m2(fine, __riscv_vmerge_vvm_i16m2(whole, moved, inside, vl), vl);
    }
}

/* Which of the pixels' right partners at `disparity` say otherwise. x: image columns. */
static inline vbool8_t disagrees(const stad_check_job *job, vint16m2_t x, vint16m2_t disparity, size_t vl)
{
    const vint16m2_t right = __riscv_vsub_vv_i16m2(x, disparity, vl);
    const vbool8_t seen = __riscv_vmsltu_vx_u16m2_b8(__riscv_vreinterpret_v_i16m2_u16m2(right), (uint16_t)job->width, vl);
    const vuint16m2_t at = __riscv_vsll_vx_u16m2(__riscv_vreinterpret_v_i16m2_u16m2(right), 1, vl);
    const vint16m2_t other = __riscv_vluxei16_v_i16m2_mu(seen, right, job->vote_disp, at, vl);
    const vint32m4_t apart = __riscv_vwsub_vv_i32m4(other, disparity, vl);
    const vint32m4_t distance = __riscv_vmax_vv_i32m4(apart, __riscv_vneg_v_i32m4(apart, vl), vl);
    const vbool8_t far = __riscv_vmsgt_vx_i32m4_b8(distance, job->max_diff, vl);
    const vbool8_t known = __riscv_vmsge_vx_i16m2_b8(other, (int16_t)job->min_disparity, vl);
    return __riscv_vmand_mm_b8(seen, __riscv_vmand_mm_b8(known, far, vl), vl);
}

/* Bound: a row of up to 16383 columns, so that twice a column fits 16 bits; wider ones are left to C. */
int32_t stad_check_row_rvv(const stad_check_job *job)
{
    const int16_t none = (int16_t)((job->min_disparity - 1) * 16);
    int32_t rejected = 0;
    if (job->width > 16383)
        return stad_check_row_c(job);
    for (int32_t x0 = job->x0, vl; x0 < job->x1; x0 += vl) {
        const size_t n = __riscv_vsetvl_e16m2((size_t)(job->x1 - x0));
        const vint16m2_t v = __riscv_vle16_v_i16m2(job->disp + x0, n);
        const vint16m2_t x = __riscv_vadd_vx_i16m2(__riscv_vreinterpret_v_u16m2_i16m2(__riscv_vid_v_u16m2(n)), (int16_t)x0, n);
        const vint16m2_t down = __riscv_vsra_vx_i16m2(v, 4, n), up = __riscv_vsra_vx_i16m2(__riscv_vadd_vx_i16m2(v, 15, n), 4, n);
        const vbool8_t wrong = __riscv_vmand_mm_b8(disagrees(job, x, down, n), disagrees(job, x, up, n), n);
        const vbool8_t gone = __riscv_vmand_mm_b8(wrong, __riscv_vmsne_vx_i16m2_b8(v, none, n), n);
        __riscv_vse16_v_i16m2(job->disp + x0, __riscv_vmerge_vxm_i16m2(v, none, gone, n), n);
        rejected += (int32_t)__riscv_vcpop_m_b8(gone, n);
        vl = (int32_t)n;
    }
    return rejected;
}
