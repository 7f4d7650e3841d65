/* SPDX-License-Identifier: MIT
 * window -> [SWEEP] -> row
 * match/sweep.c - passes over the columns of a row, run by run, summing paths in the order of SPEC 6. */
#include <string.h>

#include "match/frame.h"
#include "base/arith.h"

/* The lanes of a pass, in order, at their place in the row: [across] set [across], the horizontal one once. Lanes in bytes
 * follow it in their own form. */
typedef struct pass {
    union {
        stad_lane lanes[4];
        struct {
            stad_lane across;
            stad_lane_u8 set[3];
        } narrow;
    } at;
    int32_t lane_count, byte_count;
    int across_at; /* place of the horizontal lane in lanes, or -1 */
} pass;

static int32_t runs_of(const stad_frame *f)
{
    return (f->columns + STAD_RUN - 1) / STAD_RUN;
}

static void enter(stad_frame *f, const row_sweep *s, pass *p)
{
    p->lane_count = p->byte_count = 0;
    p->across_at = -1;
    if (s->across && !s->across_last)
        p->across_at = p->lane_count++;
    if (s->set && f->narrow)
        p->byte_count = stad_lanes_enter_u8(f, s->set, p->at.narrow.set);
    else if (s->set)
        p->lane_count += stad_lanes_enter(f, s->set, p->at.lanes + p->lane_count);
    if (s->across && s->across_last)
        p->across_at = p->lane_count++;
    if (p->across_at >= 0) {
        stad_lane_restart(f, &f->across);
        p->at.lanes[p->across_at] = f->across;
    }
}

static stad_path_job path_job(const stad_frame *f, const int16_t *block, int16_t *total, int32_t count, int32_t step)
{
    const ptrdiff_t first = step > 0 ? 0 : (ptrdiff_t)(count - 1) * f->p.num_disparities;
    stad_path_job job = {
        block + first, total ? total + first : NULL, count, f->p.num_disparities, f->stride, step, f->p.p1, f->p.p2, 0};
    return job;
}

static void take_paths(const stad_frame *f, const stad_path_job *job, stad_lane *lanes, int32_t count)
{
    if (f->safe)
        stad_path_row(job, lanes, count);
    else
        stad_path_row_sat(job, lanes, count);
}

static void take_run(const stad_frame *f, const stad_path_job *job, int fresh, pass *p)
{
    stad_path_job part = *job;
    part.fresh = fresh;
    if (p->lane_count > 0)
        take_paths(f, &part, p->at.lanes, p->lane_count);
    part.fresh = fresh && p->lane_count == 0;
    if (p->byte_count > 0)
        stad_path_row_u8(&part, p->at.narrow.set, p->byte_count);
}

static const int16_t *block_of(stad_frame *f, const row_sweep *s, int32_t x, int32_t count)
{
    return s->block_row ? s->block_row + (ptrdiff_t)x * f->p.num_disparities : stad_window_block(f, x, count);
}

void stad_sweep_forward(stad_frame *f, const row_sweep *s)
{
    pass p;
    enter(f, s, &p);
    for (int32_t x = 0; x < f->columns; x += STAD_RUN) {
        const int32_t count = min_i32(STAD_RUN, f->columns - x);
        int16_t *total = s->total ? s->total + (ptrdiff_t)x * f->p.num_disparities : NULL;
        const stad_path_job job = path_job(f, block_of(f, s, x, count), total, count, 1);
        take_run(f, &job, s->fresh, &p);
    }
    if (s->set)
        s->set->rows++;
}

void stad_sweep_back(stad_frame *f, const row_sweep *s)
{
    pass p;
    enter(f, s, &p);
    for (int32_t run = runs_of(f) - 1; run >= 0; run--) {
        const int32_t x = run * STAD_RUN, count = min_i32(STAD_RUN, f->columns - x);
        int16_t *total = s->total + (ptrdiff_t)x * f->p.num_disparities;
        const stad_path_job job = path_job(f, block_of(f, s, x, count), total, count, -1);
        take_run(f, &job, s->fresh, &p);
        stad_row_take(f, &job, NULL, total, x);
    }
    if (s->set)
        s->set->rows++;
}

/* -- streamed modes: one forward pass over all downward paths, one back --------------------------------------------------- */

/* 3WAY adds its vertical path last (SPEC 6); only saturation can tell. */
static int vertical_is_last(const stad_frame *f)
{
    return f->g.mode == STAD_MODE_3WAY && !f->safe;
}

static uint8_t *resume_slot(const stad_frame *f, int32_t run)
{
    return f->resume + (size_t)run * STAD_BYTES_UP(2 * ((size_t)f->g.max_disparities + 1));
}

/* State of the horizontal path before a run: the slot it reads next. */
static void save_across(const stad_frame *f, const stad_lane *across, int32_t run)
{
    const int32_t from = 1 - across->write, d = f->p.num_disparities;
    uint8_t *to = resume_slot(f, run);
    memcpy(to, across->cost + (ptrdiff_t)from * f->stride, 2 * (size_t)d);
    memcpy(to + 2 * (size_t)d, across->least + from, 2);
}

static void load_across(stad_frame *f, int32_t run)
{
    const int32_t d = f->p.num_disparities;
    const uint8_t *from = resume_slot(f, run);
    stad_lane_restart(f, &f->resumed);
    memcpy(f->resumed.cost + f->stride, from, 2 * (size_t)d);
    memcpy(f->resumed.least + 1, from + 2 * (size_t)d, 2);
}

/* Forward over a row whose sums are not kept: all lanes advance, and the horizontal one leaves its state at every run. */
static void sweep_forward_lean(stad_frame *f)
{
    const row_sweep s = {&f->down, NULL, NULL, 1, 0, 0};
    pass p;
    enter(f, &s, &p);
    for (int32_t run = 0; run < runs_of(f); run++) {
        const int32_t x = run * STAD_RUN, count = min_i32(STAD_RUN, f->columns - x);
        save_across(f, &p.at.lanes[0], run);
        const stad_path_job job = path_job(f, stad_window_block(f, x, count), NULL, count, 1);
        take_run(f, &job, 0, &p);
    }
    f->down.rows++;
}

/* Forward over a row whose sums are kept; what has to be added last is only advanced. */
static void sweep_forward_kept(stad_frame *f)
{
    if (!vertical_is_last(f)) {
        const row_sweep all = {&f->down, NULL, f->total_row, 1, 0, 1};
        stad_sweep_forward(f, &all);
        return;
    }
    const row_sweep across = {NULL, NULL, f->total_row, 1, 0, 1}, vertical = {&f->down, NULL, NULL, 0, 0, 0};
    stad_sweep_forward(f, &across);
    stad_sweep_forward(f, &vertical);
}

/* The run's forward sums from state that is still there: the horizontal path replayed, the others read from their lanes. */
static void rebuild_run(stad_frame *f, const stad_lane *lanes, int32_t lane_count, const stad_path_job *back, int32_t x)
{
    const int16_t *block = back->block - (ptrdiff_t)(back->count - 1) * f->p.num_disparities;
    stad_path_job job = path_job(f, block, f->run_total, back->count, 1);
    job.fresh = 1;
    load_across(f, x / STAD_RUN);
    take_paths(f, &job, &f->resumed, 1);
    for (int32_t i = 0; i < lane_count && !vertical_is_last(f); i++)
        stad_gather_row(f->run_total, &lanes[i], (lanes[i].write + x) % lanes[i].slots, &job);
}

static void sweep_back_streamed(stad_frame *f, const stad_lane *lanes, int32_t lane_count)
{
    stad_lane_restart(f, &f->across);
    for (int32_t run = runs_of(f) - 1; run >= 0; run--) {
        const int32_t x = run * STAD_RUN, count = min_i32(STAD_RUN, f->columns - x);
        int16_t *total = f->total_row ? f->total_row + (ptrdiff_t)x * f->p.num_disparities : f->run_total;
        const stad_path_job job = path_job(f, stad_window_block(f, x, count), total, count, -1);
        if (!f->total_row)
            rebuild_run(f, lanes, lane_count, &job, x);
        if (!f->safe)
            stad_path_row_sat(&job, &f->across, 1);
        for (int32_t i = 0; i < lane_count && vertical_is_last(f); i++)
            stad_gather_row(total, &lanes[i], (lanes[i].write + x) % lanes[i].slots, &job);
        stad_row_take(f, &job, f->safe ? &f->across : NULL, total, x);
    }
}

void stad_sweep_streamed(stad_frame *f)
{
    stad_lane lanes[3];
    int32_t count = 0;
    if (!f->narrow && (!f->total_row || vertical_is_last(f)))
        count = stad_lanes_at(f, &f->down, lanes); /* where this row's state will lie */
    if (f->total_row)
        sweep_forward_kept(f);
    else
        sweep_forward_lean(f);
    sweep_back_streamed(f, lanes, count);
}
