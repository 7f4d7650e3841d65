/* SPDX-License-Identifier: MIT
 * refine -> [SELECT] -> check
 * port/isa/arm_neon/select_row_neon.c - uniqueness of eight winners at once; votes one by one, because they may meet.
 *
 * 3WAY's rule and confidences are left to C. Bounds: costs are int16, so every product with 100 fits int32. */
#include <arm_neon.h>

#include "kernel/kernel.h"

/* Lane by lane: a * p < b * q. */
static inline uint16x8_t is_less(int16x8_t a, int16_t p, int16x8_t b, int16_t q)
{
    const uint32x4_t low = vcltq_s32(vmull_n_s16(vget_low_s16(a), p), vmull_n_s16(vget_low_s16(b), q));
    const uint32x4_t high = vcltq_s32(vmull_n_s16(vget_high_s16(a), p), vmull_n_s16(vget_high_s16(b), q));
    return vcombine_u16(vmovn_u32(low), vmovn_u32(high));
}

static inline int32_t sum_of(int16x8_t v)
{
    const int64x2_t sum = vpaddlq_s32(vpaddlq_s16(v));
    return (int32_t)(vgetq_lane_s64(sum, 0) + vgetq_lane_s64(sum, 1));
}

/* A winner's vote for the right view; x: its column of the image. */
static inline __attribute__((always_inline)) void vote(const stad_select_job *job, const stad_best *best, int32_t x)
{
    const int32_t disparity = best->index + job->min_disparity, right = x - disparity;
    if ((uint32_t)right < (uint32_t)job->width && best->least < job->vote_cost[right]) {
        job->vote_cost[right] = best->least;
        job->vote_disp[right] = (int16_t)disparity;
    }
}

void stad_select_row_neon(stad_select_job *shared)
{
    stad_select_job job = *shared;
    const int16_t rest = (int16_t)(100 - job.uniqueness_ratio), shift = (int16_t)(16 * job.min_disparity);
    int16x8_t firm = vdupq_n_s16(0), rejected = firm;
    for (; !job.floor_rule && !job.confidence && job.count >= 8; job.count -= 8) {
        const int32_t i = job.count - 8;
        const int16x8x3_t best = vld3q_s16(&job.best[i].index); /* index, least, runner_up */
        const uint16x8_t weak = is_less(best.val[2], 75, best.val[1], 100);
        const uint16x8_t ambiguous = is_less(best.val[2], rest, best.val[1], 100);
        int16_t *disp = job.disp + job.x + i;
        const int16x8_t found = vaddq_s16(vld1q_s16(job.fine + i), vdupq_n_s16(shift));
        firm = vaddq_s16(firm, vaddq_s16(vdupq_n_s16(1), vreinterpretq_s16_u16(weak)));
        rejected = vsubq_s16(rejected, vreinterpretq_s16_u16(ambiguous));
        vst1q_s16(disp, vbslq_s16(ambiguous, vld1q_s16(disp), found));
        const uint64_t bytes = vget_lane_u64(vreinterpret_u64_u8(vmovn_u16(ambiguous)), 0); /* one a pixel */
#pragma GCC unroll 8
        for (int32_t k = 7; k >= 0; k--)
            if ((bytes >> (8 * k) & 1) == 0)
                vote(&job, job.best + i + k, job.x + i + k);
    }
    stad_select_row_c(&job);
    shared->firm = job.firm + sum_of(firm);
    shared->rejected = job.rejected + sum_of(rejected);
}
