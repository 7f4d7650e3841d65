/* SPDX-License-Identifier: MIT
 * select -> [CHECK] -> median
 * port/isa/arm_mve/check_row_mve.c - left-right consistency of eight pixels at once, by gathers.
 *
 * Bounds: columns and disparities of pixels fit int16; a right pixel nobody voted for may hold anything, so its distance
 * saturates. */
#include <arm_mve.h>

#include "kernel/kernel.h"

/* Which of the right pixels at these disparities say otherwise. */
static inline mve_pred16_t disagrees(const stad_check_job *job, int16x8_t x, int16x8_t disparity)
{
    const uint16x8_t right = vreinterpretq_u16_s16(vsubq_s16(x, disparity));
    const mve_pred16_t seen = vcmphiq_u16(vdupq_n_u16((uint16_t)job->width), right);
    const int16x8_t other = vldrhq_gather_shifted_offset_z_s16(job->vote_disp, right, seen);
    const int16x8_t distance = vqabsq_s16(vqsubq_s16(other, disparity));
    const mve_pred16_t known = vcmpgeq_n_s16(other, (int16_t)job->min_disparity);
    return (mve_pred16_t)(seen & known & vcmpgtq_n_s16(distance, (int16_t)job->max_diff));
}

int32_t stad_check_row_mve(const stad_check_job *shared)
{
    stad_check_job job = *shared;
    const int16_t none = (int16_t)((job.min_disparity - 1) * 16);
    const int16x8_t step = vreinterpretq_s16_u16(vidupq_n_u16(0, 1)), one = vdupq_n_s16(1), nones = vdupq_n_s16(none);
    int32_t rejected = 0;
    for (; job.max_diff < INT16_MAX && job.x1 - job.x0 >= 8; job.x0 += 8) {
        int16_t *disp = job.disp + job.x0;
        const int16x8_t v = vld1q_s16(disp), x = vaddq_n_s16(step, (int16_t)job.x0);
        const mve_pred16_t wrong = disagrees(&job, x, vshrq_n_s16(v, 4)) & disagrees(&job, x, vshrq_n_s16(vaddq_n_s16(v, 15), 4));
        const mve_pred16_t gone = (mve_pred16_t)(wrong & vcmpneq_n_s16(v, none));
        vst1q_p_s16(disp, nones, gone);
        rejected = vaddvaq_p_s16(rejected, one, gone);
    }
    return rejected + stad_check_row_c(&job);
}
