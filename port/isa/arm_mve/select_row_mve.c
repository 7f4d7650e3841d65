/* SPDX-License-Identifier: MIT
 * refine -> [SELECT] -> check
 * port/isa/arm_mve/select_row_mve.c - uniqueness of eight winners at once, and their votes.
 *
 * Confidences are left to C. Bounds: costs are int16, so every product with 100 fits int32. */
#include <arm_mve.h>

#include "kernel/kernel.h"

/* Lane by lane: a * p < b * q. The halves are the even and the odd lanes. */
static inline mve_pred16_t is_less(int16x8_t a, int16_t p, int16x8_t b, int16_t q)
{
    const int16x8_t by_p = vdupq_n_s16(p), by_q = vdupq_n_s16(q);
    const mve_pred16_t even = vcmpltq_s32(vmullbq_int_s16(a, by_p), vmullbq_int_s16(b, by_q));
    const mve_pred16_t odd = vcmpltq_s32(vmulltq_int_s16(a, by_p), vmulltq_int_s16(b, by_q));
    return (mve_pred16_t)((even & 0x3333) | (odd & 0xCCCC));
}

/* Votes of the eight winners from column x on that `may`; of equals for a right pixel the one furthest right counts.
 *
 * Winners may meet at a right pixel, and which of several scattered values stays there is not to be relied on: what is
 * read back tells, because winners that meet differ in disparity. The others try again against it. */
static inline void vote(const stad_select_job *job, int16x8_t index, int16x8_t least, int32_t x, mve_pred16_t may)
{
    const int16x8_t disparity = vaddq_n_s16(index, (int16_t)job->min_disparity);
    const int16x8_t column = vaddq_n_s16(vreinterpretq_s16_u16(vidupq_n_u16(0, 1)), (int16_t)x);
    const uint16x8_t right = vreinterpretq_u16_s16(vsubq_s16(column, disparity));
    may = vcmphiq_m_u16(vdupq_n_u16((uint16_t)job->width), right, may);
    int16x8_t held = vldrhq_gather_shifted_offset_z_s16(job->vote_cost, right, may);
    may = vcmpltq_m_s16(least, held, may);
    while (may != 0) {
        vstrhq_scatter_shifted_offset_p_s16(job->vote_disp, right, disparity, may);
        const int16x8_t stayed = vldrhq_gather_shifted_offset_z_s16(job->vote_disp, right, may);
        const mve_pred16_t lost = vcmpneq_m_s16(stayed, disparity, may);
        vstrhq_scatter_shifted_offset_p_s16(job->vote_cost, right, least, (mve_pred16_t)(may & ~lost));
        if (lost == 0)
            return;
        held = vldrhq_gather_shifted_offset_z_s16(job->vote_cost, right, lost);
        may = vcmpltq_m_s16(least, held, lost) | vcmpgtq_m_s16(disparity, stayed, vcmpeqq_m_s16(least, held, lost));
    }
}

/* 3WAY rejects r < floor(100 l / rest) + 1, wrapped to int16: r * rest <= 100 * l where l >= 0 and nothing wraps. */
static inline int floor_rule_is_plain(int16x8_t least, int16_t rest)
{
    return vcmpltq_n_s16(least, 0) == 0 && is_less(least, 100, vdupq_n_s16(INT16_MAX), rest) == 0xFFFF;
}

static inline mve_pred16_t ambiguous_of(const stad_select_job *job, int16x8_t least, int16x8_t runner_up, int16_t rest)
{
    if (!job->floor_rule)
        return is_less(runner_up, rest, least, 100);
    return job->uniqueness_ratio > 0 ? (mve_pred16_t)~is_less(least, 100, runner_up, rest) : 0;
}

/* Eight winners from the i-th on, by C. */
static __attribute__((noinline)) void take_by_c(stad_select_job *job, int32_t i)
{
    stad_select_job part = *job;
    part.best += i;
    part.fine += i;
    part.x += i;
    part.count = 8;
    stad_select_row_c(&part);
    job->firm = part.firm;
    job->rejected = part.rejected;
}

void stad_select_row_mve(stad_select_job *shared)
{
    stad_select_job job = *shared;
    const int16_t rest = (int16_t)(100 - job.uniqueness_ratio), shift = (int16_t)(16 * job.min_disparity);
    const uint16x8_t third = vmulq_n_u16(vidupq_n_u16(0, 1), 3); /* a stad_best is three cells */
    const int16x8_t one = vdupq_n_s16(1);
    for (; !job.confidence && job.count >= 8; job.count -= 8) {
        const int32_t i = job.count - 8;
        const stad_best *best = job.best + i;
        const int16x8_t least = vldrhq_gather_shifted_offset_s16(&best->least, third);
        if (job.floor_rule && !floor_rule_is_plain(least, rest)) {
            take_by_c(&job, i);
            continue;
        }
        const int16x8_t runner_up = vldrhq_gather_shifted_offset_s16(&best->runner_up, third);
        const mve_pred16_t weak = is_less(runner_up, 75, least, 100), ambiguous = ambiguous_of(&job, least, runner_up, rest);
        job.firm = vaddvaq_p_s16(job.firm, one, (mve_pred16_t)~weak);
        job.rejected = vaddvaq_p_s16(job.rejected, one, ambiguous);
        vst1q_p_s16(job.disp + job.x + i, vaddq_n_s16(vld1q_s16(job.fine + i), shift), (mve_pred16_t)~ambiguous);
        vote(&job, vldrhq_gather_shifted_offset_s16(&best->index, third), least, job.x + i, (mve_pred16_t)~ambiguous);
    }
    stad_select_row_c(&job);
    shared->firm = job.firm;
    shared->rejected = job.rejected;
}
