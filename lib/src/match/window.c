/* SPDX-License-Identifier: MIT
 * costs -> [WINDOW] -> sweep
 * match/window.c - keeps, for the current row, what its block costs C need, in one of three ways:
 *
 *     C can saturate                         C itself, from the top down (window_sat.c)
 *     it cannot, rows of pixel costs kept    C itself, begun anywhere, moved either way (window_block.c)
 *     it cannot, none kept                   vertical sums that C is slid along (window_sums.c) */
#include "match/frame.h"
#include "base/arith.h"

int32_t stad_window_image_row(const stad_frame *f, int32_t k)
{
    return clamp_i32(k, f->window_top, f->g.height - 1);
}

static void start_at(stad_frame *f, int32_t y)
{
    if (f->ring)
        stad_window_block_start(f, y);
    else
        stad_window_sums_start(f, y);
}

/* Never the same row: an image of one row is not moved in. */
static void move_row(stad_frame *f, int32_t in, int32_t out)
{
    if (f->ring) {
        const void *leaving = stad_costs_row(f, out, 1), *coming = stad_costs_row(f, in, 0);
        stad_window_block_move(f, coming, leaving);
    } else {
        stad_window_sums_move(f, in, out);
    }
}

void stad_window_start(stad_frame *f, int32_t y, int32_t top)
{
    f->window_row = y;
    f->window_top = top;
    if (f->safe)
        start_at(f, y);
    else
        stad_window_sat_start(f, y);
}

void stad_window_resume(stad_frame *f, int32_t y)
{
    f->window_row = y;
    f->window_top = 0;
}

void stad_window_go(stad_frame *f, int32_t y)
{
    STAD_ASSERT(y >= 0 && y < f->g.height && f->columns > 0);
    const int32_t from = f->window_row, r = f->radius;
    if (y == from)
        return;
    f->window_row = y;
    if (!f->safe)
        stad_window_sat_go(f, y);
    else if (y == from + 1)
        move_row(f, stad_window_image_row(f, y + r), stad_window_image_row(f, from - r));
    else if (y == from - 1)
        move_row(f, stad_window_image_row(f, y - r), stad_window_image_row(f, from + r));
    else
        start_at(f, y);
}

/* HH4: the last r rows carry no image data (SPEC 4). */
static int is_blank(const stad_frame *f)
{
    return f->g.mode == STAD_MODE_HH4 && f->window_row > 0 && f->window_row + f->radius >= f->g.height;
}

const int16_t *stad_window_block(stad_frame *f, int32_t x, int32_t count)
{
    const int32_t d = f->p.num_disparities;
    if (is_blank(f)) {
        stad_row_fill(f->run_block, count * d, f->p.p2);
        return f->run_block;
    }
    if (f->safe && !f->ring)
        return stad_window_sums_block(f, x, count);
    return f->window + (ptrdiff_t)x * d;
}
