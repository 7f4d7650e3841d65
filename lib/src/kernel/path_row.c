/* SPDX-License-Identifier: MIT
 * slide -> [PATH] -> best
 * kernel/path_row.c - path costs of a run of pixels where C cannot saturate.
 *
 * With p the previous pixel's costs, m its least one and C including p2 (SPEC 5):
 *     L[d] = C[d] - (m + p2) + min(p[d], p[d-1] + p1, p[d+1] + p1, m + p2)
 * Bounds: 0 <= p <= 32767, and m <= 32767 - p2 because some d of the previous pixel had L = C - p2; so m + p2 fits, and
 * clipping the neighbours at m + p2 - p1 before p1 is added keeps that sum within m + p2. S saturates at 32767 as the
 * specification's does: every L is >= 0, so the order of the additions does not matter. */
#include "kernel/kernel.h"
#include "base/arith.h"

static void step_costs(const int16_t *restrict p, const int16_t *restrict block, int16_t *restrict path, int32_t n,
                       int16_t delta, int16_t p1)
{
    const int16_t ceiling = narrow_i16(delta - p1);
    for (int32_t d = 0; d < n; d++) {
        const int16_t side = (int16_t)(min_i16(min_i16(p[d - 1], p[d + 1]), ceiling) + p1);
        path[d] = (int16_t)(block[d] + (min_i16(p[d], side) - delta));
    }
}

static int16_t least_of(const int16_t *restrict path, int32_t n)
{
    int16_t least = STAD_COST_MAX;
    for (int32_t d = 0; d < n; d++)
        least = min_i16(least, path[d]);
    return least;
}

static void add_total(int16_t *restrict total, const int16_t *restrict path, int32_t n)
{
    for (int32_t d = 0; d < n; d++) {
        const int16_t room = (int16_t)(STAD_COST_MAX - total[d]);
        total[d] = (int16_t)(total[d] + min_i16(room, path[d]));
    }
}

static void copy_total(int16_t *restrict total, const int16_t *restrict path, int32_t n)
{
    for (int32_t d = 0; d < n; d++)
        total[d] = path[d];
}

static void step_lane(const stad_path_job *job, stad_lane *lane, const int16_t *block, int16_t *total, int fresh)
{
    const int32_t to = lane->write, from = to + 1 == lane->slots ? 0 : to + 1, n = job->disparities;
    int16_t *path = lane->cost + (ptrdiff_t)to * job->stride;
    step_costs(lane->cost + (ptrdiff_t)from * job->stride, block, path, n, narrow_i16(lane->least[from] + job->p2),
               narrow_i16(job->p1));
    lane->least[to] = least_of(path, n);
    lane->write = from;
    if (total && fresh)
        copy_total(total, path, n);
    else if (total)
        add_total(total, path, n);
}

void stad_path_row_c(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
{
    const ptrdiff_t step = (ptrdiff_t)job->step * job->disparities;
    for (int32_t i = 0; i < job->count; i++) {
        int16_t *total = job->total ? job->total + i * step : NULL;
        for (int32_t k = 0; k < lane_count; k++)
            step_lane(job, &lanes[k], job->block + i * step, total, job->fresh && k == 0);
    }
}

void stad_gather_row_c(int16_t *total, const stad_lane *lane, int32_t slot, const stad_path_job *job)
{
    const int32_t n = job->disparities;
    for (int32_t i = 0; i < job->count; i++, total += n) {
        const int16_t *path = lane->cost + (ptrdiff_t)slot * job->stride;
        for (int32_t d = 0; d < n; d++)
            total[d] = add_sat_i16(total[d], path[d]);
        slot = slot + 1 == lane->slots ? 0 : slot + 1;
    }
}
