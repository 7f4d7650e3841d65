/* SPDX-License-Identifier: MIT
 * pixels -> [WINDOW] -> sweep
 * match/window.c - keeps, for the current row, the sums of the pixel costs of the rows a block covers.
 *
 * Where C cannot saturate the window holds vertical sums, can start at any row and move either way; block costs are slid
 * along them when asked for. Where it can, the window holds C itself and only moves down, because C then depends on its
 * past (SPEC 4). Rows of pixel costs come from a ring, or are made anew where the plan has none. */
#include <string.h>

#include "match/frame.h"
#include "base/arith.h"

static const uint8_t *pixel_row(const stad_frame *f, int32_t y, int right)
{
    const int32_t row = clamp_i32(y, 0, f->g.height - 1) % f->pixel_rows;
    return f->pixels + (ptrdiff_t)(2 * row + right) * f->g.width * f->g.channels;
}

/* Feature rows of both views at row y: planes of {value, low, high}, the right view's reversed. */
static void make_features(stad_frame *f, int32_t y)
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

static void make_costs(const stad_frame *f, int32_t x, int32_t count, void *cost)
{
    stad_cost_job job = {f->features, f->features + 6 * (ptrdiff_t)f->g.channels * f->g.width, f->g.width,
                         f->g.channels, f->first_column + x, count, f->p.min_disparity, f->p.num_disparities};
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

/* The whole cost row y: from the ring or made into it; without a ring, made into buffer `which` of two. */
static const void *cost_row(stad_frame *f, int32_t y, int which)
{
    void *slot = ring_slot(f, f->ring ? y : which);
    if (!f->ring || !ring_admit(f, y)) {
        make_features(f, y);
        make_costs(f, 0, f->columns, slot);
    }
    return slot;
}

static void add_cells(const stad_frame *f, ptrdiff_t at, const void *cost, int32_t n, int32_t weight)
{
    if (f->wide)
        stad_box_add_row_u16(f->sums + at, cost, n, weight);
    else
        stad_box_add_row_u8(f->sums + at, cost, n, weight);
}

static void add_row(stad_frame *f, int32_t y, int32_t weight)
{
    const int32_t d = f->p.num_disparities;
    if (f->cost_slots > 0) {
        add_cells(f, 0, cost_row(f, y, 0), f->columns * d, weight);
        return;
    }
    make_features(f, y);
    for (int32_t x = 0; x < f->columns; x += STAD_RUN) {
        const int32_t count = min_i32(STAD_RUN, f->columns - x);
        make_costs(f, x, count, f->costs);
        add_cells(f, (ptrdiff_t)x * d, f->costs, count * d, weight);
    }
}

/* Never the same row: an image of one row is not moved in. */
static void move_row(stad_frame *f, int32_t in, int32_t out)
{
    if (f->cost_slots == 0) {
        add_row(f, in, 1);
        add_row(f, out, -1);
        return;
    }
    const void *leaving = cost_row(f, out, 1), *coming = cost_row(f, in, 0);
    if (f->wide)
        stad_box_move_row_u16(f->sums, coming, leaving, f->columns * f->p.num_disparities);
    else
        stad_box_move_row_u8(f->sums, coming, leaving, f->columns * f->p.num_disparities);
}

/* Sums of the rows y - r .. y + r, clamped to [top, height - 1], each as often as it is meant. */
static void start_sums(stad_frame *f, int32_t y)
{
    const int32_t r = f->radius, low = f->window_top, high = f->g.height - 1;
    const int32_t from = clamp_i32(y - r, low, high), to = clamp_i32(y + r, low, high);
    memset(f->sums, 0, 2 * (size_t)f->columns * (size_t)f->p.num_disparities);
    for (int32_t k = from; k <= to; k++) {
        const int32_t above = k == low ? max_i32(low - (y - r), 0) : 0;
        const int32_t below = k == high ? max_i32(y + r - high, 0) : 0;
        add_row(f, k, 1 + above + below);
    }
}

static stad_box_sat_job sat_job(const stad_frame *f, int32_t in, int32_t out)
{
    const int three_way = f->g.mode == STAD_MODE_3WAY;
    const int32_t d = f->p.num_disparities, early = f->window_top + f->radius;
    stad_box_sat_job job = {NULL, NULL, f->hs, f->hs + d, f->columns, d, f->radius, 1, f->wide, 0,
                            three_way || in <= early, three_way || out <= early, 1, three_way};
    return job;
}

static void start_sat(stad_frame *f, int32_t top)
{
    const int32_t n = f->columns * f->p.num_disparities, last = f->g.height - 1;
    for (int32_t i = 0; i < n; i++)
        f->sums[i] = f->p.p2;
    for (int32_t k = top; k <= top + f->radius; k++) {
        const int32_t y = min_i32(k, last);
        stad_box_sat_job job = sat_job(f, y, y);
        job.in = cost_row(f, y, 0);
        job.start = 1;
        job.weight = k == top ? f->radius + 1 : 1;
        stad_box_sat_row(&job, f->sums);
    }
}

static void move_sat(stad_frame *f, int32_t y)
{
    const int32_t in = min_i32(y + f->radius, f->g.height - 1), out = max_i32(y - f->radius - 1, f->window_top);
    stad_box_sat_job job = sat_job(f, in, out);
    job.out = cost_row(f, out, 1);
    job.in = cost_row(f, in, 0);
    job.first_column_add_first = f->g.mode == STAD_MODE_3WAY || y + f->radius < f->g.height;
    stad_box_sat_row(&job, f->sums);
}

void window_start(stad_frame *f, int32_t y, int32_t top)
{
    f->window_row = y;
    f->window_top = top;
    if (f->safe)
        start_sums(f, y);
    else
        start_sat(f, y);
}

void window_resume(stad_frame *f, int32_t y)
{
    f->window_row = y;
    f->window_top = 0;
}

void window_go(stad_frame *f, int32_t y)
{
    const int32_t from = f->window_row, low = f->window_top, high = f->g.height - 1, r = f->radius;
    if (y == from)
        return;
    f->window_row = y;
    if (!f->safe)
        move_sat(f, y);
    else if (y == from + 1)
        move_row(f, clamp_i32(y + r, low, high), clamp_i32(from - r, low, high));
    else if (y == from - 1)
        move_row(f, clamp_i32(y - r, low, high), clamp_i32(from + r, low, high));
    else
        start_sums(f, y);
}

/* HH4: the last r rows carry no image data (SPEC 4). */
static int is_blank(const stad_frame *f)
{
    return f->g.mode == STAD_MODE_HH4 && f->window_row > 0 && f->window_row + f->radius >= f->g.height;
}

const int16_t *window_block(stad_frame *f, int32_t x, int32_t count)
{
    const int32_t d = f->p.num_disparities;
    if (is_blank(f)) {
        for (int32_t i = 0; i < count * d; i++)
            f->run_block[i] = f->p.p2;
        return f->run_block;
    }
    if (!f->safe)
        return f->sums + (ptrdiff_t)x * d;
    stad_slide_job job = {f->sums, f->columns, d, f->radius, f->p.p2, x, count};
    stad_slide_row(&job, f->run_block);
    return f->run_block;
}
