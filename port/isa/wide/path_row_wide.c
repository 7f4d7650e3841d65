/* SPDX-License-Identifier: MIT
 * block -> [PATH] -> best
 * port/isa/wide/path_row_wide.c - a run of pixels of four lanes at once, or of two and one. */
#include <string.h>

#include "../common/lane_track.h"
#include "path_step_wide.h"
#include "wide.h"

TRACK_INLINE uint16_t step(wide_pixel *pixel, int count, uint16_t delta)
{
    return count == 1   ? stad_path_one_wide(pixel, delta)
           : count == 2 ? stad_path_two_wide(pixel, delta)
                        : stad_path_four_wide(pixel, delta);
}

/* `stretch` pixels, in which no ring turns. */
TRACK_INLINE void take_stretch(const stad_path_job *job, wide_pixel *p, track *t, int count, int turns, int32_t stretch)
{
    wide_lane *const at[] = {&p->a, &p->b, &p->c, &p->d};
    const ptrdiff_t to_next = (ptrdiff_t)job->step * job->disparities;
    for (int32_t i = 0; i < stretch; i++, p->block += to_next, p->total += to_next) {
        for (int k = 0; k < count; k++) {
            at[k]->from = (const uint16_t *)t[k].from;
            at[k]->to = (uint16_t *)t[k].to;
            at[k]->delta = (uint16_t)(track_least(&t[k], turns && k == 0) + job->p2);
        }
        const uint16_t first = step(p, count, p->a.delta);
        for (int k = 0; k < count; k++)
            track_next(&t[k], turns && k == 0, k == 0 ? first : at[k]->least, 0, job->stride);
    }
}

/* Lanes of a whole run; the first turns where it goes along the row. count and turns are constants where it is inlined. */
TRACK_INLINE void run_of(const stad_path_job *job, stad_lane *const *lanes, int count, int turns)
{
    wide_pixel p = {.block = (const uint16_t *)job->block,
                    .total = (uint16_t *)job->total,
                    .disparities = job->disparities,
                    .p1 = (uint16_t)job->p1};
    track t[4];
    int32_t stretch;
    for (int32_t left = job->count; left > 0; left -= stretch) {
        stretch = left;
        for (int k = 0; k < count; k++)
            track_enter(&t[k], job, lanes[k], turns && k == 0, &stretch);
        take_stretch(job, &p, t, count, turns, stretch);
        for (int k = 0; k < count; k++)
            track_leave(&t[k], lanes[k], turns && k == 0, stretch);
    }
}

static void run_of_one(const stad_path_job *job, stad_lane *const *lanes)
{
    if (lanes[0]->slots == 2)
        run_of(job, lanes, 1, 1);
    else
        run_of(job, lanes, 1, 0);
}

static void run_of_two(const stad_path_job *job, stad_lane *const *lanes)
{
    if (lanes[0]->slots == 2)
        run_of(job, lanes, 2, 1);
    else
        run_of(job, lanes, 2, 0);
}

static void run_of_four(const stad_path_job *job, stad_lane *const *lanes)
{
    if (lanes[0]->slots == 2)
        run_of(job, lanes, 4, 1);
    else
        run_of(job, lanes, 4, 0);
}

static void clear_totals(const stad_path_job *job)
{
    const ptrdiff_t cells = (ptrdiff_t)job->count * job->disparities;
    memset(job->step > 0 ? job->total : job->total - (cells - job->disparities), 0, 2 * (size_t)cells);
}

void stad_path_row_wide(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
{
    if (!is_whole_16(job->disparities) || !job->total) {
        stad_path_row_c(job, lanes, lane_count);
        return;
    }
    const int32_t along = lanes[lane_count - 1].slots == 2 ? lane_count - 1 : 0; /* this lane first: S does not tell */
    stad_lane *order[4] = {&lanes[along]};
    for (int32_t k = 1; k < lane_count; k++)
        order[k] = &lanes[k == along ? 0 : k];
    if (job->fresh)
        clear_totals(job);
    if (lane_count == 4) {
        run_of_four(job, order);
        return;
    }
    if (lane_count >= 2)
        run_of_two(job, order);
    if (lane_count % 2 == 1)
        run_of_one(job, order + lane_count - 1);
}
