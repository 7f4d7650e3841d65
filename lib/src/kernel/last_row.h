/* SPDX-License-Identifier: MIT
 * path -> [LAST] -> refine
 * kernel/last_row.h - the last path of a run, and its winners, by the two kernels that are bound. Inline: it is called once. */
#ifndef STAD_KERNEL_LAST_ROW_H
#define STAD_KERNEL_LAST_ROW_H

#include "kernel/kernel.h"

static inline void stad_last_row_c(const stad_path_job *job, stad_lane *lane, int three_way, stad_best *best)
{
    const int16_t *total = job->total - (ptrdiff_t)(job->count - 1) * job->disparities;
    if (lane)
        stad_path_row(job, lane, 1);
    if (three_way)
        stad_best_row_3way(total, job->count, job->disparities, best);
    else
        stad_best_row(total, job->count, job->disparities, best);
}

#endif
