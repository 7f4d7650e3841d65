/* SPDX-License-Identifier: MIT
 * examples/03_tune.c - the tuner in a loop of the application's own: ask, match, score, tell.
 *
 * The geometry is built for the largest values that the tuner may ask for, so one workspace serves the whole search. */
#include <stad/stad.h>
#include <stdio.h>

#include "dots.h"

enum { W = 192, H = 64, D = 16, BLOCK = 7, P2 = 2048, CAP = 127 };

static uint8_t work[STAD_MATCH_BYTES(W, H, 1, D, BLOCK, P2, CAP, STAD_MODE_SGBM, STAD_MEMORY_FAST)] STAD_ALIGNED;
static stad_match matcher;
static stad_tune tuner;

static void params_of(const stad_point *x, stad_params *p)
{
    stad_params_sample(p, D, 3, 1);
    p->p1 = x->v[STAD_TUNE_P1];
    p->p2 = x->v[STAD_TUNE_P2];
    p->block_size = x->v[STAD_TUNE_BLOCK_SIZE];
    p->uniqueness_ratio = x->v[STAD_TUNE_UNIQUENESS_RATIO];
    p->pre_filter_cap = x->v[STAD_TUNE_PRE_FILTER_CAP];
    p->disp12_max_diff = x->v[STAD_TUNE_DISP12_MAX_DIFF];
}

/* Matches a noisy frame and scores it row by row: nothing but rows is stored. */
static int32_t cost_of(const stad_point *x)
{
    uint8_t left[W], right[W], label[W];
    int16_t disp_q4[W];
    int32_t truth_q16[W], scratch[W];
    stad_score score;
    stad_score_config config;
    stad_params p;
    params_of(x, &p);
    stad_score_config_init(&config, STAD_SCORE_BAD, p.min_disparity, p.num_disparities);
    if (stad_match_begin(&matcher, &p) != STAD_OK || stad_score_begin(&score, &config) != STAD_OK)
        return STAD_COST_FAILED;
    dots_truth(W, STAD_TRUTH_NONE, truth_q16);
    stad_score_label_row(truth_q16, W, label, scratch);
    for (int y = 0; y < H; y++) {
        int row;
        dots_row(y, W, 60, left, right);
        stad_match_push(&matcher, left, right);
        while ((row = stad_match_pull(&matcher, disp_q4)) >= 0)
            stad_score_row(&score, row, disp_q4, truth_q16, label, W);
    }
    return stad_score_end(&score);
}

int main(void)
{
    const stad_geometry geometry = {W, H, 1, D, BLOCK, P2, CAP, STAD_MODE_SGBM, STAD_MEMORY_FAST};
    const stad_point start = {{2, 5, 3, 0, 15, 1}}; /* cv::StereoSGBM::create()'s own */
    stad_tune_config config;
    stad_point x;
    int32_t first, best;
    stad_tune_config_stereo(&config, STAD_TUNE_FOR_ANY);
    config.budget = 60;
    config.axis[STAD_TUNE_BLOCK_SIZE].hi = BLOCK; /* what the geometry affords */
    config.axis[STAD_TUNE_P2].hi = P2;
    config.axis[STAD_TUNE_PRE_FILTER_CAP].hi = CAP;
    if (stad_match_init(&matcher, &geometry, work, sizeof work) != STAD_OK || stad_tune_init(&tuner, &config, &start) != STAD_OK)
        return 1;

    while (stad_tune_ask(&tuner, &x) == 1)
        stad_tune_tell(&tuner, cost_of(&x));

    if (stad_tune_trace(&tuner, 0, &x, &first) != STAD_OK || stad_tune_best(&tuner, &x, &best) != STAD_OK)
        return 1;
    printf("%d evaluations: bad %.2f %% -> %.2f %% at p1 %d, p2 %d, block %d, uniqueness %d, cap %d, disp12 "
           "%d\n",
           stad_tune_counts_of(&tuner).evaluations, 100.0 * first / STAD_COST_ONE, 100.0 * best / STAD_COST_ONE,
           x.v[STAD_TUNE_P1], x.v[STAD_TUNE_P2], x.v[STAD_TUNE_BLOCK_SIZE], x.v[STAD_TUNE_UNIQUENESS_RATIO],
           x.v[STAD_TUNE_PRE_FILTER_CAP], x.v[STAD_TUNE_DISP12_MAX_DIFF]);
    return best < first ? 0 : 1;
}
