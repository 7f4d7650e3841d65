/* SPDX-License-Identifier: MIT
 * slide -> [PATH] -> best
 * kernel/path_row_u8.c - path costs kept in a byte, for p2 <= 255 and a C that cannot saturate.
 *
 * Only min(L - m, p2) of the previous pixel enters SPEC 5, since everything is clipped at m + p2: with q for it,
 *     L[d] = C[d] - p2 + min(q[d], q[d-1] + p1, q[d+1] + p1, p2)
 * Bounds: q <= 255; p1 < p2 <= 255, so the sums stay below 511 in int; C - p2 >= 0, so L >= 0. L itself goes to a column of
 * the total's scratch only in registers: it is formed twice, once for its least value and once to be stored. */
#include "kernel/kernel.h"
#include "base/arith.h"

static inline int16_t step_cost(const uint8_t *q, int16_t block, int32_t p1, int32_t p2)
{
    const int32_t side = min_i32(q[-1], q[1]) + p1;
    return (int16_t)(block - p2 + min_i32(min_i32(q[0], side), p2));
}

static void step_lane(const stad_path_job *job, stad_lane_u8 *lane, const int16_t *block, int16_t *total, int fresh)
{
    const int32_t to = lane->write, from = to + 1 == lane->slots ? 0 : to + 1, n = job->disparities;
    const uint8_t *restrict q = lane->cost + (ptrdiff_t)from * job->stride;
    uint8_t *restrict next = lane->cost + (ptrdiff_t)to * job->stride;
    const int32_t p1 = job->p1, p2 = job->p2;
    int32_t least = STAD_COST_MAX;
    for (int32_t d = 0; d < n; d++)
        least = min_i32(least, step_cost(q + d, block[d], p1, p2));
    for (int32_t d = 0; d < n; d++)
        next[d] = (uint8_t)min_i32(step_cost(q + d, block[d], p1, p2) - least, p2);
    for (int32_t d = 0; total && d < n; d++)
        total[d] = sat_i16((fresh ? 0 : total[d]) + step_cost(q + d, block[d], p1, p2));
    lane->write = from;
}

void stad_path_row_u8_c(const stad_path_job *job, stad_lane_u8 *lanes, int32_t lane_count)
{
    STAD_ASSERT(job->p1 > 0 && job->p1 < job->p2 && job->p2 <= 255 && (job->step == 1 || job->step == -1));
    const ptrdiff_t step = (ptrdiff_t)job->step * job->disparities;
    for (int32_t i = 0; i < job->count; i++) {
        int16_t *total = job->total ? job->total + i * step : NULL;
        for (int32_t k = 0; k < lane_count; k++)
            step_lane(job, &lanes[k], job->block + i * step, total, job->fresh && k == 0);
    }
}
