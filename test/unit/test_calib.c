/* SPDX-License-Identifier: MIT
 * test_calib.c - the pump without pixels: costs are made up, and the decision, the order and the ends are looked at. */
#include <stdio.h>
#include <string.h>

#include "calib_pump.h"

typedef int32_t cost_fn(const stad_request *r);

/* Runs a trial to its end, answering MATCH from `cost` and SAVE with success. Returns the number of matches. */
static int run_trial(cost_fn *cost)
{
    stad_request r;
    int matches = 0;
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_init(&calib, &config, &setup));
    hold_poses();
    stad_calib_trial_begin(&calib);
    for (int i = 0; i < 1000; i++) {
        int want = stad_calib_want(&calib, &r);
        if (want == STAD_WANT_MATCH) {
            matches++;
            TEST_ASSERT_EQUAL(STAD_OK, stad_params_check(&r.params, STAD_MODE_SGBM, 320, NULL));
            TEST_ASSERT_EQUAL(STAD_OK, stad_calib_cost(&calib, cost(&r)));
        } else if (want == STAD_WANT_SAVE) {
            TEST_ASSERT_EQUAL(STAD_OK, stad_calib_saved(&calib, STAD_SLOT_A));
        } else {
            return matches;
        }
    }
    TEST_FAIL_MESSAGE("the trial did not end");
    return 0;
}

static int changed(void)
{
    return memcmp(&setup.params, &stad_calib_setup(&calib)->params, sizeof setup.params) != 0;
}

static int is_preset(const stad_params *p)
{
    stad_point x = stad_calib_point_of(p), preset;
    for (int i = 0; i < STAD_PRESETS; i++)
        if (stad_calib_preset(i, 1, &preset, NULL) == STAD_OK && stad_calib_point_equal(&x, &preset))
            return 1;
    return 0;
}

static int is_start(const stad_params *p)
{
    return memcmp(p, &setup.params, sizeof *p) == 0;
}

/* -- costs ------------------------------------------------------------------------------------------------------- */

static int32_t flat(const stad_request *r)
{
    (void)r;
    return POINTS(20);
}

static int32_t failing(const stad_request *r)
{
    (void)r;
    return STAD_COST_FAILED;
}

static int32_t failing_on_other_pose(const stad_request *r)
{
    return r->hold == 0 ? POINTS(20) : STAD_COST_FAILED;
}

/* Presets gain 3 points on both poses, everything else nothing. */
static int32_t presets_help(const stad_request *r)
{
    return is_preset(&r->params) && !is_start(&r->params) ? POINTS(17) : POINTS(20);
}

/* ... on the tuning pose only; on the other they lose. */
static int32_t presets_deceive(const stad_request *r)
{
    return r->hold == 0 ? presets_help(r) : is_start(&r->params) ? POINTS(20) : POINTS(21);
}

/* ... on the other nothing but the set in use can be matched. */
static int32_t presets_fail_on_other_pose(const stad_request *r)
{
    return r->hold == 0 ? presets_help(r) : is_start(&r->params) ? POINTS(20) : STAD_COST_FAILED;
}

static int32_t presets_help_a_little(const stad_request *r)
{
    return is_preset(&r->params) && !is_start(&r->params) ? POINTS(37) / 2 : POINTS(20);
}

/* Less than any handicap raises it. */
static int32_t presets_help_by_chance(const stad_request *r)
{
    return is_preset(&r->params) && !is_start(&r->params) ? POINTS(39) / 2 : POINTS(20);
}

static int32_t away_from(int value, int best, int unit)
{
    int d = value > best ? value - best : best - value;
    return POINTS(1) * d / unit;
}

/* A bowl with its floor at uniqueness 6, cap 31, 20 points deep. */
static int32_t bowl(const stad_request *r)
{
    return POINTS(10) + away_from(r->params.uniqueness_ratio, 6, 2) + away_from(r->params.pre_filter_cap, 31, 8);
}

static int32_t bowl_on_tuning_pose_only(const stad_request *r)
{
    return r->hold == 0 ? bowl(r) : POINTS(20);
}

/* -- the decision ------------------------------------------------------------------------------------------------ */

void test_calib_equal_costs_keep_what_is_in_use(void)
{
    run_trial(flat);
    TEST_ASSERT_EQUAL(STAD_CALIB_KEPT, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_FALSE(changed());
}

/* A run that ended because the set in use could not be matched: it is kept, and no cost is claimed that was not measured. */
static void expect_match_fault(void)
{
    TEST_ASSERT_EQUAL(STAD_CALIB_IDLE, stad_calib_report_of(&calib)->phase);
    TEST_ASSERT_EQUAL(STAD_CALIB_FAULT, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_EQUAL(STAD_FAULT_MATCH, stad_calib_report_of(&calib)->fault);
    TEST_ASSERT_EQUAL(-1, stad_calib_report_of(&calib)->tune_after_q20);
    TEST_ASSERT_EQUAL(-1, stad_calib_report_of(&calib)->judge_before_q20);
    TEST_ASSERT_EQUAL(-1, stad_calib_report_of(&calib)->judge_after_q20);
    TEST_ASSERT_FALSE(changed());
}

void test_calib_set_in_use_that_cannot_be_matched_is_a_fault(void)
{
    TEST_ASSERT_EQUAL(1, run_trial(failing));
    expect_match_fault();
    TEST_ASSERT_EQUAL(-1, stad_calib_report_of(&calib)->tune_before_q20);
    run_trial(failing_on_other_pose);
    expect_match_fault();
    TEST_ASSERT_EQUAL(POINTS(20), stad_calib_report_of(&calib)->tune_before_q20);
}

void test_calib_cost_not_measured_on_other_pose_is_not_reported(void)
{
    config.rule = STAD_RULE_NONE;
    config.probation_frames = 0;
    run_trial(presets_fail_on_other_pose);
    TEST_ASSERT_TRUE(changed());
    TEST_ASSERT_EQUAL(POINTS(20), stad_calib_report_of(&calib)->judge_before_q20);
    TEST_ASSERT_EQUAL(-1, stad_calib_report_of(&calib)->judge_after_q20);
}

void test_calib_helping_preset_is_adopted(void)
{
    config.probation_frames = 0;
    run_trial(presets_help);
    TEST_ASSERT_EQUAL(STAD_CALIB_ADOPTED, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_TRUE(is_preset(&stad_calib_setup(&calib)->params));
    TEST_ASSERT_EQUAL(STAD_ORIGIN_PRESET, stad_calib_setup(&calib)->origin);
    TEST_ASSERT_EQUAL(0, stad_calib_report_of(&calib)->tuned);
}

void test_calib_preset_that_fails_on_other_pose_is_dropped(void)
{
    run_trial(presets_deceive);
    TEST_ASSERT_EQUAL(STAD_CALIB_KEPT, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_EQUAL(-1, stad_calib_report_of(&calib)->preset);
    TEST_ASSERT_FALSE(changed());
}

void test_calib_strict_rule_refuses_a_point(void)
{
    config.rule = STAD_RULE_STRICT;
    config.gain_q20 = POINTS(2);
    config.tunes = 0;
    run_trial(presets_help_a_little);
    TEST_ASSERT_FALSE(changed());
    config.rule = STAD_RULE_DEFAULT;
    config.probation_frames = 0;
    run_trial(presets_help_a_little);
    TEST_ASSERT_TRUE(changed());
}

void test_calib_gain_below_every_handicap_picks_nothing(void)
{
    config.tunes = 0;
    run_trial(presets_help_by_chance);
    TEST_ASSERT_FALSE(changed());
    TEST_ASSERT_EQUAL(-1, stad_calib_report_of(&calib)->preset);
}

void test_calib_tuned_set_is_adopted_when_it_holds(void)
{
    config.probation_frames = 0;
    config.preset_mask = 0;
    run_trial(bowl);
    TEST_ASSERT_EQUAL(1, stad_calib_report_of(&calib)->tuned);
    TEST_ASSERT_EQUAL(STAD_ORIGIN_TUNED, stad_calib_setup(&calib)->origin);
    TEST_ASSERT_LESS_OR_EQUAL(stad_calib_report_of(&calib)->judge_before_q20 - POINTS(2),
                              stad_calib_report_of(&calib)->judge_after_q20);
}

void test_calib_tuned_set_that_does_not_hold_is_refused(void)
{
    config.preset_mask = 0;
    run_trial(bowl_on_tuning_pose_only);
    TEST_ASSERT_FALSE(changed());
    config.rule = STAD_RULE_STRICT;
    run_trial(bowl_on_tuning_pose_only);
    TEST_ASSERT_FALSE(changed());
    config.rule = STAD_RULE_NONE;
    config.probation_frames = 0;
    run_trial(bowl_on_tuning_pose_only);
    TEST_ASSERT_TRUE(changed());
}

void test_calib_budget_is_never_exceeded(void)
{
    for (int budget = 4; budget <= 200; budget += 7) {
        char what[40];
        config.budget = (int16_t)budget;
        int matches = run_trial(bowl);
        snprintf(what, sizeof what, "budget %d", budget);
        TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(budget > 11 ? budget : 11, stad_calib_report_of(&calib)->evaluations, what);
        TEST_ASSERT_GREATER_OR_EQUAL_MESSAGE(stad_calib_report_of(&calib)->evaluations, matches, what);
    }
}

void test_calib_sets_stay_within_the_geometry(void)
{
    config.geometry.max_p2 = 300;
    config.geometry.max_block_size = 5;
    config.geometry.max_pre_filter_cap = 63;
    run_trial(bowl);
    TEST_ASSERT_TRUE(stad_calib_fits(&config.geometry, &stad_calib_setup(&calib)->params));
    for (int i = 0; i < stad_tune_counts_of(&calib.tune).evaluations; i++) {
        stad_point x;
        int32_t cost;
        TEST_ASSERT_EQUAL(STAD_OK, stad_tune_trace(&calib.tune, i, &x, &cost));
        stad_params p = stad_calib_params_at(&setup.params, &x);
        TEST_ASSERT_TRUE(stad_calib_fits(&config.geometry, &p));
        TEST_ASSERT_GREATER_OR_EQUAL(3, p.block_size);
    }
}

/* -- saving, probation ------------------------------------------------------------------------------------------- */

static void adopt_a_preset(void)
{
    stad_request r;
    stad_calib_init(&calib, &config, &setup);
    hold_poses();
    stad_calib_trial_begin(&calib);
    while (stad_calib_want(&calib, &r) == STAD_WANT_MATCH)
        stad_calib_cost(&calib, presets_help(&r));
    TEST_ASSERT_EQUAL(STAD_WANT_SAVE, r.want);
}

void test_calib_failed_save_is_asked_for_once_more(void)
{
    stad_request r;
    adopt_a_preset();
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_saved(&calib, STAD_E_CORRUPT));
    TEST_ASSERT_EQUAL(STAD_WANT_SAVE, stad_calib_want(&calib, &r));
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_saved(&calib, STAD_E_CORRUPT));
    TEST_ASSERT_EQUAL(STAD_WANT_NOTHING, stad_calib_want(&calib, &r));
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, stad_calib_report_of(&calib)->save_status);
    TEST_ASSERT_EQUAL(STAD_E_STATE, stad_calib_saved(&calib, 0));
}

static int live_frame(int per_mille)
{
    stad_match_counts counts = {80000, 80 * per_mille, 0, 0, 0, 0};
    return stad_calib_counts(&calib, &counts);
}

static void live_frames(int count, int per_mille)
{
    for (int i = 0; i < count; i++)
        live_frame(per_mille);
}

void test_calib_probation_asks_for_a_frame_and_compares(void)
{
    stad_request r;
    adopt_a_preset();
    stad_calib_saved(&calib, 0);
    TEST_ASSERT_EQUAL(STAD_WANT_NOTHING, stad_calib_want(&calib, &r));
    live_frames(64, 800);
    TEST_ASSERT_EQUAL(STAD_WANT_FRAME, stad_calib_want(&calib, &r));
    TEST_ASSERT_EQUAL(STAD_CALIB_RECHECK, stad_calib_report_of(&calib)->phase);
}

static uint8_t alarmed_on_trial;

static int compare(int32_t new_cost, int32_t old_cost)
{
    stad_request r;
    adopt_a_preset();
    stad_calib_saved(&calib, 0);
    stad_params adopted = stad_calib_setup(&calib)->params;
    stad_calib_enter(&calib, STAD_CALIB_COMPARE);
    calib.alarmed_on_trial = alarmed_on_trial;
    stad_calib_want(&calib, &r);
    TEST_ASSERT_EQUAL_MEMORY(&adopted, &r.params, sizeof adopted);
    stad_calib_cost(&calib, new_cost);
    stad_calib_want(&calib, &r);
    TEST_ASSERT_TRUE(is_start(&r.params));
    stad_calib_cost(&calib, old_cost);
    if (stad_calib_want(&calib, &r) == STAD_WANT_SAVE)
        stad_calib_saved(&calib, 0);
    return stad_calib_report_of(&calib)->outcome;
}

void test_calib_worse_on_probation_rolls_back(void)
{
    TEST_ASSERT_EQUAL(STAD_CALIB_ROLLED_BACK, compare(POINTS(30), POINTS(20)));
    TEST_ASSERT_FALSE(changed());
    TEST_ASSERT_EQUAL(STAD_CALIB_ADOPTED, compare(POINTS(20.5), POINTS(20)));
    TEST_ASSERT_TRUE(changed());
    TEST_ASSERT_EQUAL(STAD_CALIB_ROLLED_BACK, compare(STAD_COST_FAILED, POINTS(20)));
    TEST_ASSERT_EQUAL(STAD_CALIB_ADOPTED, compare(POINTS(20), STAD_COST_FAILED));
}

void test_calib_comparison_that_cannot_be_had_is_a_fault(void)
{
    TEST_ASSERT_EQUAL(STAD_CALIB_FAULT, compare(STAD_COST_FAILED, STAD_COST_FAILED));
    TEST_ASSERT_EQUAL(STAD_FAULT_MATCH, stad_calib_report_of(&calib)->fault);
    TEST_ASSERT_TRUE(changed()); /* it held on another pose */
    alarmed_on_trial = 1;
    TEST_ASSERT_EQUAL(STAD_CALIB_ROLLED_BACK, compare(STAD_COST_FAILED, STAD_COST_FAILED));
    TEST_ASSERT_EQUAL(STAD_FAULT_MATCH, stad_calib_report_of(&calib)->fault);
    TEST_ASSERT_FALSE(changed());
    alarmed_on_trial = 0;
}

static uint8_t work[STAD_CALIB_FRAME_BYTES(320, 240)] STAD_ALIGNED;

static int lose_frames(int count)
{
    int lost = 0;
    for (; lost < count && stad_calib_report_of(&calib)->phase != STAD_CALIB_IDLE; lost++)
        if (stad_calib_frame(&calib, NULL, NULL, work, sizeof work) != STAD_AGAIN)
            break;
    return lost;
}

void test_calib_alarm_on_probation_without_marks_rolls_back(void)
{
    stad_request r;
    adopt_a_preset();
    stad_calib_saved(&calib, 0);
    live_frames(30, 800);
    live_frames(2, 100);
    TEST_ASSERT_EQUAL(STAD_WANT_FRAME, stad_calib_want(&calib, &r));
    TEST_ASSERT_EQUAL(60, lose_frames(100));
    TEST_ASSERT_EQUAL(STAD_CALIB_SAVE, stad_calib_report_of(&calib)->phase);
    stad_calib_saved(&calib, 0);
    TEST_ASSERT_EQUAL(STAD_CALIB_ROLLED_BACK, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_FALSE(changed());
}

void test_calib_quiet_probation_without_marks_keeps(void)
{
    adopt_a_preset();
    stad_calib_saved(&calib, 0);
    live_frames(64, 800);
    TEST_ASSERT_EQUAL(60, lose_frames(100));
    TEST_ASSERT_EQUAL(STAD_CALIB_ADOPTED, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_TRUE(changed());
}

/* -- beginning --------------------------------------------------------------------------------------------------- */

void test_calib_idle_wants_nothing_and_refuses_reports(void)
{
    stad_request r;
    TEST_ASSERT_EQUAL(STAD_WANT_NOTHING, stad_calib_want(&calib, &r));
    TEST_ASSERT_EQUAL(STAD_E_STATE, stad_calib_cost(&calib, 0));
    TEST_ASSERT_EQUAL(STAD_E_STATE, stad_calib_saved(&calib, 0));
    TEST_ASSERT_EQUAL(STAD_E_STATE, stad_calib_frame(&calib, NULL, NULL, work, sizeof work));
    stad_calib_cancel(&calib);
    TEST_ASSERT_EQUAL(STAD_CALIB_NONE, stad_calib_report_of(&calib)->outcome);
}

void test_calib_alarm_begins_a_run(void)
{
    stad_request r;
    live_frames(30, 800);
    live_frames(2, 200);
    TEST_ASSERT_EQUAL(STAD_WANT_FRAME, stad_calib_want(&calib, &r));
    TEST_ASSERT_EQUAL(1, stad_calib_report_of(&calib)->alarmed);
    TEST_ASSERT_EQUAL(STAD_E_STATE, stad_calib_start(&calib));
    TEST_ASSERT_EQUAL(60, lose_frames(100));
    TEST_ASSERT_EQUAL(STAD_CALIB_FAULT, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_EQUAL(STAD_FAULT_LATE, stad_calib_report_of(&calib)->fault);
    TEST_ASSERT_EQUAL(1, stad_calib_report_of(&calib)->alarmed);
}

void test_calib_schedule_looks_at_one_frame(void)
{
    stad_request r;
    live_frames(300, 800);
    TEST_ASSERT_EQUAL(STAD_WANT_FRAME, stad_calib_want(&calib, &r));
    TEST_ASSERT_EQUAL(1, lose_frames(100));
    TEST_ASSERT_EQUAL(STAD_WANT_NOTHING, stad_calib_want(&calib, &r));
    live_frames(299, 800);
    TEST_ASSERT_EQUAL(STAD_WANT_NOTHING, stad_calib_want(&calib, &r));
    live_frame(800);
    TEST_ASSERT_EQUAL(STAD_WANT_FRAME, stad_calib_want(&calib, &r));
}

void test_calib_cancel_keeps_what_is_in_use(void)
{
    stad_calib_start(&calib);
    stad_calib_cancel(&calib);
    TEST_ASSERT_EQUAL(STAD_CALIB_CANCELLED, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_FALSE(changed());
}

void test_calib_workspace_is_checked(void)
{
    stad_calib_start(&calib);
    TEST_ASSERT_EQUAL(sizeof work, stad_calib_frame_bytes(320, 240));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_calib_frame(&calib, NULL, NULL, NULL, sizeof work));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_calib_frame(&calib, NULL, NULL, work, sizeof work - 1));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_calib_frame(&calib, NULL, NULL, work + 1, sizeof work));
    TEST_ASSERT_EQUAL(0, stad_calib_frame_bytes(8, 8));
}

void test_calib_negative_cost_is_refused(void)
{
    hold_poses();
    stad_calib_trial_begin(&calib);
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_calib_cost(&calib, -1));
    TEST_ASSERT_EQUAL(STAD_CALIB_PICK, stad_calib_report_of(&calib)->phase);
}

void test_calib_state_copied_in_the_middle_goes_on_alike(void)
{
    stad_request r;
    static stad_calib copy;
    config.probation_frames = 0;
    stad_calib_init(&calib, &config, &setup);
    hold_poses();
    stad_calib_trial_begin(&calib);
    for (int i = 0; stad_calib_want(&calib, &r) == STAD_WANT_MATCH; i++) {
        if (i == 25) {
            copy = calib;
            memset(&calib, 0xa5, sizeof calib);
            calib = copy;
        }
        stad_calib_cost(&calib, bowl(&r));
    }
    stad_setup resumed = *stad_calib_setup(&calib);
    run_trial(bowl);
    TEST_ASSERT_EQUAL_MEMORY(stad_calib_setup(&calib), &resumed, sizeof resumed);
}

void test_calib_state_is_about_as_large_as_said(void)
{
    printf("stad_calib: %zu bytes, stad_evaluator: %zu\n", sizeof(stad_calib), sizeof(stad_evaluator));
    TEST_ASSERT_LESS_OR_EQUAL(10 * 1024, sizeof(stad_calib));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_calib_equal_costs_keep_what_is_in_use);
    RUN_TEST(test_calib_set_in_use_that_cannot_be_matched_is_a_fault);
    RUN_TEST(test_calib_cost_not_measured_on_other_pose_is_not_reported);
    RUN_TEST(test_calib_helping_preset_is_adopted);
    RUN_TEST(test_calib_preset_that_fails_on_other_pose_is_dropped);
    RUN_TEST(test_calib_strict_rule_refuses_a_point);
    RUN_TEST(test_calib_gain_below_every_handicap_picks_nothing);
    RUN_TEST(test_calib_tuned_set_is_adopted_when_it_holds);
    RUN_TEST(test_calib_tuned_set_that_does_not_hold_is_refused);
    RUN_TEST(test_calib_budget_is_never_exceeded);
    RUN_TEST(test_calib_sets_stay_within_the_geometry);
    RUN_TEST(test_calib_failed_save_is_asked_for_once_more);
    RUN_TEST(test_calib_probation_asks_for_a_frame_and_compares);
    RUN_TEST(test_calib_worse_on_probation_rolls_back);
    RUN_TEST(test_calib_comparison_that_cannot_be_had_is_a_fault);
    RUN_TEST(test_calib_alarm_on_probation_without_marks_rolls_back);
    RUN_TEST(test_calib_quiet_probation_without_marks_keeps);
    RUN_TEST(test_calib_idle_wants_nothing_and_refuses_reports);
    RUN_TEST(test_calib_alarm_begins_a_run);
    RUN_TEST(test_calib_schedule_looks_at_one_frame);
    RUN_TEST(test_calib_cancel_keeps_what_is_in_use);
    RUN_TEST(test_calib_workspace_is_checked);
    RUN_TEST(test_calib_negative_cost_is_refused);
    RUN_TEST(test_calib_state_copied_in_the_middle_goes_on_alike);
    RUN_TEST(test_calib_state_is_about_as_large_as_said);
    return UNITY_END();
}
