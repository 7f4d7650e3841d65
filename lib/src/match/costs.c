/* SPDX-License-Identifier: MIT
 * pixels -> [COSTS] -> window
 * match/costs.c - rows of pixel costs, from a ring or made anew where the plan has none. */
#include <string.h>

#include "match/frame.h"
#include "base/arith.h"

static const uint8_t *pixel_row(const stad_frame *f, int32_t y, int right)
{
    const int32_t row = clamp_i32(y, 0, f->g.height - 1) % f->pixel_rows;
    return f->pixels + (ptrdiff_t)(2 * row + right) * f->g.width * f->g.channels;
}

void stad_costs_features(stad_frame *f, int32_t y)
{
    const ptrdiff_t width = f->g.width, planes = 2 * (ptrdiff_t)f->g.channels;
    uint8_t *scratch = f->features + 6 * planes * width;
    for (int right = 0; right < 2; right++) {
        uint8_t *out = f->features + right * 3 * planes * width;
        stad_prefilter_row(pixel_row(f, y - 1, right), pixel_row(f, y, right), pixel_row(f, y + 1, right), f->g.width,
                           f->g.channels, f->p.pre_filter_cap, scratch);
        for (ptrdiff_t i = 0; i < planes; i++)
            stad_range_row(scratch + i * width, f->g.width, right, out + i * 3 * width);
    }
}

void stad_costs_make(const stad_frame *f, int32_t x, int32_t count, void *cost)
{
    stad_cost_job job = {f->features,         f->features + 6 * (ptrdiff_t)f->g.channels * f->g.width,
                         f->g.width,          f->g.channels,
                         f->first_column + x, count,
                         f->p.min_disparity,  f->p.num_disparities};
    if (f->wide)
        stad_cost_row_u16(&job, cost);
    else
        stad_cost_row_u8(&job, cost);
}

static void *ring_slot(const stad_frame *f, int32_t y)
{
    const size_t cells = (size_t)f->columns * (size_t)f->p.num_disparities;
    return f->costs + (size_t)(y % f->cost_slots) * cells * (f->wide ? 2 : 1);
}

/* Makes room in the ring for row y; rows that do not adjoin what is there replace it. Returns 1 if the row was there. */
static int ring_admit(stad_frame *f, int32_t y)
{
    const int32_t end = f->ring_first + f->ring_count;
    if (y >= f->ring_first && y < end)
        return 1;
    const int below = f->ring_count > 0 && y == end, above = f->ring_count > 0 && y == f->ring_first - 1;
    if (!below && !above) {
        f->ring_first = y;
        f->ring_count = 1;
        return 0;
    }
    const int full = f->ring_count == f->cost_slots;
    f->ring_count += !full;
    f->ring_first += below ? full : -1;
    return 0;
}

const void *stad_costs_row(stad_frame *f, int32_t y, int which)
{
    void *slot = ring_slot(f, f->ring ? y : which);
    if (!f->ring || !ring_admit(f, y)) {
        stad_costs_features(f, y);
        stad_costs_make(f, 0, f->columns, slot);
    }
    return slot;
}

const void *stad_costs_blank(stad_frame *f, int32_t y)
{
    const size_t cells = (size_t)f->columns * (size_t)f->p.num_disparities;
    f->ring_count = 0;
    return memset(ring_slot(f, y), 0, cells * (f->wide ? 2 : 1));
}
