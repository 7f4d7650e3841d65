/* SPDX-License-Identifier: MIT
 * costs -> [WINDOW] -> sweep
 * match/window_block.c - C itself, where it cannot saturate and its rows of pixel costs are kept: it can begin at any row
 * and move either way. */
#include "match/frame.h"
#include "base/arith.h"

void stad_window_block_move(stad_frame *f, const void *in, const void *out)
{
    const stad_block_job job = {in, out, f->hs, f->columns, f->p.num_disparities, f->radius, f->wide};
    stad_block_row(&job, f->window);
}

/* Each row comes in for a row of zeros, for which there is a slot: the ring has one more than a block has rows. */
void stad_window_block_start(stad_frame *f, int32_t y)
{
    const void *none = stad_costs_blank(f, stad_window_image_row(f, y + f->radius) + 1);
    stad_row_fill(f->window, f->columns * f->p.num_disparities, f->p.p2);
    for (int32_t k = y - f->radius; k <= y + f->radius; k++)
        stad_window_block_move(f, stad_costs_row(f, stad_window_image_row(f, k), 0), none);
}
