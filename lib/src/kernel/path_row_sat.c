/* SPDX-License-Identifier: MIT
 * box -> [PATH] -> best
 * kernel/path_row_sat.c - path costs with every int16 saturation of SPEC 5, in its order. */
#include "kernel/kernel.h"
#include "base/arith.h"

static int16_t step_costs(const stad_path_job *job, const int16_t *p, int16_t delta, const int16_t *block, int16_t *path)
{
    const int16_t p1 = narrow_i16(job->p1); /* at most 32766 by stad_params_check() */
    int16_t least = STAD_COST_MAX;
    for (int32_t d = 0; d < job->disparities; d++) {
        const int16_t side = min_i16(add_sat_i16(p[d - 1], p1), add_sat_i16(p[d + 1], p1));
        const int16_t t = min_i16(min_i16(p[d], side), delta);
        path[d] = add_sat_i16(sub_sat_i16(t, delta), block[d]);
        least = min_i16(least, path[d]);
    }
    return least;
}

static void step_lane(const stad_path_job *job, stad_lane *lane, const int16_t *block, int16_t *total, int fresh)
{
    const int32_t to = lane->write, from = to + 1 == lane->slots ? 0 : to + 1;
    const int16_t delta = narrow_i16(lane->least[from] + job->p2);
    int16_t *path = lane->cost + (ptrdiff_t)to * job->stride;
    lane->least[to] = step_costs(job, lane->cost + (ptrdiff_t)from * job->stride, delta, block, path);
    lane->write = from;
    for (int32_t d = 0; total && d < job->disparities; d++)
        total[d] = fresh ? path[d] : add_sat_i16(total[d], path[d]);
}

void stad_path_row_sat_c(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
{
    STAD_ASSERT(job->p1 > 0 && job->p1 < job->p2 && (job->step == 1 || job->step == -1) && lane_count > 0);
    const ptrdiff_t step = (ptrdiff_t)job->step * job->disparities;
    for (int32_t i = 0; i < job->count; i++) {
        int16_t *total = job->total ? job->total + i * step : NULL;
        for (int32_t k = 0; k < lane_count; k++)
            step_lane(job, &lanes[k], job->block + i * step, total, job->fresh && k == 0);
    }
}
