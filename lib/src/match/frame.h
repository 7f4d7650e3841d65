/* SPDX-License-Identifier: MIT
 * match/frame.h - what a matcher holds (private), and the steps its modes put in order.
 *
 *     push -> pixel ring -> COSTS -> WINDOW (block costs) -> SWEEP (paths) -> ROW (winners, check) -> pull (median)
 *
 * Columns x are counted from the first one that can have a disparity; `first_column` turns them into image columns. */
#ifndef STAD_FRAME_H
#define STAD_FRAME_H

#include "stad/match.h"
#include "stad/winners.h"
#include "kernel/kernel.h"

enum lane_kind { LANE_DOWN_RIGHT, LANE_VERTICAL, LANE_DOWN_LEFT }; /* from x - 1, x, x + 1 of the row before */

/* Lanes of one pass through the frame, laid out for the geometry, shaped for the frame's parameters. */
typedef struct lane_set {
    uint8_t *memory;
    int32_t count;
    int32_t mirrored; /* a pass from the bottom right: its lanes are summed in the opposite order (SPEC 6) */
    int32_t rows;     /* taken since the last reset: fixes where each column's slot is */
} lane_set;

typedef struct stad_frame {
    stad_geometry g;
    stad_params p;
    stad_match_counts counts;
    const char *culprit;
    uint32_t options;
    int32_t running;    /* a frame has been begun */
    stad_winners *keep; /* where the winners of every frame go, or NULL */
    int32_t recording;  /* this frame's go there */
    stad_best *best;    /* the row's winners where they are kept, else a run's */
    int16_t *fine;
    const stad_winners *again; /* this frame's winners are there already, or NULL */

    /* of the geometry */
    int32_t narrow, cost_slots, ring, pixel_rows, segment_rows, segments;
    size_t cell_bytes, lane_bytes, state_bytes, checkpoint_bytes;

    /* parts of the workspace */
    uint8_t *pixels, *features, *costs;
    int16_t *window, *total_row; /* C of a row, or vertical sums: window.c; S of a row, or NULL */
    uint8_t *resume, *segment, *checkpoints;
    int16_t *run_block, *run_total, *hs;
    stad_lane across, resumed; /* the horizontal path, and its replay */
    int16_t *raw[3], *votes[3], *vote_cost;
    uint8_t *confidence[3];
    stad_best *run_best; /* a run's winners and their sub-pixel places */
    int16_t *run_fine;

    /* of the frame's parameters */
    int32_t safe, wide; /* C cannot saturate; pixel costs need 16 bits */
    int32_t first_column, columns, radius, stride;
    lane_set down, up;

    /* where the frame stands: rows pushed, oldest row still needed, rows made (raw) and pulled */
    int32_t pushed, oldest, made, pulled;
    int32_t window_row, window_top; /* row the window is centred on (-1: none), first row of its image */
    int32_t ring_first, ring_count; /* rows of costs in the ring */
    int32_t down_row, loaded;       /* HH, HH4: next row of the first pass; segment in memory (-1: none) */
} stad_frame;

static inline stad_frame *frame_of(stad_match *m)
{
    return (stad_frame *)(void *)m->opaque;
}

static inline const stad_frame *frame_of_const(const stad_match *m)
{
    return (const stad_frame *)(const void *)m->opaque;
}

static inline int16_t none_q4(const stad_frame *f)
{
    return (int16_t)((f->p.min_disparity - 1) * 16);
}

/* Rows [0, y] are in, or all there are. */
static inline int frame_has_row(const stad_frame *f, int32_t y)
{
    return f->pushed > y || f->pushed == f->g.height;
}

/* -- plan.c: binds the parts of the workspace --------------------------------------------------------------------------- */
void stad_plan_bind(stad_frame *f, void *work);

/* -- costs.c: from pixel rows to rows of pixel costs --------------------------------------------------------------------- */
/* Feature rows of both views at row y: planes of {value, low, high}, the right view's reversed. */
void stad_costs_features(stad_frame *f, int32_t y);
void stad_costs_make(const stad_frame *f, int32_t x, int32_t count, void *cost); /* of a run of columns, from the features */
/* The whole row y: from the ring or made into it; without a ring, made into buffer `which` of two. */
const void *stad_costs_row(stad_frame *f, int32_t y, int which);
const void *stad_costs_blank(stad_frame *f, int32_t y); /* empties the ring and puts zeros in the slot of row y */

/* -- window.c: from pixel costs to block costs --------------------------------------------------------------------------- */
void stad_window_start(stad_frame *f, int32_t y, int32_t top); /* at row y of an image that begins at row top */
void stad_window_resume(stad_frame *f, int32_t y);             /* f->window already holds row y's saturating block costs */
void stad_window_go(stad_frame *f, int32_t y);                 /* to row y by the cheapest exact way */
const int16_t *stad_window_block(stad_frame *f, int32_t x, int32_t count); /* C of a run of columns */
int32_t stad_window_image_row(const stad_frame *f, int32_t k);             /* k; outside the image its first or last row */

/* -- window_*.c: what it holds ------------------------------------------------------------------------------------------- */
void stad_window_sums_start(stad_frame *f, int32_t y);
void stad_window_sums_move(stad_frame *f, int32_t in, int32_t out);
const int16_t *stad_window_sums_block(const stad_frame *f, int32_t x, int32_t count);
void stad_window_block_start(stad_frame *f, int32_t y);
void stad_window_block_move(stad_frame *f, const void *in, const void *out);
void stad_window_sat_start(stad_frame *f, int32_t top);
void stad_window_sat_go(stad_frame *f, int32_t y);

/* -- lanes.c: path state ------------------------------------------------------------------------------------------------- */
void stad_lanes_shape(stad_frame *f);
void stad_lanes_reset(const stad_frame *f, lane_set *set);                         /* all paths restart; the fences are drawn */
int32_t stad_lanes_at(const stad_frame *f, const lane_set *set, stad_lane *lanes); /* as set->rows places them; count */
int32_t stad_lanes_enter(const stad_frame *f, const lane_set *set, stad_lane *lanes); /* the same, at the start of a row */
int32_t stad_lanes_enter_u8(const stad_frame *f, const lane_set *set, stad_lane_u8 *lanes);
void stad_lane_restart(const stad_frame *f, stad_lane *across);

/* -- sweep.c: the orders in which paths are summed ------------------------------------------------------------------------ */
/* One pass over a row's columns. total: S of the row, or NULL; block_row: C of the row, or NULL to take the window's. */
typedef struct row_sweep {
    lane_set *set;            /* vertical and diagonal lanes, or NULL */
    const int16_t *block_row; /* whole row of block costs, or NULL */
    int16_t *total;           /* whole row, or NULL */
    int across, across_last;  /* the horizontal path too; after the others */
    int fresh;                /* total is written, not added to */
} row_sweep;
void stad_sweep_forward(stad_frame *f, const row_sweep *s);
void stad_sweep_streamed(stad_frame *f);                 /* SGBM, 3WAY: forward, back, winners */
void stad_sweep_back(stad_frame *f, const row_sweep *s); /* right to left, winners on the way */

/* -- row.c: winners of a row ---------------------------------------------------------------------------------------------- */
void stad_row_fill(int16_t *to, int32_t n, int16_t value);
void stad_row_open(stad_frame *f);
/* The winners of a run, whose sums begin at total; last: the lane of its last path, or NULL. Runs go from right to left. */
void stad_row_take(stad_frame *f, const stad_path_job *job, stad_lane *last, const int16_t *total, int32_t x);
void stad_row_select(stad_frame *f, const stad_best *best, const int16_t *fine, int32_t x, int32_t count);
void stad_row_close(stad_frame *f);

/* -- winners.c: a row of them kept, and a raw row made of them --------------------------------------------------------- */
void stad_winners_open(stad_frame *f); /* this row's go where they are kept */
int stad_winners_step(stad_frame *f);

/* -- mode_*.c: each makes the next raw row, or answers STAD_AGAIN --------------------------------------------------------- */
int stad_mode_sgbm_step(stad_frame *f);
int stad_mode_3way_step(stad_frame *f);
int stad_mode_hh_step(stad_frame *f);
int stad_mode_hh4_step(stad_frame *f);
void stad_mode_two_pass_feed(stad_frame *f); /* HH, HH4: the first pass, as rows come in */

#endif
