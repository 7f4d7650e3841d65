/* SPDX-License-Identifier: MIT
 * push -> [MATCH] -> pull
 * match/match.c - the row pump: takes rows in, lets the mode make raw rows, hands out their median. */
#include <string.h>

#include "match/frame.h"
#include "base/arith.h"

/* A stad_match must hold a stad_frame: a negative array size stops the build. */
typedef char frame_fits_match[sizeof(stad_frame) <= sizeof(stad_match) ? 1 : -1];

int stad_match_init(stad_match *m, const stad_geometry *g, void *work, size_t work_bytes)
{
    STAD_ASSERT(m && g);
    stad_frame *f = frame_of(m);
    memset(m, 0, sizeof *m);
    const int status = stad_geometry_check(g, &f->culprit);
    if (status != STAD_OK)
        return status;
    if (!work || (uintptr_t)work % STAD_ALIGN != 0 || work_bytes < stad_match_bytes(g))
        return STAD_E_SIZE;
    f->g = *g;
    stad_plan_bind(f, work);
    return STAD_OK;
}

int stad_match_options(stad_match *m, unsigned options)
{
    if (options & ~(unsigned)(STAD_MATCH_NO_MEDIAN | STAD_MATCH_CONFIDENCE))
        return STAD_E_PARAM;
    frame_of(m)->options = options;
    return STAD_OK;
}

const char *stad_match_culprit(const stad_match *m)
{
    return frame_of_const(m)->culprit;
}

const stad_match_counts *stad_match_counts_of(const stad_match *m)
{
    return &frame_of_const(m)->counts;
}

/* Names the first parameter that is above what the geometry reserved memory for. */
static const char *above_geometry(const stad_geometry *g, const stad_params *p)
{
    if (p->num_disparities > g->max_disparities)
        return "num_disparities";
    if (p->block_size > g->max_block_size)
        return "block_size";
    if (p->p2 > g->max_p2)
        return "p2";
    if (p->pre_filter_cap > g->max_pre_filter_cap)
        return "pre_filter_cap";
    return NULL;
}

static void shape_frame(stad_frame *f)
{
    const stad_params *p = &f->p;
    const int32_t end = p->min_disparity + p->num_disparities;
    f->first_column = max_i32(end, 0);
    f->columns = f->g.width + min_i32(p->min_disparity, 0) - f->first_column;
    f->radius = p->block_size / 2;
    f->wide = STAD_COST_TOP(f->g.channels, p->pre_filter_cap) > 255;
    f->safe = STAD_COST_SAFE(f->g.channels, p->block_size, p->p2, p->pre_filter_cap);
    f->pushed = f->oldest = f->made = f->pulled = f->down_row = 0;
    f->ring_first = f->ring_count = 0;
    f->window_row = f->loaded = -1;
    stad_lanes_shape(f);
    memset(&f->counts, 0, sizeof f->counts);
}

static int begin(stad_frame *f, const stad_params *p)
{
    f->running = 0;
    if (f->g.width == 0)
        return STAD_E_STATE; /* never initialised */
    const int status = stad_params_check(p, f->g.mode, f->g.width, &f->culprit);
    if (status != STAD_OK)
        return status;
    f->culprit = above_geometry(&f->g, p);
    if (f->culprit)
        return STAD_E_LIMIT;
    f->p = *p;
    shape_frame(f);
    f->again = NULL;
    f->recording = f->keep != NULL;
    f->best = f->run_best;
    f->fine = f->run_fine;
    f->running = 1;
    return STAD_OK;
}

int stad_match_begin(stad_match *m, const stad_params *p)
{
    STAD_ASSERT(m && p);
    stad_frame *f = frame_of(m);
    const int status = begin(f, p);
    if (status == STAD_OK && f->recording) {
        f->keep->params = *p;
        f->keep->rows = 0;
    }
    return status;
}

int stad_match_keep(stad_match *m, stad_winners *w)
{
    stad_frame *f = frame_of(m);
    if (w && (w->width != f->g.width || w->height != f->g.height || w->mode != f->g.mode))
        return STAD_E_SIZE;
    f->keep = w;
    f->running = 0;
    return STAD_OK;
}

int stad_match_again(stad_match *m, const stad_params *p, const stad_winners *w)
{
    STAD_ASSERT(m && p && w);
    stad_frame *f = frame_of(m);
    if (w->width != f->g.width || w->height != f->g.height || w->mode != f->g.mode)
        return STAD_E_SIZE;
    const int served = stad_winners_serve(w, p), status = begin(f, p);
    f->running = status == STAD_OK && served;
    f->recording = 0;
    f->again = w;
    return status == STAD_OK && !served ? STAD_E_STATE : status;
}

static int is_two_pass(const stad_frame *f)
{
    return f->g.mode == STAD_MODE_HH || f->g.mode == STAD_MODE_HH4;
}

int stad_match_push(stad_match *m, const uint8_t *left_row, const uint8_t *right_row)
{
    STAD_ASSERT(m && left_row && right_row);
    stad_frame *f = frame_of(m);
    const size_t bytes = (size_t)f->g.width * (size_t)f->g.channels;
    if (!f->running || f->again || f->pushed == f->g.height)
        return STAD_E_STATE;
    if (f->pushed - f->oldest >= f->pixel_rows)
        return STAD_AGAIN;
    uint8_t *slot = f->pixels + (size_t)(f->pushed % f->pixel_rows) * 2 * bytes;
    memcpy(slot, left_row, bytes);
    memcpy(slot + bytes, right_row, bytes);
    f->pushed++;
    if (is_two_pass(f))
        stad_mode_two_pass_feed(f);
    return STAD_OK;
}

static int make_row(stad_frame *f)
{
    if (f->again)
        return stad_winners_step(f);
    switch (f->g.mode) {
    case STAD_MODE_SGBM:
        return stad_mode_sgbm_step(f);
    case STAD_MODE_3WAY:
        return stad_mode_3way_step(f);
    case STAD_MODE_HH:
        return stad_mode_hh_step(f);
    default:
        return stad_mode_hh4_step(f);
    }
}

/* The next row out needs the raw row after it, for the median. Rows may come in either direction: a median does not mind. */
static void put_row(const stad_frame *f, int16_t *out)
{
    const int32_t i = f->pulled, last = f->g.height - 1;
    const int16_t *row = f->raw[i % 3];
    if (f->options & STAD_MATCH_NO_MEDIAN)
        memcpy(out, row, 2 * (size_t)f->g.width);
    else
        stad_median_row(f->raw[max_i32(i - 1, 0) % 3], row, f->raw[min_i32(i + 1, last) % 3], f->g.width, out);
}

int stad_match_pull_all(stad_match *m, int16_t *disp_q4_row, uint8_t *confidence, int16_t *right_q4)
{
    STAD_ASSERT(m);
    stad_frame *f = frame_of(m);
    const int32_t height = f->g.height, width = f->g.width;
    if (!f->running || f->pulled == height)
        return STAD_E_STATE;
    while (f->made < min_i32(f->pulled + 2, height)) {
        const int status = make_row(f);
        if (status != STAD_OK)
            return status;
    }
    const int32_t slot = f->pulled % 3;
    if (disp_q4_row)
        put_row(f, disp_q4_row);
    if (confidence)
        memcpy(confidence, f->confidence[slot], (size_t)width);
    if (right_q4)
        memcpy(right_q4, f->votes[slot], 2 * (size_t)width);
    const int32_t row = is_two_pass(f) ? height - 1 - f->pulled : f->pulled;
    f->pulled++;
    return row;
}

int stad_match_pull(stad_match *m, int16_t *disp_q4_row)
{
    return stad_match_pull_all(m, disp_q4_row, NULL, NULL);
}
