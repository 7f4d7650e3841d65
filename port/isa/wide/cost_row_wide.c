/* SPDX-License-Identifier: MIT
 * range -> [COST] -> box
 * port/isa/wide/cost_row_wide.c - pixel costs of a run, column by column and channel by channel. */
#include "kernel/kernel.h"
#include "cost_column_wide.h"
#include "wide.h"

static wide_plane plane_at(const stad_cost_job *job, int32_t plane, int32_t x)
{
    const ptrdiff_t width = job->width;
    const uint8_t *left = job->left + plane * 3 * width + x;
    const uint8_t *right = job->right + plane * 3 * width + (width - 1 - x + job->min_disparity);
    const wide_plane p = {right, right + width, right + 2 * width, left[0], left[width], left[2 * width]};
    return p;
}

static wide_column column_at(const stad_cost_job *job, int32_t channel, int32_t x, uint8_t *cost)
{
    const wide_column c = {plane_at(job, channel, x), plane_at(job, job->channels + channel, x), cost, job->disparities};
    return c;
}

void stad_cost_row_u8_wide(const stad_cost_job *job, uint8_t *cost)
{
    if (!is_whole_16(job->disparities)) {
        stad_cost_row_u8_c(job, cost);
        return;
    }
    for (int32_t x = job->x; x < job->x + job->count; x++, cost += job->disparities) {
        const wide_column first = column_at(job, 0, x, cost);
        stad_cost_column_wide(&first);
        for (int32_t channel = 1; channel < job->channels; channel++) {
            const wide_column more = column_at(job, channel, x, cost);
            stad_cost_column_add_wide(&more);
        }
    }
}
