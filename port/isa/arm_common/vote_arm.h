/* SPDX-License-Identifier: MIT
 * port/isa/arm_common/vote_arm.h - a winner's vote for the right view. Runs of them stay scalar: votes may meet. */
#ifndef STAD_VOTE_ARM_H
#define STAD_VOTE_ARM_H

#include "kernel/kernel.h"

/* x: the winner's column of the image. */
static inline __attribute__((always_inline)) void vote(const stad_select_job *job, const stad_best *best, int32_t x)
{
    const int32_t disparity = best->index + job->min_disparity, right = x - disparity;
    if ((uint32_t)right < (uint32_t)job->width && best->least < job->vote_cost[right]) {
        job->vote_cost[right] = best->least;
        job->vote_disp[right] = (int16_t)disparity;
    }
}

#endif
