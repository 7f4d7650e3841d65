/* SPDX-License-Identifier: MIT
 * unit/test_calib_edges.c - parts of the loop by themselves, at values that rendered frames do not bring about. */
#include <stdio.h>
#include <string.h>

#include "calib_pump.h"

static void begin_trial(void)
{
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_init(&calib, &config, &setup));
    hold_poses();
    stad_calib_trial_begin(&calib);
}

static int phase(void)
{
    return stad_calib_report_of(&calib)->phase;
}

/* Answers matches until none is wanted, or the phase is reached. */
static void answer_until(int stop, int32_t (*cost)(const stad_request *r))
{
    stad_request r;
    for (int i = 0; i < 500 && phase() != stop && stad_calib_want(&calib, &r) == STAD_WANT_MATCH; i++)
        TEST_ASSERT_EQUAL(STAD_OK, stad_calib_cost(&calib, cost(&r)));
}

/* -- numbers ---------------------------------------------------------------------------------------------------------------- */

static void test_calib_handicap_of_no_preset_is_nothing(void)
{
    TEST_ASSERT_EQUAL(0, stad_calib_handicap_q16(-1));
    TEST_ASSERT_EQUAL(0, stad_calib_handicap_q16(STAD_PRESETS));
}

static void test_calib_parameters_out_of_their_domain_do_not_fit(void)
{
    stad_params p = setup.params;
    TEST_ASSERT_EQUAL(1, stad_calib_fits(&config.geometry, &p));
    p.p1 = 0;
    TEST_ASSERT_EQUAL(0, stad_calib_fits(&config.geometry, &p));
}

static void test_calib_stillness_is_of_marks_that_both_frames_show(void)
{
    stad_pair pair;
    memset(&pair, 0, sizeof pair);
    TEST_ASSERT_EQUAL(0, stad_calib_is_still(&calib, &pair, 1)); /* nothing to compare with */
    calib.pool[0] = pair;
    calib.pooled = 1;
    TEST_ASSERT_EQUAL(1, stad_calib_is_still(&calib, &pair, 1));
    pair.id = 3;
    TEST_ASSERT_EQUAL(0, stad_calib_is_still(&calib, &pair, 1));
    pair.id = 0;
    for (int side = 0; side < 4; side++) {
        stad_pair moved = pair;
        for (int k = 0; k < 4; k++) {
            moved.left[k].x_q8 += side == 0 ? 64 : side == 1 ? -64 : 0;
            moved.left[k].y_q8 += side == 2 ? 64 : side == 3 ? -64 : 0;
        }
        TEST_ASSERT_EQUAL(0, stad_calib_is_still(&calib, &moved, 1));
    }
}

static void test_calib_either_view_of_another_size_is_told(void)
{
    static uint8_t pix[320 * 240 + 2], work[STAD_CALIB_FRAME_BYTES(320, 240)] STAD_ALIGNED;
    const stad_image good = stad_image_packed(pix, 320, 240, 1), low = stad_image_packed(pix, 320, 239, 1);
    const stad_image colours = {pix, 320, 240, 3, 1, 320};
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_start(&calib));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_calib_frame(&calib, &low, &good, work, sizeof work));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_calib_frame(&calib, &good, &low, work, sizeof work));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_calib_frame(&calib, &good, &colours, work, sizeof work));
    TEST_ASSERT_EQUAL(STAD_FAULT_SIZE, stad_calib_report_of(&calib)->fault);
}

/* -- the workspace ---------------------------------------------------------------------------------------------------------- */

#define OF(macro, g)                                                                                                        \
    macro((g).width, (g).height, (g).channels, (g).max_disparities, (g).max_block_size, (g).max_p2, (g).max_pre_filter_cap, \
          (g).mode, (g).memory)

/* Usable for a static array: integer constant expressions. */
enum {
    EVALUATE_BYTES = STAD_CALIB_EVALUATE_BYTES(320, 240, 1, 64, 11, 8192, 127, STAD_MODE_SGBM, STAD_MEMORY_FAST),
    WORK_BYTES = STAD_CALIB_WORK_BYTES(320, 240, 1, 64, 11, 8192, 127, STAD_MODE_SGBM, STAD_MEMORY_FAST)
};

static int between(uint32_t *dice, int low, int high)
{
    *dice = *dice * 1664525u + 1013904223u;
    return low + (int)((*dice >> 8) % (uint32_t)(high - low + 1));
}

static void test_calib_bytes_of_macros_and_functions_agree(void)
{
    uint32_t dice = 5;
    int marks_need_more = 0;
    for (int i = 0; i < 20000; i++) {
        const stad_geometry g = {(int16_t)between(&dice, 40, 2048),
                                 (int16_t)between(&dice, 16, 2048),
                                 (int16_t)(between(&dice, 0, 1) ? 1 : 3),
                                 (int16_t)(16 * between(&dice, 1, 2)),
                                 (int16_t)(2 * between(&dice, 0, 8) + 1),
                                 (int16_t)between(&dice, 2, between(&dice, 0, 1) ? 255 : 32767),
                                 (int16_t)(2 * between(&dice, 7, 60) + 1),
                                 (uint8_t)between(&dice, 0, 3),
                                 (uint8_t)between(&dice, 0, 1)};
        const size_t marks = stad_calib_frame_bytes(g.width, g.height), match = stad_calib_evaluate_bytes(&g);
        char what[60];
        snprintf(what, sizeof what, "geometry %d of seed 5, %d x %d", i, g.width, g.height);
        TEST_ASSERT_EQUAL_INT_MESSAGE(STAD_OK, stad_geometry_check(&g, NULL), what);
        TEST_ASSERT_EQUAL_size_t_MESSAGE(match, OF(STAD_CALIB_EVALUATE_BYTES, g), what);
        TEST_ASSERT_EQUAL_size_t_MESSAGE(marks > match ? marks : match, OF(STAD_CALIB_WORK_BYTES, g), what);
        marks_need_more += marks > match;
    }
    TEST_ASSERT_GREATER_THAN(0, marks_need_more);
    TEST_ASSERT_EQUAL(EVALUATE_BYTES, stad_calib_evaluate_bytes(&config.geometry));
    TEST_ASSERT_EQUAL(WORK_BYTES, EVALUATE_BYTES);
}

/* -- an alarm in each phase that looks at no frame -------------------------------------------------------------------------- */

static int32_t level(const stad_request *r)
{
    (void)r;
    return POINTS(20);
}

/* A slope down to uniqueness 0 and cap 57, where no preset is: there is always something to tune. */
static int32_t slope(const stad_request *r)
{
    const int cap = r->params.pre_filter_cap < 57 ? 57 - r->params.pre_filter_cap : r->params.pre_filter_cap - 57;
    return POINTS(10) + r->params.uniqueness_ratio * POINTS(1) + cap * POINTS(1) / 2;
}

static void live(int frames, int per_mille)
{
    const stad_match_counts counts = {80000, 80 * per_mille, 0, 0, 0, 0};
    for (int i = 0; i < frames; i++)
        stad_calib_counts(&calib, &counts);
}

static void test_calib_alarm_while_matching_outlives_the_run(void)
{
    const int phases[3] = {STAD_CALIB_PICK, STAD_CALIB_JUDGE, STAD_CALIB_TUNE};
    for (int i = 0; i < 3; i++) {
        begin_trial();
        live(30, 800);
        answer_until(phases[i], slope);
        TEST_ASSERT_EQUAL(phases[i], phase());
        live(5, 100);
        TEST_ASSERT_EQUAL(1, stad_calib_report_of(&calib)->alarmed);
        answer_until(-1, level);
        if (phase() == STAD_CALIB_SAVE)
            stad_calib_saved(&calib, 0);
        TEST_ASSERT_EQUAL(1, stad_calib_report_of(&calib)->alarmed);
    }
}

/* -- what is tried ---------------------------------------------------------------------------------------------------------- */

static int smallest_block;

static int32_t note_block(const stad_request *r)
{
    smallest_block = r->params.block_size < smallest_block ? r->params.block_size : smallest_block;
    return POINTS(20);
}

static void test_calib_presets_below_the_smallest_block_are_not_tried(void)
{
    config.min_block_size = 9;
    setup.params.block_size = 9;
    smallest_block = 99;
    begin_trial();
    answer_until(-1, note_block);
    TEST_ASSERT_EQUAL(9, smallest_block);
}

/* -- rules for studies ------------------------------------------------------------------------------------------------------ */

/* On the other pose everything but the set in use is worse. */
static int32_t slope_that_deceives(const stad_request *r)
{
    const int in_use = memcmp(&r->params, &setup.params, sizeof setup.params) == 0;
    return r->hold == 0 ? slope(r) : in_use ? POINTS(20) : POINTS(30) + slope(r);
}

/* ... and all that the tuner asks fails. */
static int32_t presets_alone(const stad_request *r)
{
    return phase() == STAD_CALIB_TUNE ? STAD_COST_FAILED : slope_that_deceives(r);
}

static void test_calib_rule_none_takes_what_the_tuning_frame_likes(void)
{
    config.rule = STAD_RULE_NONE;
    config.probation_frames = 0;
    begin_trial();
    answer_until(-1, slope_that_deceives);
    TEST_ASSERT_EQUAL(1, stad_calib_report_of(&calib)->tuned);
    begin_trial();
    answer_until(-1, presets_alone);
    TEST_ASSERT_EQUAL(0, stad_calib_report_of(&calib)->tuned);
    TEST_ASSERT_GREATER_OR_EQUAL(0, stad_calib_report_of(&calib)->preset);
}

static void test_calib_strict_rule_takes_the_better_of_both(void)
{
    config.rule = STAD_RULE_STRICT;
    config.probation_frames = 0;
    begin_trial();
    answer_until(-1, slope);
    TEST_ASSERT_EQUAL(1, stad_calib_report_of(&calib)->tuned);
    stad_calib_saved(&calib, 0);
    TEST_ASSERT_EQUAL(STAD_CALIB_ADOPTED, stad_calib_report_of(&calib)->outcome);
}

/* Refused, and the loop as it was. */
static int refused(void)
{
    static stad_calib before;
    memcpy(&before, &calib, sizeof before);
    return stad_calib_init(&calib, &config, &setup) == STAD_E_PARAM && memcmp(&before, &calib, sizeof before) == 0;
}

#define REFUSES(object, field, value)                             \
    do {                                                          \
        setUp();                                                  \
        object.field = value;                                     \
        TEST_ASSERT_TRUE_MESSAGE(refused(), #field " = " #value); \
    } while (0)

void test_calib_config_out_of_range_is_refused(void)
{
    REFUSES(config, geometry.width, 0);
    REFUSES(config, target, NULL);
    REFUSES(config, margin_px, -1);
    REFUSES(config, margin_px, 17);
    REFUSES(config, pose_px, -1);
    REFUSES(config, patience, 0);
    REFUSES(config, probation_frames, -1);
    REFUSES(config, budget, 3);
    REFUSES(config, budget, STAD_TUNE_LOG + 1);
    REFUSES(config, min_block_size, 2);
    REFUSES(config, min_block_size, 13);
    REFUSES(config, threshold_q16, -1);
    REFUSES(config, penalty_q16, 65537);
    REFUSES(config, gain_q20, -1);
    REFUSES(config, cost, STAD_SCORE_D1);
    REFUSES(config, rule, 3);
    REFUSES(config, camera.f_q8, 0);
    REFUSES(config, camera.f_q8, 1 << 20);
    REFUSES(config, camera.cx_q8, 1 << 20);
    REFUSES(config, camera.cy_q8, -(1 << 20));
    REFUSES(config, ids, 0);
    REFUSES(config, ids, 0xFFFFFFF0u); /* none of the target's */
    REFUSES(config, ids, 0xFFFFFFF4u); /* one */
    REFUSES(config, monitor.learn_frames, 0);
    REFUSES(setup, width, 321);
    REFUSES(setup, mode, STAD_MODE_HH);
    REFUSES(setup, channels, 3);
    REFUSES(setup, params.block_size, 13);
    REFUSES(setup, params.p1, 0);
    setUp();
}

/* The matcher takes frames in which marks cannot be looked for; the loop does not, for then it knows no size of its workspace. */
void test_calib_frames_that_marks_cannot_take_are_refused(void)
{
    const int16_t sizes[3][2] = {{2056, 240}, {320, 2049}, {320, 15}};
    for (int i = 0; i < 3; i++) {
        setUp();
        config.geometry.width = setup.width = setup.rig.width = sizes[i][0];
        config.geometry.height = setup.height = setup.rig.height = sizes[i][1];
        TEST_ASSERT_EQUAL(STAD_OK, stad_geometry_check(&config.geometry, NULL));
        TEST_ASSERT_EQUAL(0, stad_calib_frame_bytes(sizes[i][0], sizes[i][1]));
        TEST_ASSERT_TRUE(refused());
    }
    setUp();
}

void test_calib_targets_that_no_truth_is_made_of_are_refused(void)
{
    stad_target target = *stad_target_relief();
    config.target = &target;
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_init(&calib, &config, &setup));
    target.part_count = 33;
    TEST_ASSERT_TRUE(refused());
    target.part_count = 6;
    target.tag_count = 1;
    TEST_ASSERT_TRUE(refused());
    setUp();
}

/* -- the rule's numbers ------------------------------------------------------------------------------------------ */

void test_calib_penalty_is_nothing_at_the_start(void)
{
    stad_point x = stad_calib_point_of(&setup.params), y = x;
    TEST_ASSERT_EQUAL(POINTS(20), stad_calib_penalised(&x, &x, POINTS(20), 655));
    y.v[STAD_TUNE_P1] = (int16_t)(4 * y.v[STAD_TUNE_P1]); /* two octaves: (20 + 1) * 1.04 - 1 = 20.84 */
    TEST_ASSERT_INT_WITHIN(POINTS(0.01), POINTS(20.84), stad_calib_penalised(&x, &y, POINTS(20), 655));
    y = x;
    y.v[STAD_TUNE_UNIQUENESS_RATIO] = 26; /* two eights */
    TEST_ASSERT_INT_WITHIN(POINTS(0.01), POINTS(20.84), stad_calib_penalised(&x, &y, POINTS(20), 655));
    TEST_ASSERT_EQUAL(STAD_COST_FAILED, stad_calib_penalised(&x, &y, STAD_COST_FAILED, 655));
    TEST_ASSERT_LESS_THAN(STAD_COST_FAILED, stad_calib_penalised(&x, &y, STAD_COST_FAILED - 1, 65536));
}

void test_calib_penalty_of_a_block_with_its_area_is_nothing(void)
{
    stad_point x = {{72, 288, 3, 10, 63, 1}}, y = {{200, 800, 5, 10, 63, 1}};
    TEST_ASSERT_INT_WITHIN(POINTS(0.01), POINTS(20), stad_calib_penalised(&x, &y, POINTS(20), 655));
}

void test_calib_margin_is_two_points_or_three_deviations(void)
{
    TEST_ASSERT_EQUAL(POINTS(2), stad_calib_margin(POINTS(20), 1000000, POINTS(2)));
    /* 3 sqrt(.2 .8 / (20000 / 100)) = .0849 */
    TEST_ASSERT_INT_WITHIN(POINTS(0.01), POINTS(8.485), stad_calib_margin(POINTS(20), 20000, POINTS(2)));
    TEST_ASSERT_EQUAL(STAD_COST_ONE, stad_calib_margin(POINTS(50), 0, POINTS(2)));
    TEST_ASSERT_EQUAL(POINTS(2), stad_calib_margin(STAD_COST_FAILED, 20000, POINTS(2)));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_calib_handicap_of_no_preset_is_nothing);
    RUN_TEST(test_calib_parameters_out_of_their_domain_do_not_fit);
    RUN_TEST(test_calib_stillness_is_of_marks_that_both_frames_show);
    RUN_TEST(test_calib_either_view_of_another_size_is_told);
    RUN_TEST(test_calib_bytes_of_macros_and_functions_agree);
    RUN_TEST(test_calib_alarm_while_matching_outlives_the_run);
    RUN_TEST(test_calib_presets_below_the_smallest_block_are_not_tried);
    RUN_TEST(test_calib_rule_none_takes_what_the_tuning_frame_likes);
    RUN_TEST(test_calib_strict_rule_takes_the_better_of_both);
    RUN_TEST(test_calib_config_out_of_range_is_refused);
    RUN_TEST(test_calib_frames_that_marks_cannot_take_are_refused);
    RUN_TEST(test_calib_targets_that_no_truth_is_made_of_are_refused);
    RUN_TEST(test_calib_penalty_is_nothing_at_the_start);
    RUN_TEST(test_calib_penalty_of_a_block_with_its_area_is_nothing);
    RUN_TEST(test_calib_margin_is_two_points_or_three_deviations);
    return UNITY_END();
}
