/* SPDX-License-Identifier: MIT
 * sweep -> [ROW] -> median
 * match/row.c - one raw row: opened, filled run by run from right to left, checked, closed. */
#include <string.h>

#include "kernel/last_row.h"
#include "match/frame.h"
#include "base/arith.h"

void stad_row_fill(int16_t *to, int32_t n, int16_t value)
{
    for (int32_t i = 0; i < n; i++)
        to[i] = value;
}

void stad_row_open(stad_frame *f)
{
    const int32_t slot = f->made % 3, width = f->g.width;
    stad_row_fill(f->raw[slot], width, none_q4(f));
    stad_row_fill(f->votes[slot], width, none_q4(f)); /* in units of whole disparities, as SPEC 8 has it */
    stad_row_fill(f->vote_cost, width, STAD_COST_MAX);
    memset(f->confidence[slot], 0, (size_t)width);
    if (f->recording)
        stad_winners_open(f);
}

void stad_row_take(stad_frame *f, const stad_path_job *job, stad_lane *last, const int16_t *total, int32_t x)
{
    STAD_ASSERT(x >= 0 && job->count > 0 && x + job->count <= f->columns);
    const int32_t at = f->recording ? x : 0;
    stad_last_row(job, last, f->g.mode == STAD_MODE_3WAY, f->best + at);
    stad_refine_row(total, f->best + at, job->count, job->disparities, f->fine + at);
    stad_row_select(f, f->best + at, f->fine + at, x, job->count);
}

void stad_row_select(stad_frame *f, const stad_best *best, const int16_t *fine, int32_t x, int32_t count)
{
    const int32_t slot = f->made % 3;
    stad_select_job job = {best,
                           fine,
                           f->first_column + x,
                           count,
                           f->g.width,
                           f->p.min_disparity,
                           f->p.uniqueness_ratio,
                           f->g.mode == STAD_MODE_3WAY,
                           f->raw[slot],
                           f->votes[slot],
                           f->vote_cost,
                           NULL,
                           0,
                           0};
    if (f->options & STAD_MATCH_CONFIDENCE)
        job.confidence = f->confidence[slot];
    stad_select_row(&job);
    f->counts.firm += job.firm;
    f->counts.rejected_uniqueness += job.rejected;
}

/* Votes become disparities of the right view. */
static void finish_right(const stad_frame *f, int16_t *restrict votes)
{
    const int16_t *cost = f->vote_cost, none = none_q4(f);
    for (int32_t x = 0; x < f->g.width; x++)
        votes[x] = (int16_t)(cost[x] == STAD_COST_MAX ? none : votes[x] * 16); /* |d| <= 2047 */
}

static int32_t count_valid(const stad_frame *f, const int16_t *disp)
{
    const int16_t none = none_q4(f);
    int32_t valid = 0;
    for (int32_t x = 0; x < f->columns; x++)
        valid += disp[f->first_column + x] != none;
    return valid;
}

static void clear_where_none(const stad_frame *f, const int16_t *disp, uint8_t *confidence)
{
    for (int32_t x = 0; x < f->g.width; x++)
        if (disp[x] == none_q4(f))
            confidence[x] = 0;
}

void stad_row_close(stad_frame *f)
{
    const int32_t slot = f->made % 3, end = f->first_column + f->columns;
    const stad_check_job job = {f->raw[slot], f->votes[slot],     f->first_column,     end,
                                f->g.width,   f->p.min_disparity, f->p.disp12_max_diff};
    f->counts.rejected_check += stad_check_row(&job);
    f->counts.valid += count_valid(f, f->raw[slot]);
    if (f->options & STAD_MATCH_CONFIDENCE)
        clear_where_none(f, f->raw[slot], f->confidence[slot]);
    f->counts.considered += f->columns;
    finish_right(f, f->votes[slot]);
    if (f->recording)
        f->keep->rows = f->made + 1;
    f->made++;
}
