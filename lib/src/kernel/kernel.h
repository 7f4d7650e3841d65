/* SPDX-License-Identifier: MIT
 * kernel/kernel.h - the contract of every row kernel.
 *
 *     pixels -> PREFILTER -> RANGE -> COST -> BLOCK (or BOX -> SLIDE) -> PATH -> BEST -> REFINE -> SELECT -> CHECK -> MEDIAN -> disparity
 *
 * A kernel takes plain pointers and integers, works on one row or on a run of columns of it, keeps nothing, allocates
 * nothing. Volumes are x-major: the D values of a column lie together, d ascending. The reference `stad_<kernel>_c` is
 * always built; the library calls `stad_<kernel>`, which stad_port.h of the chosen port may bind to another symbol with
 * the same bits. Letters as in docs/SPEC.md: D disparities, r block radius, L path cost, S their sum. */
#ifndef STAD_KERNEL_H
#define STAD_KERNEL_H

#include <stddef.h>
#include <stdint.h>

#define STAD_COST_MAX 32767 /* the largest storable cost; path rows are fenced with it */

/* -- prefilter: one row of pixels to feature planes (SPEC 2) ------------------------------------------------------------
 * above, row, below: `width * channels` interleaved samples, rows clamped to the image by the caller. planes: 2 * channels
 * planes of `width` bytes, the gradients of every channel first, then their intensities. 1 <= cap <= 32767, odd. */
void stad_prefilter_row_c(const uint8_t *above, const uint8_t *row, const uint8_t *below, int32_t width, int32_t channels,
                          int32_t cap, uint8_t *planes);

/* -- range: a plane to its value and half-sample bounds (SPEC 3) --------------------------------------------------------
 * out: three runs of `width` bytes: value, low, high. reverse != 0 stores column x at width - 1 - x, so that the right
 * image is read with ascending addresses as d ascends. */
void stad_range_row_c(const uint8_t *plane, int32_t width, int reverse, uint8_t *out);

/* -- cost: Birchfield-Tomasi cost of a run of columns (SPEC 3) ----------------------------------------------------------
 * left and right: feature rows, per plane {value, low, high} of `width` bytes, right reversed; gradient planes first.
 * Column i of the run is left pixel x + i against right pixels x + i - min_disparity - d; all of them inside the image.
 * cost: count * disparities. u8 only where channels * (min(2 cap, 255) + 63) <= 255. */
typedef struct stad_cost_job {
    const uint8_t *left, *right;
    int32_t width, channels;
    int32_t x, count;
    int32_t min_disparity, disparities;
} stad_cost_job;
void stad_cost_row_u8_c(const stad_cost_job *job, uint8_t *cost);
void stad_cost_row_u16_c(const stad_cost_job *job, uint16_t *cost);

/* -- block: the block cost C of a whole row, moved by a row (SPEC 4, no saturation possible) ----------------------------
 * in, out: whole cost rows of columns * disparities cells. block: as many; column x gains the costs of `in` and gives up those
 * of `out` in the columns x - r .. x + r, clamped to [0, columns). hs: scratch of D. C stays within 0..32767. */
typedef struct stad_block_job {
    const void *in, *out;
    int16_t *hs;
    int32_t columns, disparities, radius;
    int wide; /* costs are uint16_t, else uint8_t */
} stad_block_job;
void stad_block_row_c(const stad_block_job *job, int16_t *block);

/* -- box: vertical sums of cost rows, where no ring of them is kept (SPEC 4, no saturation possible) --------------------
 * sum += weight * cost, n cells. Sums stay within 0..32767. */
void stad_box_add_row_u8_c(int16_t *sum, const uint8_t *cost, int32_t n, int32_t weight);
void stad_box_add_row_u16_c(int16_t *sum, const uint16_t *cost, int32_t n, int32_t weight);

/* -- slide: horizontal sums of the vertical ones: the block cost C (SPEC 4, no saturation possible) ---------------------
 * sum: columns * disparities. block: count * disparities for columns x .. x + count - 1, each p2 + the sum of the columns
 * x - r .. x + r, clamped to [0, columns). */
typedef struct stad_slide_job {
    const int16_t *sum;
    int32_t columns, disparities, radius, p2;
    int32_t x, count;
} stad_slide_job;
void stad_slide_row_c(const stad_slide_job *job, int16_t *block);

/* -- path: one step of up to four paths for every pixel of a run (SPEC 5 and 6) -----------------------------------------
 * A lane holds the path costs L of one direction in `slots` slots of `stride` cells, D used, fenced by STAD_COST_MAX before
 * and after, and their least values. The k-th pixel reads slot (write + k + 1) mod slots and writes slot (write + k) mod
 * slots; the caller picks `write` so that the slot read holds the path's previous pixel. The kernel leaves `write` at the
 * next pixel's slot. block and total point at the first pixel taken; `step` is +1 or -1 column to the next. total: S; NULL:
 * not wanted; else written by the first lane when `fresh`, added to (saturating at 32767) otherwise.
 * stad_path_row: exact when C cannot saturate (STAD_COST_SAFE).
 * stad_path_row_sat: all int16 saturation of SPEC 5, in order. m + p2 <= 32767 there too: some d
 * of every pixel has L = C - p2. */
typedef struct stad_lane {
    int16_t *cost;  /* slot 0 */
    int16_t *least; /* one a slot */
    int32_t slots, write;
} stad_lane;
typedef struct stad_path_job {
    const int16_t *block;
    int16_t *total;
    int32_t count, disparities, stride, step;
    int32_t p1, p2;
    int fresh;
} stad_path_job;
void stad_path_row_c(const stad_path_job *job, stad_lane *lanes, int32_t lane_count);
void stad_path_row_sat_c(const stad_path_job *job, stad_lane *lanes, int32_t lane_count);

/* The same with p2 <= 255 and lanes that keep min(L - least, p2) in a byte, fenced by 255. */
typedef struct stad_lane_u8 {
    uint8_t *cost;
    int32_t slots, write;
} stad_lane_u8;
void stad_path_row_u8_c(const stad_path_job *job, stad_lane_u8 *lanes, int32_t lane_count);

/* Adds the stored costs of a lane to total for `count` pixels, the first in slot `slot`: total = sat(total + L). */
void stad_gather_row_c(int16_t *total, const stad_lane *lane, int32_t slot, const stad_path_job *job);

/* -- best: winner and runner-up of every pixel of a run (SPEC 8) --------------------------------------------------------
 * least: min S. index: the smallest d with S = least (best_row; -1 when least is 32767), or the 3WAY rule: of the largest
 * such d in each residue class mod 8 the smallest. runner_up: min S over |d - index| > 1. */
typedef struct stad_best {
    int16_t index, least, runner_up;
} stad_best;
void stad_best_row_c(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_best_row_3way_c(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);

/* -- last: the winners of a run, after its last path ------------------------------------------------------------------------
 * stad_path_row of the one lane, adding to S (lane NULL: no path is left), then stad_best_row of the run, or its 3WAY form.
 * The path goes left, step -1, and best[0] is the leftmost pixel's. A port that does both at once need not look at S again.
 * void stad_last_row(const stad_path_job *job, stad_lane *lane, int three_way, stad_best *best); the C form: kernel/last_row.h */

/* -- refine: winners to sub-pixel places (SPEC 8) ------------------------------------------------------------------------
 * fine[i]: 16 times the place of pixel i's winner, by the parabola through S at index - 1, index, index + 1; 16 * index at
 * either end of the range. */
void stad_refine_row_c(const int16_t *total, const stad_best *best, int32_t count, int32_t disparities, int16_t *fine);

/* -- select: winners to disparities, with uniqueness and right-view votes (SPEC 8) --------------------------------------
 * Takes the run from its last column to its first. disp: the row, `width` values preset to `none`. vote_disp and
 * vote_cost: the right view's best so far. confidence: the row's bytes, preset to 0, or NULL. */
typedef struct stad_select_job {
    const stad_best *best;
    const int16_t *fine;
    int32_t x, count; /* image column of the run's first pixel */
    int32_t width, min_disparity, uniqueness_ratio;
    int floor_rule; /* 3WAY's form of the uniqueness test */
    int16_t *disp, *vote_disp, *vote_cost;
    uint8_t *confidence;
    int32_t firm, rejected; /* counters, added to */
} stad_select_job;
void stad_select_row_c(stad_select_job *job);

/* -- check: left-right consistency of a finished row (SPEC 8) -----------------------------------------------------------
 * Sets failing columns of [x0, x1) to `none`; returns how many it set. */
typedef struct stad_check_job {
    int16_t *disp;
    const int16_t *vote_disp;
    int32_t x0, x1, width, min_disparity, max_diff;
} stad_check_job;
int32_t stad_check_row_c(const stad_check_job *job);

/* -- median: 3x3 median of three rows, columns replicated at the borders (SPEC 9) --------------------------------------- */
void stad_median_row_c(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out);

/* -- box, saturating: C where int16 can saturate (SPEC 4) ---------------------------------------------------------------
 * in, out: whole cost rows of columns * disparities cells; hs_in, hs_out: scratch of D. start != 0: the first rows of a
 * window: block = sat(block + weight * hs(in)). Otherwise block takes hs(in) and gives up hs(out), in the spec's order.
 * *_add_first: hs of that row adds before it subtracts; first_column_add_first, add_first: the order within C. */
typedef struct stad_box_sat_job {
    const void *in, *out;
    int16_t *hs_in, *hs_out;
    int32_t columns, disparities, radius, weight;
    int wide; /* costs are uint16_t, else uint8_t */
    int start, in_add_first, out_add_first, first_column_add_first, add_first;
} stad_box_sat_job;
void stad_box_sat_row_c(const stad_box_sat_job *job, int16_t *block);

#include "stad_port.h" /* binds each stad_<kernel> to the port's symbol, or to _c */

#endif
