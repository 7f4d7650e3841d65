/* SPDX-License-Identifier: MIT
 * costs -> [WINDOW] -> sweep
 * match/window_sums.c - vertical sums of pixel costs, where no row of these is kept: a row is made to come in and once more to
 * leave, run by run, and C is slid along the sums when it is asked for. */
#include <string.h>

#include "match/frame.h"
#include "base/arith.h"

static void add_row(stad_frame *f, int32_t y, int32_t weight)
{
    const int32_t d = f->p.num_disparities;
    stad_costs_features(f, y);
    for (int32_t x = 0; x < f->columns; x += STAD_RUN) {
        const int32_t count = min_i32(STAD_RUN, f->columns - x);
        int16_t *sums = f->window + (ptrdiff_t)x * d;
        stad_costs_make(f, x, count, f->costs);
        if (f->wide)
            stad_box_add_row_u16(sums, (const uint16_t *)(const void *)f->costs, count * d, weight);
        else
            stad_box_add_row_u8(sums, f->costs, count * d, weight);
    }
}

void stad_window_sums_start(stad_frame *f, int32_t y)
{
    memset(f->window, 0, 2 * (size_t)f->columns * (size_t)f->p.num_disparities);
    for (int32_t k = y - f->radius; k <= y + f->radius; k++)
        add_row(f, stad_window_image_row(f, k), 1);
}

void stad_window_sums_move(stad_frame *f, int32_t in, int32_t out)
{
    add_row(f, in, 1);
    add_row(f, out, -1);
}

const int16_t *stad_window_sums_block(const stad_frame *f, int32_t x, int32_t count)
{
    stad_slide_job job = {f->window, f->columns, f->p.num_disparities, f->radius, f->p.p2, x, count};
    stad_slide_row(&job, f->run_block);
    return f->run_block;
}
