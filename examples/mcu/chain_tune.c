/* SPDX-License-Identifier: MIT
 * examples/mcu/chain_tune.c - camera rows -> match -> score -> [TUNE] -> store
 *
 * Ask for a point, match the frame with it, score the rows as they come, tell the cost. The hash takes in every point and
 * cost, so that it shows the same trajectory on every core. */
#include "chain.h"
#include "expected.h"
#include "hash.h"
#include "say.h"
#include "scene.h"
#include "stad/score.h"
#include "stad/stad.h"
#include "stad/tune.h"

enum { WIDTH = 96, HEIGHT = 64, DISPARITIES = 16, MAX_BLOCK = 7, MAX_P2 = 2048, MAX_CAP = 63, EVALUATIONS = 20 };

static const scene view = {WIDTH, HEIGHT, DISPARITIES, 12, 7};
static const stad_geometry geometry = {WIDTH,          HEIGHT,           1, DISPARITIES, MAX_BLOCK, MAX_P2, MAX_CAP,
                                       STAD_MODE_SGBM, STAD_MEMORY_SMALL};

static stad_match matcher;
static stad_tune tune;

static void apply(const stad_point *x, stad_params *p)
{
    p->p1 = x->v[STAD_TUNE_P1];
    p->p2 = x->v[STAD_TUNE_P2];
    p->block_size = x->v[STAD_TUNE_BLOCK_SIZE];
    p->uniqueness_ratio = x->v[STAD_TUNE_UNIQUENESS_RATIO];
    p->pre_filter_cap = x->v[STAD_TUNE_PRE_FILTER_CAP];
    p->disp12_max_diff = x->v[STAD_TUNE_DISP12_MAX_DIFF];
}

/* One evaluation: a frame through matcher and scorer; truth is made again as the rows come out. */
static int32_t cost_of(const stad_params *p)
{
    static uint8_t left[WIDTH], right[WIDTH], label[WIDTH];
    static int16_t disp_q4[WIDTH];
    static int32_t truth_q16[WIDTH], scratch[WIDTH];
    stad_score_config config;
    stad_score score;
    int y, row;
    stad_score_config_init(&config, STAD_SCORE_CHOW, 0, DISPARITIES);
    if (stad_score_begin(&score, &config) != STAD_OK || stad_match_begin(&matcher, p) != STAD_OK)
        return STAD_COST_FAILED;
    for (y = 0; y < HEIGHT; y++) {
        scene_row(&view, y, left, right, NULL);
        if (stad_match_push(&matcher, left, right) != STAD_OK)
            return STAD_COST_FAILED;
        while ((row = stad_match_pull(&matcher, disp_q4)) >= 0) {
            scene_row(&view, row, left, right, truth_q16);
            stad_score_label_row(truth_q16, WIDTH, label, scratch);
            stad_score_row(&score, row, disp_q4, truth_q16, label, WIDTH);
        }
    }
    return stad_score_end(&score);
}

/* Searches within what the geometry affords. */
static int start(void)
{
    static const stad_point first = {{72, 288, 3, 10, 63, 1}};
    stad_tune_config config;
    stad_tune_config_stereo(&config, STAD_TUNE_FOR_ANY);
    config.budget = EVALUATIONS;
    config.axis[STAD_TUNE_P1].hi = MAX_P2 / 2;
    config.axis[STAD_TUNE_P2].hi = MAX_P2;
    config.axis[STAD_TUNE_BLOCK_SIZE].hi = MAX_BLOCK;
    config.axis[STAD_TUNE_PRE_FILTER_CAP].hi = MAX_CAP;
    return stad_match_init(&matcher, &geometry, work, work_bytes) == STAD_OK &&
           stad_tune_ncg_init(&tune, &config, &first) == STAD_OK;
}

int chain_tune(stad_params *best)
{
    stad_point x;
    int32_t cost_q20, first_q20 = -1;
    uint32_t hash = HASH_START;
    int i;
    if (!start())
        return chain_agrees("tune", 0, EXPECT_TUNE);
    stad_params_sample(best, DISPARITIES, 3, 1);
    while (stad_tune_ask(&tune, &x) == 1) {
        apply(&x, best);
        cost_q20 = cost_of(best);
        for (i = 0; i < STAD_TUNE_DIMS; i++)
            hash = hash_add(hash, (uint16_t)x.v[i], 2);
        hash = hash_add(hash, (uint32_t)cost_q20, 4);
        first_q20 = first_q20 < 0 ? cost_q20 : first_q20;
        if (stad_tune_ncg_tell(&tune, cost_q20) != STAD_OK)
            break;
    }
    stad_tune_best(&tune, &x, &cost_q20);
    apply(&x, best);
    say("tune: cost ");
    say_dec(first_q20);
    say(" -> ");
    say_dec(cost_q20);
    say(" / 2^20 in ");
    say_dec(stad_tune_counts_of(&tune).evaluations);
    say(" evaluations\n");
    return chain_agrees("tune", hash, EXPECT_TUNE);
}
