/* SPDX-License-Identifier: MIT
 * window -> [MODE] -> row
 * match/mode_3way.c - MODE_SGBM_3WAY: three paths, four stripes that each start afresh above their first row (SPEC 7).
 *
 * The stripes run one after the other. Before each one the rows of its overlap are taken again from the pixel ring, so one
 * vertical state is enough; only the vertical path needs that warm-up. */
#include "match/frame.h"
#include "base/arith.h"

typedef struct stripe {
    int32_t index, first, end; /* rows it reads: [first, end) */
    int32_t shift;             /* it writes source row y to row y - shift */
} stripe;

static stripe stripe_of(const stad_frame *f, int32_t index)
{
    const int32_t h = f->g.height, size = (h + 3) / 4;
    const int32_t overlap = f->radius + 1 + (size + 9) / 10;
    stripe s = {index, clamp_i32(index * size - overlap, 0, h), min_i32((index + 1) * size, h), 0};
    s.shift = index == 0 ? 0 : s.first - (index * size - overlap); /* not 0 only where the overlap is cut off: SPEC 7 */
    return s;
}

/* A row of one vertical path only, ahead of the rows that are wanted. */
static void warm_up(stad_frame *f)
{
    const row_sweep vertical = {&f->down, NULL, NULL, 0, 0, 0};
    stad_sweep_forward(f, &vertical);
}

static void reach(stad_frame *f, const stripe *s, int32_t y)
{
    if (f->loaded != s->index) {
        f->loaded = s->index;
        stad_lanes_reset(f, &f->down);
        stad_window_start(f, s->first, s->first);
    } else {
        stad_window_go(f, f->window_row + 1);
    }
    while (f->window_row < y) {
        warm_up(f);
        stad_window_go(f, f->window_row + 1);
    }
}

/* The oldest pixel row that this stripe's next row or the next stripe's first may touch. */
static int32_t oldest_needed(const stad_frame *f, const stripe *s, int32_t y)
{
    const int32_t here = max_i32(y - f->radius, s->first) - 1;
    return max_i32(min_i32(here, stripe_of(f, s->index + 1).first - 1), 0);
}

int stad_mode_3way_step(stad_frame *f)
{
    const int32_t row = f->made, size = (f->g.height + 3) / 4;
    const stripe s = stripe_of(f, row / size);
    const int32_t y = row + s.shift;
    if (!frame_has_row(f, min_i32(y, s.end - 1) + f->radius + 1))
        return STAD_AGAIN;
    stad_row_open(f);
    if (y < s.end) {
        reach(f, &s, y);
        f->oldest = max_i32(f->oldest, oldest_needed(f, &s, y));
        stad_sweep_streamed(f);
    }
    stad_row_close(f);
    return STAD_OK;
}
