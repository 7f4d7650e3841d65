/* SPDX-License-Identifier: MIT
 * slide -> [PATH] -> best
 * kernel/path_row.c - path costs of a run of pixels where C cannot saturate, of one lane or two by two.
 *
 * With p the previous pixel's costs, m its least one and C including p2 (SPEC 5):
 *     L[d] = C[d] - (m + p2) + min(p[d], p[d-1] + p1, p[d+1] + p1, m + p2)
 * Bounds: 0 <= p <= 32767, and m <= 32767 - p2 because some d of the previous pixel had L = C - p2; so m + p2 fits, and
 * clipping the neighbours at m + p2 - p1 before p1 is added keeps that sum within m + p2. S saturates at 32767 as the
 * specification's does: every L is >= 0, so the order of the additions does not matter. */
#include <string.h>

#include "kernel/path_step.h"
#include "base/arith.h"

static void step_one(const int16_t *restrict from, int16_t *restrict to, const int16_t *restrict block, stad_path_step *s)
{
    const int32_t n = whole_8(s->disparities);
    const int16_t p1 = s->p1, delta = s->delta[0];
    int16_t least = STAD_COST_MAX;
    /*@ loop invariant 0 <= d <= n && 0 <= least;
        loop invariant \forall integer k; 0 <= k < d ==> least <= to[k] <= block[k] && least <= block[k] + from[k] - delta;
        loop assigns d, least, to[0 .. n - 1]; loop variant n - d; */
    for (int32_t d = 0; d < n; d++) {
        const int16_t here = stad_path_cost(from + d, block[d], delta, p1);
        to[d] = here;
        least = min_i16(least, here);
    }
    s->least[0] = least;
}

static void add_total(int16_t *restrict total, const int16_t *restrict path, int32_t disparities)
{
    const int32_t n = whole_8(disparities);
    /*@ loop invariant 0 <= d <= n && \forall integer k; 0 <= k < n ==> 0 <= total[k];
        loop assigns d, total[0 .. n - 1]; loop variant n - d; */
    for (int32_t d = 0; d < n; d++)
        total[d] = stad_path_sum(total[d], path[d]);
}

/* The slot that a lane reads at this pixel; the one it writes lies before it, around the ring. */
static int32_t read_slot(const stad_lane *lane)
{
    return lane->write + 1 == lane->slots ? 0 : lane->write + 1;
}

static int16_t *cells(const stad_path_job *job, const stad_lane *lane, int32_t slot)
{
    return lane->cost + (ptrdiff_t)slot * job->stride;
}

static void enter(stad_path_step *s, int32_t which, const stad_path_job *job, const stad_lane *lane)
{
    const int32_t read = read_slot(lane);
    s->from[which] = cells(job, lane, read);
    s->to[which] = cells(job, lane, lane->write);
    s->delta[which] = narrow_i16(lane->least[read] + job->p2);
}

static void leave(const stad_path_step *s, int32_t which, stad_lane *lane)
{
    lane->least[lane->write] = s->least[which];
    lane->write = read_slot(lane);
}

/* One lane or two. */
static void take(const stad_path_job *job, const int16_t *block, int16_t *total, stad_lane *lanes, int32_t count)
{
    stad_path_step s;
    s.disparities = job->disparities;
    s.p1 = narrow_i16(job->p1);
    for (int32_t i = 0; i < count; i++)
        enter(&s, i, job, &lanes[i]);
    if (count == 2)
        stad_path_step_two(s.from[0], s.to[0], s.from[1], s.to[1], block, total, &s);
    else
        step_one(s.from[0], s.to[0], block, &s);
    if (count == 1 && total)
        add_total(total, s.to[0], s.disparities);
    for (int32_t i = 0; i < count; i++)
        leave(&s, i, &lanes[i]);
}

static void take_pixel(const stad_path_job *job, const int16_t *block, int16_t *total, stad_lane *lanes, int32_t count)
{
    int32_t taken = 0;
    if (total && job->fresh)
        memset(total, 0, 2 * (size_t)job->disparities);
    for (int32_t k = 0; k < count; k += taken) {
        taken = total && k + 1 < count ? 2 : 1;
        take(job, block, total, &lanes[k], taken);
    }
}

void stad_path_row_c(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
{
    STAD_ASSERT(job->p1 > 0 && job->p1 < job->p2 && (job->step == 1 || job->step == -1) && lane_count > 0);
    const ptrdiff_t step = (ptrdiff_t)job->step * job->disparities;
    for (int32_t i = 0; i < job->count; i++)
        take_pixel(job, job->block + i * step, job->total ? job->total + i * step : NULL, lanes, lane_count);
}

void stad_gather_row_c(int16_t *total, const stad_lane *lane, int32_t slot, const stad_path_job *job)
{
    const int32_t n = whole_8(job->disparities);
    for (int32_t i = 0; i < job->count; i++, total += n) {
        const int16_t *path = cells(job, lane, slot);
        for (int32_t d = 0; d < n; d++)
            total[d] = add_sat_i16(total[d], path[d]); /* of stad_path_row_sat too: either sign */
        slot = slot + 1 == lane->slots ? 0 : slot + 1;
    }
}
