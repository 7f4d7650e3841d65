/* SPDX-License-Identifier: MIT
 * select -> [CHECK] -> median
 * kernel/check_row.c - left-right consistency of a row.
 *
 * A pixel fails when both right pixels its sub-pixel disparity may mean disagree with it. A right pixel nobody voted for
 * holds (min_disparity - 1) * 16 where others hold a whole disparity: once min_disparity >= 2 that counts as a wrong one
 * (SPEC 8, a quirk that must be kept). */
#include "kernel/kernel.h"
#include "base/arith.h"

static int disagrees(const stad_check_job *job, int32_t x, int32_t disparity)
{
    const int32_t right = x - disparity;
    if (right < 0 || right >= job->width)
        return 0;
    const int32_t other = job->vote_disp[right];
    return other >= job->min_disparity && abs_i32(other - disparity) > job->max_diff;
}

int32_t stad_check_row_c(const stad_check_job *job)
{
    STAD_ASSERT(job->x0 >= 0 && job->x1 <= job->width);
    const int16_t none = narrow_i16((job->min_disparity - 1) * 16);
    int32_t rejected = 0;
    /*@ loop invariant job->x0 <= x && (x <= job->x1 || x == job->x0) && 0 <= rejected <= x - job->x0;
        loop assigns x, rejected, job->disp[job->x0 .. job->x1 - 1]; loop variant job->x1 - x; */
    for (int32_t x = job->x0; x < job->x1; x++) {
        const int32_t v = job->disp[x];
        if (v == none)
            continue;
        if (disagrees(job, x, v >> 4) && disagrees(job, x, (v + 15) >> 4)) {
            job->disp[x] = none;
            rejected++;
        }
    }
    return rejected;
}
