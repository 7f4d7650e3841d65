/* SPDX-License-Identifier: MIT
 * window -> [MODE] -> row
 * match/mode_two_pass.c - MODE_HH and MODE_HH4: paths from the top, then paths from the bottom, rows out bottom up.
 *
 * The rows are cut into segments. The first pass keeps the sums of the last segment, and of the others only the path state
 * they begin with; the second pass makes each one's sums again from there when it comes to it. With one segment nothing
 * is made twice: that is the `fast` plan.
 *
 *     first pass    |-- segment 0 --|c1-- segment 1 --|c2-- segment 2 --|   c: checkpoint   == : sums kept
 *                                                      ==================
 *     second pass    <-- again from start  <-- again from c1   <-- */
#include <string.h>

#include "match/frame.h"
#include "base/arith.h"

static int16_t *segment_row(const stad_frame *f, int32_t y)
{
    return (int16_t *)(void *)(f->segment + (size_t)(y % f->segment_rows) * f->cell_bytes);
}

/* Where C may saturate it depends on the rows above, so it is kept with the sums. */
static int16_t *segment_block(const stad_frame *f, int32_t y)
{
    return (int16_t *)(void *)(f->segment + (size_t)(f->segment_rows + y % f->segment_rows) * f->cell_bytes);
}

static size_t cell_count(const stad_frame *f)
{
    return (size_t)f->columns * (size_t)f->p.num_disparities;
}

static void save_checkpoint(stad_frame *f, int32_t segment)
{
    uint8_t *to = f->checkpoints + (size_t)(segment - 1) * f->checkpoint_bytes;
    memcpy(to, f->down.memory, f->state_bytes);
    if (!f->safe)
        memcpy(to + f->state_bytes, f->window, 2 * cell_count(f));
}

static void load_checkpoint(stad_frame *f, int32_t segment)
{
    const int32_t y = segment * f->segment_rows;
    const uint8_t *from = f->checkpoints + (size_t)(segment - 1) * f->checkpoint_bytes;
    memcpy(f->down.memory, from, f->state_bytes);
    f->down.rows = y;
    if (f->safe)
        return;
    memcpy(f->window, from + f->state_bytes, 2 * cell_count(f));
    stad_window_resume(f, y - 1);
}

static void keep_block(stad_frame *f, int32_t y)
{
    const int32_t d = f->p.num_disparities;
    for (int32_t x = 0; x < f->columns; x += STAD_RUN) {
        const int32_t count = min_i32(STAD_RUN, f->columns - x);
        memcpy(segment_block(f, y) + (ptrdiff_t)x * d, stad_window_block(f, x, count), 2 * (size_t)count * (size_t)d);
    }
}

/* Row y of the paths from the top; its sums kept, or only the state advanced. */
static void take_down(stad_frame *f, int32_t y, int keep)
{
    int16_t *total = f->total_row ? f->total_row : segment_row(f, y);
    const row_sweep kept = {&f->down, NULL, total, f->g.mode == STAD_MODE_HH, 0, 1};
    const row_sweep passed = {&f->down, NULL, NULL, 0, 0, 0};
    stad_sweep_forward(f, keep ? &kept : &passed);
    if (keep && f->total_row)
        memcpy(segment_row(f, y), total, 2 * cell_count(f));
    if (keep && !f->safe)
        keep_block(f, y);
}

static void first_pass_row(stad_frame *f, int32_t y)
{
    const int32_t segment = y / f->segment_rows;
    if (y == 0) {
        stad_lanes_reset(f, &f->down);
        stad_window_start(f, 0, 0);
    } else if (y % f->segment_rows == 0) {
        save_checkpoint(f, segment);
    }
    stad_window_go(f, y);
    take_down(f, y, segment == f->segments - 1);
    f->loaded = segment;
}

void stad_mode_two_pass_feed(stad_frame *f)
{
    while (f->down_row < f->g.height && frame_has_row(f, f->down_row + f->radius + 1))
        first_pass_row(f, f->down_row++);
}

static void load_segment(stad_frame *f, int32_t segment)
{
    const int32_t first = segment * f->segment_rows;
    if (segment > 0)
        load_checkpoint(f, segment);
    else
        stad_lanes_reset(f, &f->down);
    for (int32_t y = first; y < first + f->segment_rows; y++) {
        if (y == 0)
            stad_window_start(f, 0, 0);
        stad_window_go(f, y);
        take_down(f, y, 1);
    }
    f->loaded = segment;
}

/* HH: four paths from below in one backward sweep (SPEC 6). */
static void take_up_hh(stad_frame *f, const int16_t *block, int16_t *total)
{
    const row_sweep all = {&f->up, block, total, 1, 0, 0};
    stad_sweep_back(f, &all);
}

/* HH4: the path from below, then the horizontal ones (SPEC 6). */
static void take_up_hh4(stad_frame *f, const int16_t *block, int16_t *total)
{
    const row_sweep forward = {&f->up, block, total, 1, 1, 0}, back = {NULL, block, total, 1, 0, 0};
    stad_sweep_forward(f, &forward);
    stad_sweep_back(f, &back);
}

static int second_pass_row(stad_frame *f)
{
    const int32_t y = f->g.height - 1 - f->made, segment = y / f->segment_rows;
    if (f->down_row < f->g.height)
        return STAD_AGAIN;
    if (f->made == 0)
        stad_lanes_reset(f, &f->up);
    if (f->loaded != segment)
        load_segment(f, segment);
    if (f->safe)
        stad_window_go(f, y);
    const int16_t *block = f->safe ? NULL : segment_block(f, y);
    int16_t *total = segment_row(f, y);
    if (f->total_row)
        total = memcpy(f->total_row, total, 2 * cell_count(f));
    stad_row_open(f);
    if (f->g.mode == STAD_MODE_HH)
        take_up_hh(f, block, total);
    else
        take_up_hh4(f, block, total);
    stad_row_close(f);
    return STAD_OK;
}

int stad_mode_hh_step(stad_frame *f)
{
    return second_pass_row(f);
}

int stad_mode_hh4_step(stad_frame *f)
{
    return second_pass_row(f);
}
