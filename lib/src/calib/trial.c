/* SPDX-License-Identifier: MIT
 * truth -> pick -> judge -> tune -> [TRIAL] -> adopt        calib/trial.c - the order of the matches and the decision
 *
 * On the tuning frame: the set in use (step 0), then the presets (step 1 + i). On the other pose: the set in use (0),
 * the pick (1), which is dropped if it is worse there. On the tuning frame: a descent from what is left. On the other
 * pose: the tuned set (2). Each is one MATCH request. */
#include "calib/calib_parts.h"

enum judged { JUDGE_ACTIVE = 0, JUDGE_PICK = 1, JUDGE_TUNED = 2 };

static stad_point active_point(const stad_calib *c)
{
    return stad_calib_point_of(&c->active.params);
}

static int preset_fits(const stad_calib *c, int i, stad_point *point)
{
    if (!(c->config.preset_mask >> i & 1) || stad_calib_preset(i, c->config.geometry.channels, point, NULL) != STAD_OK)
        return 0;
    stad_params params = stad_calib_params_at(&c->active.params, point);
    return params.block_size >= c->config.min_block_size && stad_calib_fits(&c->config.geometry, &params);
}

static int pick_is_active(const stad_calib *c)
{
    stad_point active = active_point(c);
    return stad_calib_point_equal(&c->pick, &active);
}

void stad_calib_trial_begin(stad_calib *c)
{
    c->pick = active_point(c);
    c->pick_q20 = STAD_COST_FAILED;
    c->pick_score_q20 = STAD_COST_FAILED;
    c->tuned_q20 = STAD_COST_FAILED;
    for (int i = 0; i < 3; i++)
        c->judged_q20[i] = STAD_COST_FAILED;
    c->report.preset = -1;
    c->report.tuned = 0;
    stad_calib_enter(c, STAD_CALIB_PICK);
}

void stad_calib_trial_point(const stad_calib *c, stad_point *point)
{
    *point = active_point(c);
    if (c->report.phase == STAD_CALIB_TUNE)
        stad_tune_ask(&c->tune, point);
    else if (c->report.phase == STAD_CALIB_PICK && c->step > 0)
        stad_calib_preset(c->step - 1, c->config.geometry.channels, point, NULL);
    else if (c->report.phase == STAD_CALIB_JUDGE && c->step == JUDGE_PICK)
        *point = c->pick;
    else if (c->report.phase == STAD_CALIB_JUDGE && c->step == JUDGE_TUNED)
        *point = c->tuned;
    else if (c->report.phase == STAD_CALIB_COMPARE && c->step == 1)
        *point = stad_calib_point_of(&c->previous.params);
}

int stad_calib_trial_hold(const stad_calib *c)
{
    return c->report.phase == STAD_CALIB_JUDGE ? 1 : 0;
}

/* -- the decision ------------------------------------------------------------------------------------------------ */

static int32_t judge_margin(const stad_calib *c, int32_t cost_q20)
{
    return stad_calib_margin(cost_q20, stad_truth_pixels(&c->pose[1].truth), c->config.gain_q20);
}

/* The tuned set against what it was tuned from. */
static int tuned_holds(const stad_calib *c)
{
    int32_t was = c->judged_q20[pick_is_active(c) ? JUDGE_ACTIVE : JUDGE_PICK];
    return stad_calib_is_better(c->judged_q20[JUDGE_TUNED], was, judge_margin(c, was));
}

static int choose(const stad_calib *c)
{
    int pick = pick_is_active(c) ? JUDGE_ACTIVE : JUDGE_PICK;
    if (c->config.rule == STAD_RULE_NONE)
        return c->tuned_q20 != STAD_COST_FAILED ? JUDGE_TUNED : pick;
    if (c->config.rule == STAD_RULE_DEFAULT)
        return tuned_holds(c) ? JUDGE_TUNED : pick;
    int32_t was = c->judged_q20[JUDGE_ACTIVE];
    int best = c->judged_q20[JUDGE_TUNED] < c->judged_q20[pick] ? JUDGE_TUNED : pick;
    return stad_calib_is_better(c->judged_q20[best], was, judge_margin(c, was)) ? best : JUDGE_ACTIVE;
}

/* A pose on which three quarters are wrong with the set in use tells nothing of parameters. The worst of the trials
 * that docs/LOOP.md reports, noise 20, has 60 of 100. */
static int is_no_judge(const stad_calib *c)
{
    return c->config.rule != STAD_RULE_NONE && c->judged_q20[JUDGE_ACTIVE] > 3 * (STAD_COST_ONE / 4);
}

static void decide(stad_calib *c)
{
    const int no_judge = is_no_judge(c), chosen = no_judge ? JUDGE_ACTIVE : choose(c);
    const int32_t judged_q20 = c->judged_q20[chosen];
    stad_point point = active_point(c);
    c->alarm_stands |= (uint8_t)no_judge;
    c->report.tune_after_q20 = c->report.tune_before_q20;
    c->report.judge_after_q20 = judged_q20 != STAD_COST_FAILED ? judged_q20 : -1;
    if (chosen == JUDGE_PICK) {
        point = c->pick;
        c->report.tune_after_q20 = c->pick_q20;
        c->candidate.origin = STAD_ORIGIN_PRESET;
    } else if (chosen == JUDGE_TUNED) {
        point = c->tuned;
        c->report.tuned = 1;
        c->report.tune_after_q20 = c->tuned_q20;
        c->candidate.origin = STAD_ORIGIN_TUNED;
    }
    c->candidate.params = stad_calib_params_at(&c->active.params, &point);
    stad_calib_adopt(c);
}

/* -- from one match to the next ---------------------------------------------------------------------------------- */

static void judge_tuned(stad_calib *c)
{
    if (c->tuned_q20 == STAD_COST_FAILED || stad_calib_point_equal(&c->tuned, &c->pick)) {
        c->tuned_q20 = STAD_COST_FAILED; /* nothing beyond the pick */
        decide(c);
        return;
    }
    stad_calib_enter(c, STAD_CALIB_JUDGE);
    c->step = JUDGE_TUNED;
}

static void tune(stad_calib *c)
{
    stad_tune_config config;
    int budget = c->config.budget - c->report.evaluations - 1;
    if (!c->config.tunes || budget < 2) {
        decide(c);
        return;
    }
    stad_calib_tune_config(c, budget < STAD_TUNE_LOG ? budget : STAD_TUNE_LOG, &config);
    if (stad_tune_descent_init(&c->tune, &config, &c->pick) != STAD_OK) {
        decide(c);
        return;
    }
    stad_calib_enter(c, STAD_CALIB_TUNE);
}

/* A pick is worse on the other pose than the set in use, its handicap counted. */
static int pick_is_worse(const stad_calib *c)
{
    int32_t score_q20 = stad_calib_raised(c->judged_q20[JUDGE_PICK], stad_calib_handicap_q16(c->report.preset));
    return score_q20 > c->judged_q20[JUDGE_ACTIVE];
}

/* ... then it is dropped before tuning starts from it. */
static void judged(stad_calib *c, int32_t cost_q20)
{
    c->judged_q20[c->step] = cost_q20;
    if (c->step == JUDGE_TUNED) {
        decide(c);
        return;
    }
    if (c->step == JUDGE_ACTIVE && !pick_is_active(c)) {
        c->step = JUDGE_PICK;
        return;
    }
    c->report.judge_before_q20 = c->judged_q20[JUDGE_ACTIVE];
    if (c->step == JUDGE_PICK && c->config.rule != STAD_RULE_NONE && pick_is_worse(c)) {
        c->pick = active_point(c);
        c->pick_q20 = c->report.tune_before_q20;
        c->report.preset = -1;
    }
    tune(c);
}

static void picked(stad_calib *c, int32_t cost_q20)
{
    stad_point point;
    stad_calib_trial_point(c, &point);
    if (c->step == 0)
        c->report.tune_before_q20 = cost_q20;
    int32_t score_q20 = stad_calib_raised(cost_q20, stad_calib_handicap_q16(c->step - 1));
    if (score_q20 < c->pick_score_q20) {
        c->pick = point;
        c->pick_q20 = cost_q20;
        c->pick_score_q20 = score_q20;
        c->report.preset = (int8_t)(c->step - 1);
    }
    do {
        c->step++;
    } while (c->step <= STAD_PRESETS && !preset_fits(c, c->step - 1, &point));
    if (c->step > STAD_PRESETS)
        stad_calib_enter(c, STAD_CALIB_JUDGE);
}

static void tuned(stad_calib *c, int32_t cost_q20)
{
    stad_point point, best;
    int32_t best_cost;
    stad_tune_ask(&c->tune, &point);
    stad_tune_descent_tell(&c->tune, stad_calib_penalised(&c->pick, &point, cost_q20, c->config.penalty_q16));
    if (stad_tune_best(&c->tune, &best, &best_cost) == STAD_OK && stad_calib_point_equal(&best, &point)) {
        c->tuned = point;
        c->tuned_q20 = cost_q20;
    }
    if (stad_tune_ask(&c->tune, &point) == 0)
        judge_tuned(c);
}

/* The second look: what was adopted must not be worse than what it replaced. */
static void compared(stad_calib *c, int32_t cost_q20)
{
    if (c->step == 0) {
        c->compared_q20 = cost_q20;
        c->step = 1;
        return;
    }
    int32_t margin = stad_calib_margin(cost_q20, stad_truth_pixels(&c->pose[0].truth), c->config.gain_q20);
    if (stad_calib_is_better(cost_q20, c->compared_q20, margin))
        stad_calib_roll_back(c);
    else
        stad_calib_finish(c, STAD_CALIB_ADOPTED);
}

/* Does all else hang on this cost? That of the set in use, the first of PICK and of JUDGE; in COMPARE, when the new set's is not to
 * be had either. */
static int is_needed(const stad_calib *c)
{
    if (c->report.phase == STAD_CALIB_COMPARE)
        return c->step == 1 && c->compared_q20 == STAD_COST_FAILED;
    return c->step == 0 && c->report.phase != STAD_CALIB_TUNE;
}

void stad_calib_trial_cost(stad_calib *c, int32_t cost_q20)
{
    if (cost_q20 == STAD_COST_FAILED && is_needed(c)) {
        c->report.fault = STAD_FAULT_MATCH;
        stad_calib_give_up(c);
        return;
    }
    if (c->report.phase != STAD_CALIB_COMPARE)
        c->report.evaluations++;
    if (c->report.phase == STAD_CALIB_PICK)
        picked(c, cost_q20);
    else if (c->report.phase == STAD_CALIB_JUDGE)
        judged(c, cost_q20);
    else if (c->report.phase == STAD_CALIB_TUNE)
        tuned(c, cost_q20);
    else
        compared(c, cost_q20);
}
