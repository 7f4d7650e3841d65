/* SPDX-License-Identifier: MIT
 * proof/prove_match.h - the passes of the matcher around the kernels, for prove_match_*.c, a mode a file.
 *
 * Where a row lies, that it was written before it is read, and that what a kernel is given is what kernel/kernel.h asks for: every
 * memory plan with costs that can saturate and costs that cannot, in bytes and in words, one row and many, any pixels, parameters of
 * the ranges in `kinds`; whole frames, and frames again from their winners.
 *
 * In the kernels' place stand models of their contracts: each asserts that what it may read has been written and that what it may
 * write is there, and leaves any value in that. That the kernels keep to the contracts show prove_rows.c, prove_costs.c,
 * prove_paths.c, wp_*.c and the guarded buffers of test/kernel. */
#ifndef PROVE_MATCH_H
#define PROVE_MATCH_H

#include "kernel/kernel.h"
#include "proof/prove.h"
#include "stad/stad.h"

static void reads(const void *p, long n)
{
    const uint8_t *bytes = p;
    //@ assert n <= 0 || \initialized(bytes + (0 .. n - 1));
    (void)bytes;
}

/* Any bytes, and they are there. */
static void writes(void *p, long n)
{
    uint8_t *bytes = p;
    //@ assert n <= 0 || \valid(bytes + (0 .. n - 1));
    if (n > 0)
        Frama_C_make_unknown((char *)bytes, (unsigned long)n);
}

static void changes(void *p, long n)
{
    reads(p, n);
    writes(p, n);
}

/* -- from pixels to block costs ---------------------------------------------------------------------------------------------- */

void stad_prefilter_row_c(const uint8_t *above, const uint8_t *row, const uint8_t *below, int32_t width, int32_t channels,
                          int32_t cap, uint8_t *planes)
{
    //@ assert 1 <= cap <= 32767;
    reads(above, (long)width * channels);
    reads(row, (long)width * channels);
    reads(below, (long)width * channels);
    writes(planes, 2L * channels * width);
}

void stad_range_row_c(const uint8_t *plane, int32_t width, int reverse, uint8_t *out)
{
    (void)reverse;
    reads(plane, width);
    writes(out, 3L * width);
}

static void cost_row(const stad_cost_job *job, void *cost, int bytes)
{
    const int32_t last = job->width - 1 - job->x + job->min_disparity;
    //@ assert 0 <= job->x && job->x + job->count <= job->width && 0 <= last - job->count + 1 && last + job->disparities <= job->width;
    for (int32_t p = 0; p < 6 * job->channels; p++) {
        reads(job->left + p * job->width + job->x, job->count);
        reads(job->right + p * job->width + last - job->count + 1, job->count - 1 + job->disparities);
    }
    writes(cost, (long)job->count * job->disparities * bytes);
}

void stad_cost_row_u8_c(const stad_cost_job *job, uint8_t *cost)
{
    cost_row(job, cost, 1);
}

void stad_cost_row_u16_c(const stad_cost_job *job, uint16_t *cost)
{
    cost_row(job, cost, 2);
}

void stad_block_row_c(const stad_block_job *job, int16_t *block)
{
    const long cells = (long)job->columns * job->disparities;
    reads(job->in, cells * (job->wide ? 2 : 1));
    reads(job->out, cells * (job->wide ? 2 : 1));
    writes(job->hs, 2L * job->disparities);
    changes(block, 2 * cells);
}

void stad_box_add_row_u8_c(int16_t *sum, const uint8_t *cost, int32_t n, int32_t weight)
{
    //@ assert weight == 1 || weight == -1;
    reads(cost, n);
    changes(sum, 2L * n);
}

void stad_box_add_row_u16_c(int16_t *sum, const uint16_t *cost, int32_t n, int32_t weight)
{
    //@ assert weight == 1 || weight == -1;
    reads(cost, 2L * n);
    changes(sum, 2L * n);
}

void stad_box_sat_row_c(const stad_box_sat_job *job, int16_t *block)
{
    const long cells = (long)job->columns * job->disparities;
    //@ assert 1 <= job->weight <= 16384 && 0 <= job->radius < job->columns;
    reads(job->in, cells * (job->wide ? 2 : 1));
    if (!job->start)
        reads(job->out, cells * (job->wide ? 2 : 1));
    writes(job->hs_in, 2L * job->disparities);
    writes(job->hs_out, 2L * job->disparities);
    changes(block, 2 * cells);
}

void stad_slide_row_c(const stad_slide_job *job, int16_t *block)
{
    //@ assert 0 <= job->x && job->x + job->count <= job->columns;
    reads(job->sum, 2L * job->columns * job->disparities);
    writes(block, 2L * job->count * job->disparities);
}

/* -- paths ------------------------------------------------------------------------------------------------------------------- */

/* Block costs and sums of a run, whichever way it is taken. */
static void run_of(const stad_path_job *job)
{
    const long back = job->step > 0 ? 0 : (long)(job->count - 1) * job->disparities, cells = (long)job->count * job->disparities;
    //@ assert job->step == 1 || job->step == -1;
    //@ assert 1 <= job->p1 < job->p2 <= 32767;
    reads(job->block - back, 2 * cells);
    if (!job->total)
        return;
    if (!job->fresh)
        reads(job->total - back, 2 * cells);
    writes(job->total - back, 2 * cells);
}

/* Every pixel reads the slot after the one it writes, with the fences to either side. */
static void lanes_of(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
{
    run_of(job);
    for (int32_t k = 0; k < lane_count; k++)
        for (int32_t i = 0; i < job->count; i++) {
            stad_lane *lane = &lanes[k];
            //@ assert 0 <= lane->write < lane->slots;
            const int32_t from = lane->write + 1 == lane->slots ? 0 : lane->write + 1;
            reads(lane->cost + (long)from * job->stride - 1, 2L * (job->disparities + 2));
            reads(lane->least + from, 2);
            writes(lane->cost + (long)lane->write * job->stride, 2L * job->disparities);
            writes(lane->least + lane->write, 2);
            lane->write = from;
        }
}

void stad_path_row_c(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
{
    lanes_of(job, lanes, lane_count);
}

void stad_path_row_sat_c(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
{
    lanes_of(job, lanes, lane_count);
}

void stad_path_row_u8_c(const stad_path_job *job, stad_lane_u8 *lanes, int32_t lane_count)
{
    //@ assert job->p2 <= 255;
    run_of(job);
    for (int32_t k = 0; k < lane_count; k++)
        for (int32_t i = 0; i < job->count; i++) {
            stad_lane_u8 *lane = &lanes[k];
            //@ assert 0 <= lane->write < lane->slots;
            const int32_t from = lane->write + 1 == lane->slots ? 0 : lane->write + 1;
            reads(lane->cost + (long)from * job->stride - 1, job->disparities + 2L);
            writes(lane->cost + (long)lane->write * job->stride, job->disparities);
            lane->write = from;
        }
}

void stad_gather_row_c(int16_t *total, const stad_lane *lane, int32_t slot, const stad_path_job *job)
{
    for (int32_t i = 0; i < job->count; i++) {
        //@ assert 0 <= slot < lane->slots;
        reads(lane->cost + (long)slot * job->stride, 2L * job->disparities);
        slot = slot + 1 == lane->slots ? 0 : slot + 1;
    }
    changes(total, 2L * job->count * job->disparities);
}

/* -- winners ----------------------------------------------------------------------------------------------------------------- */

static void best_row(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    reads(total, 2L * count * disparities);
    for (int32_t i = 0; i < count; i++) {
        best[i].index = (int16_t)any(-1, disparities - 1);
        best[i].least = (int16_t)any(-32768, 32767);
        best[i].runner_up = (int16_t)any(-32768, 32767);
    }
}

void stad_best_row_c(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    best_row(total, count, disparities, best);
}

void stad_best_row_3way_c(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    best_row(total, count, disparities, best);
}

void stad_refine_row_c(const int16_t *total, const stad_best *best, int32_t count, int32_t disparities, int16_t *fine)
{
    reads(total, 2L * count * disparities);
    reads(best, (long)sizeof(stad_best) * count);
    writes(fine, 2L * count);
}

void stad_select_row_c(stad_select_job *job)
{
    //@ assert 0 <= job->x && job->x + job->count <= job->width && 0 <= job->uniqueness_ratio < 100;
    reads(job->best, (long)sizeof(stad_best) * job->count);
    reads(job->fine, 2L * job->count);
    reads(job->disp, 2L * job->width);
    writes(job->disp + job->x, 2L * job->count);
    reads(job->vote_disp, 2L * job->width);
    changes(job->vote_cost, 2L * job->width);
    any_i16(job->vote_disp, job->width, -2048, 2047);
    if (job->confidence)
        writes(job->confidence + job->x, job->count);
    job->firm += any(0, job->count);
    job->rejected += any(0, job->count);
}

int32_t stad_check_row_c(const stad_check_job *job)
{
    //@ assert 0 <= job->x0 <= job->x1 <= job->width && job->max_diff >= 1;
    reads(job->disp, 2L * job->width);
    reads(job->vote_disp, 2L * job->width);
    writes(job->disp + job->x0, 2L * (job->x1 - job->x0));
    return any(0, job->x1 - job->x0);
}

void stad_median_row_c(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out)
{
    reads(above, 2L * width);
    reads(row, 2L * width);
    reads(below, 2L * width);
    writes(out, 2L * width);
}

/* -- frames ------------------------------------------------------------------------------------------------------------------ */

enum { WIDTH = 40, HEIGHT = 7, D = 16, MOST = 200000 };

/* Costs and paths in bytes; in words; saturating, the block higher than the image; one row of three channels. */
static const struct kind {
    int16_t height, channels, most_d, block, p2_from, p2_to, half_cap_from, half_cap_to, min_disparity;
} kinds[4] = {{HEIGHT, 1, 24, 3, 100, 200, 7, 31, -1},
              {HEIGHT, 1, 16, 3, 256, 20000, 48, 63, 0},
              {HEIGHT, 1, 16, 11, 256, 20000, 63, 63, 1},
              {1, 3, 24, 1, 256, 20000, 48, 63, 2}};

static uint8_t left[WIDTH * HEIGHT * 3], right[WIDTH * HEIGHT * 3];
static int16_t disp[WIDTH * HEIGHT];

static void any_pixels(void)
{
    Frama_C_make_unknown((char *)left, sizeof left);
    Frama_C_make_unknown((char *)right, sizeof right);
}

static stad_geometry geometry_of(const struct kind *k, int mode, int memory)
{
    const stad_geometry g = {
        WIDTH,         k->height,      k->channels, k->most_d, k->block, k->p2_to, (int16_t)(2 * k->half_cap_to + 1),
        (uint8_t)mode, (uint8_t)memory};
    return g;
}

static stad_params params_of(const struct kind *k)
{
    stad_params p = {k->min_disparity,
                     D,
                     k->block,
                     (int16_t)any(1, 99),
                     (int16_t)any(k->p2_from, k->p2_to),
                     (int16_t)any(1, 32767),
                     (int16_t)(2 * any(k->half_cap_from, k->half_cap_to) + 1),
                     (int16_t)any(0, 99),
                     0,
                     any(0, 1000)};
    return p;
}

/* A whole frame, its winners kept, and once more from these. */
static void frame(const stad_geometry *g, const stad_params *p, unsigned options)
{
    uint8_t work[MOST] STAD_ALIGNED, kept[STAD_WINNERS_BYTES(WIDTH, HEIGHT)] STAD_ALIGNED;
    stad_match m;
    stad_winners winners;
    const stad_image l = stad_image_packed(left, g->width, g->height, g->channels);
    const stad_image r = stad_image_packed(right, g->width, g->height, g->channels);
    const size_t bytes = stad_match_bytes(g);
    //@ assert 0 < bytes <= 200000;
    if (stad_match_init(&m, g, work, bytes) != STAD_OK || stad_winners_init(&winners, g, kept, sizeof kept) != STAD_OK)
        return; /* an address is not known to be aligned */
    stad_match_options(&m, options);
    stad_match_keep(&m, &winners);
    int status = stad_match_frame(&m, p, &l, &r, disp, g->width, NULL, 0);
    //@ assert status == 0;
    stad_params q = *p;
    q.p1 = 10;
    q.p2 = g->max_p2;
    q.pre_filter_cap = g->max_pre_filter_cap;
    winners.params = q; /* of a range it is not known that it equals itself */
    status = stad_match_frame_again(&m, &q, &winners, disp, g->width, NULL, 0);
    //@ assert status == 0;
}

static void frames_of(int mode)
{
    any_pixels();
    for (int memory = STAD_MEMORY_FAST; memory <= STAD_MEMORY_SMALL; memory++)
        for (int kind = 0; kind < 4; kind++) {
            const stad_geometry g = geometry_of(&kinds[kind], mode, memory);
            const stad_params p = params_of(&kinds[kind]);
            frame(&g, &p, (unsigned)kind);
        }
}

#endif
