/* SPDX-License-Identifier: MIT
 * test_calib_faults.c - the loop when cameras, frames, marks or poses fail: the state is told, nothing bad is adopted. */
#include "support/calib_bench.h"

#include <stdlib.h>
#include <string.h>

#include "unity.h"

void setUp(void)
{
    bench_reset();
    start();
}

void tearDown(void)
{
}

/* -- camera faults ----------------------------------------------------------------------------------------------- */

static void expect_fault(void (*make)(void), int fault, int outcome)
{
    start();
    for (int i = 0; i < config.patience; i++) {
        TEST_ASSERT_EQUAL(STAD_CALIB_LOOK, stad_calib_report_of(&calib)->phase);
        make();
        int status = give();
        TEST_ASSERT_LESS_THAN(0, status);
    }
    TEST_ASSERT_EQUAL(fault, stad_calib_report_of(&calib)->fault);
    TEST_ASSERT_EQUAL(STAD_CALIB_IDLE, stad_calib_report_of(&calib)->phase);
    TEST_ASSERT_EQUAL(outcome, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_EQUAL_MEMORY(&setup, stad_calib_setup(&calib), sizeof setup);
    TEST_ASSERT_EQUAL(-1, stad_calib_report_of(&calib)->tune_before_q20); /* nothing was measured */
    TEST_ASSERT_EQUAL(-1, stad_calib_report_of(&calib)->tune_after_q20);
    TEST_ASSERT_EQUAL(-1, stad_calib_report_of(&calib)->judge_before_q20);
    TEST_ASSERT_EQUAL(-1, stad_calib_report_of(&calib)->judge_after_q20);
}

void test_calib_black_cameras_are_told(void)
{
    expect_fault(make_black, STAD_FAULT_BLACK, STAD_CALIB_FAULT);
    expect_fault(make_left_black, STAD_FAULT_BLACK, STAD_CALIB_FAULT);
}

void test_calib_saturated_cameras_are_told(void)
{
    expect_fault(make_saturated, STAD_FAULT_SATURATED, STAD_CALIB_FAULT);
    expect_fault(make_half_saturated, STAD_FAULT_SATURATED, STAD_CALIB_FAULT);
}

void test_calib_dead_camera_is_told(void)
{
    expect_fault(make_right_dead, STAD_FAULT_FLAT, STAD_CALIB_FAULT);
}

void test_calib_frozen_cameras_are_told(void)
{
    expect_fault(make_frozen, STAD_FAULT_FROZEN, STAD_CALIB_FAULT);
    make_left_frozen();
    stad_calib_init(&calib, &config, &setup);
    stad_calib_start(&calib);
    TEST_ASSERT_EQUAL(1, give()); /* the first of them cannot be known */
    make_left_frozen();
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, give());
    TEST_ASSERT_EQUAL(STAD_FAULT_FROZEN, stad_calib_report_of(&calib)->fault);
}

void test_calib_still_recordings_are_allowed_when_asked_for(void)
{
    config.still = 1;
    start();
    make_frozen();
    TEST_ASSERT_EQUAL(STAD_E_NO_MARK, give());
    make_frozen();
    TEST_ASSERT_EQUAL(STAD_E_NO_MARK, give());
    TEST_ASSERT_EQUAL(STAD_FAULT_MARKS, stad_calib_report_of(&calib)->fault);
}

void test_calib_swapped_cameras_are_told(void)
{
    expect_fault(make_swapped, STAD_FAULT_SWAPPED, STAD_CALIB_FAULT);
}

void test_calib_one_camera_for_both_views_is_told(void)
{
    expect_fault(make_same, STAD_FAULT_SAME, STAD_CALIB_FAULT);
}

/* A live frame of a board that looks for no marks at all. */
static int live_fault(void (*make)(void))
{
    const stad_image left = stad_image_packed(left_pix, W, H, 1), right = stad_image_packed(right_pix, W, H, 1);
    make();
    return stad_calib_live(&calib, &left, &right);
}

void test_calib_live_frames_tell_of_the_cameras_at_once(void)
{
    const stad_image view = stad_image_packed(left_pix, W, H, 1), low = stad_image_packed(left_pix, W, H - 1, 1);
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_init(&calib, &config, &setup));
    TEST_ASSERT_EQUAL(STAD_FAULT_NONE, live_fault(make_with_target));
    TEST_ASSERT_EQUAL(STAD_FAULT_BLACK, live_fault(make_black));
    TEST_ASSERT_EQUAL(STAD_FAULT_BLACK, live_fault(make_left_black));
    TEST_ASSERT_EQUAL(STAD_FAULT_SATURATED, live_fault(make_saturated));
    TEST_ASSERT_EQUAL(STAD_FAULT_FLAT, live_fault(make_right_dead));
    TEST_ASSERT_EQUAL(STAD_FAULT_SAME, live_fault(make_same));
    TEST_ASSERT_EQUAL(STAD_FAULT_NONE, live_fault(make_frozen)); /* the first of them cannot be known */
    TEST_ASSERT_EQUAL(STAD_FAULT_FROZEN, live_fault(make_frozen));
    TEST_ASSERT_EQUAL(STAD_FAULT_NONE, live_fault(make_with_target));
    TEST_ASSERT_EQUAL(STAD_FAULT_LATE, stad_calib_live(&calib, &view, NULL));
    TEST_ASSERT_EQUAL(STAD_FAULT_SIZE, stad_calib_live(&calib, &view, &low));
    TEST_ASSERT_EQUAL(STAD_CALIB_IDLE, stad_calib_report_of(&calib)->phase);
    TEST_ASSERT_EQUAL(STAD_FAULT_NONE, stad_calib_report_of(&calib)->fault);
}

void test_calib_stale_buffers_in_turns_are_told(void)
{
    for (int turns = 1; turns <= STAD_CALIB_SEEN; turns++) {
        TEST_ASSERT_EQUAL(STAD_OK, stad_calib_init(&calib, &config, &setup));
        for (int i = 0; i < 3 * turns; i++) {
            const stad_image left = stad_image_packed(shots[i % turns][0], W, H, 1),
                             right = stad_image_packed(shots[i % turns][1], W, H, 1);
            TEST_ASSERT_EQUAL(i < turns ? STAD_FAULT_NONE : STAD_FAULT_FROZEN, stad_calib_live(&calib, &left, &right));
        }
    }
}

void test_calib_live_frame_may_be_looked_at_for_marks_too(void)
{
    TEST_ASSERT_EQUAL(STAD_FAULT_NONE, live_fault(make_with_target));
    TEST_ASSERT_EQUAL(1, give());
}

void test_calib_shifted_rows_are_told(void)
{
    expect_fault(make_rows_shifted, STAD_FAULT_RIG, STAD_CALIB_RIG_FAILED);
    TEST_ASSERT_EQUAL(STAD_RIG_FAIL, stad_calib_report_of(&calib)->verdict_before);
}

void test_calib_torn_frame_is_refused(void)
{
    start();
    make_torn();
    TEST_ASSERT_LESS_THAN(0, give());
    TEST_ASSERT_TRUE(stad_calib_report_of(&calib)->fault == STAD_FAULT_RIG ||
                     stad_calib_report_of(&calib)->fault == STAD_FAULT_MARKS);
    expose(NEAR_POSE);
    TEST_ASSERT_EQUAL(1, give()); /* the next good one is taken */
}

void test_calib_no_target_is_told(void)
{
    expect_fault(make_without_target, STAD_FAULT_MARKS, STAD_CALIB_NO_MARKS);
}

void test_calib_target_out_of_range_is_told(void)
{
    config.geometry.max_disparities = 16;
    setup.params.num_disparities = 16;
    start();
    expose(NEAR_POSE);
    TEST_ASSERT_EQUAL(STAD_E_NO_MARK, give());
    TEST_ASSERT_EQUAL(STAD_FAULT_RANGE, stad_calib_report_of(&calib)->fault);
}

void test_calib_scheduled_look_tells_a_target_out_of_range(void)
{
    config.geometry.max_disparities = 16;
    setup.params.num_disparities = 16;
    config.monitor.mark_every = 2;
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_init(&calib, &config, &setup));
    live(800);
    live(800);
    TEST_ASSERT_EQUAL(STAD_CALIB_LOOK, stad_calib_report_of(&calib)->phase);
    expose(NEAR_POSE);
    TEST_ASSERT_EQUAL(STAD_E_NO_MARK, give());
    TEST_ASSERT_EQUAL(STAD_FAULT_RANGE, stad_calib_report_of(&calib)->fault);
    TEST_ASSERT_EQUAL(STAD_CALIB_NO_MARKS, stad_calib_report_of(&calib)->outcome);
}

void test_calib_wrong_focal_length_is_told(void)
{
    config.camera.f_q8 *= 2;
    expect_fault(make_with_target, STAD_FAULT_CAMERA, STAD_CALIB_FAULT);
}

void test_calib_wrong_size_is_told(void)
{
    stad_image small = stad_image_packed(left_pix, W - 1, H, 1), right = stad_image_packed(right_pix, W, H, 1);
    start();
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_calib_frame(&calib, &small, &right, work, sizeof work));
    TEST_ASSERT_EQUAL(STAD_FAULT_SIZE, stad_calib_report_of(&calib)->fault);
    TEST_ASSERT_EQUAL(STAD_CALIB_LOOK, stad_calib_report_of(&calib)->phase);
}

/* -- costs that deceive ------------------------------------------------------------------------------------------ */

/* On the tuning frame all that differs from the set in use gains, the more the better; on the other pose it loses. */
static int32_t deceive(const stad_request *r)
{
    int away =
        abs(r->params.uniqueness_ratio - setup.params.uniqueness_ratio) + abs(r->params.block_size - setup.params.block_size);
    away = away < 30 ? away : 30;
    return (40 + (r->hold == 0 ? -away : away)) * (STAD_COST_ONE / 100);
}

void test_calib_tuning_frame_that_deceives_adopts_nothing(void)
{
    stad_request r;
    for (int rule = STAD_RULE_DEFAULT; rule <= STAD_RULE_STRICT; rule++) {
        int better = 0;
        config.rule = (uint8_t)rule;
        start();
        expose(NEAR_POSE);
        TEST_ASSERT_EQUAL(1, give());
        expose(FAR_POSE);
        TEST_ASSERT_EQUAL(1, give());
        while (stad_calib_want(&calib, &r) == STAD_WANT_MATCH) {
            better += deceive(&r) < 38 * (STAD_COST_ONE / 100);
            stad_calib_cost(&calib, deceive(&r));
        }
        TEST_ASSERT_GREATER_THAN(0, better); /* the search was led astray */
        TEST_ASSERT_EQUAL(STAD_CALIB_KEPT, stad_calib_report_of(&calib)->outcome);
        TEST_ASSERT_EQUAL_MEMORY(&setup, stad_calib_setup(&calib), sizeof setup);
    }
}

/* -- poses and the rig ------------------------------------------------------------------------------------------- */

void test_calib_same_pose_does_not_judge(void)
{
    start();
    expose(NEAR_POSE);
    TEST_ASSERT_EQUAL(1, give());
    for (int i = 0; i < config.patience; i++) {
        TEST_ASSERT_EQUAL(STAD_CALIB_OTHER, stad_calib_report_of(&calib)->phase);
        expose(NEAR_POSE);
        TEST_ASSERT_EQUAL(0, give());
    }
    TEST_ASSERT_EQUAL(STAD_CALIB_NO_POSE, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_EQUAL_MEMORY(&setup, stad_calib_setup(&calib), sizeof setup);
}

void test_calib_two_poses_of_a_sound_rig_begin_the_trial(void)
{
    stad_request r;
    start();
    expose(NEAR_POSE);
    TEST_ASSERT_EQUAL(1, give());
    make_black();
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, give());
    expose(FAR_POSE);
    TEST_ASSERT_EQUAL(1, give());
    TEST_ASSERT_EQUAL(STAD_RIG_GOOD, stad_calib_report_of(&calib)->verdict_before);
    TEST_ASSERT_EQUAL(STAD_WANT_MATCH, stad_calib_want(&calib, &r));
    TEST_ASSERT_EQUAL(0, r.rig.a_q16);
    TEST_ASSERT_GREATER_THAN(64 + 60, r.box.width);
}

static int give_until_idle(enum shot first, enum shot then, int most)
{
    int given = 0;
    for (; given < most && stad_calib_report_of(&calib)->phase <= STAD_CALIB_CONFIRM &&
           stad_calib_report_of(&calib)->phase != STAD_CALIB_IDLE;
         given++) {
        expose(given == 0 ? first : then);
        give();
    }
    return given;
}

void test_calib_drifted_rig_is_corrected_without_another_pose(void)
{
    start();
    give_until_idle(DRIFTED, DRIFTED, 40);
    TEST_ASSERT_EQUAL(STAD_CALIB_SAVE, stad_calib_report_of(&calib)->phase);
    stad_calib_saved(&calib, 0);
    const stad_calib_report *r = stad_calib_report_of(&calib);
    TEST_ASSERT_EQUAL(STAD_CALIB_CORRECTED, r->outcome);
    TEST_ASSERT_EQUAL(STAD_RIG_CORRECT, r->verdict_before);
    TEST_ASSERT_EQUAL(STAD_RIG_GOOD, r->verdict_after);
    TEST_ASSERT_EQUAL(1, stad_calib_setup(&calib)->corrected);
    TEST_ASSERT_EQUAL_MEMORY(&setup.params, &stad_calib_setup(&calib)->params, sizeof setup.params);
    TEST_ASSERT_INT_WITHIN(65536 / 8, 3 * 65536 / 2, stad_calib_setup(&calib)->rig.a_q16);
}

void test_calib_drifted_rig_is_tuned_only_through_its_correction(void)
{
    stad_request r;
    start();
    give_until_idle(DRIFTED, DRIFTED_OTHER, 40);
    TEST_ASSERT_EQUAL(STAD_WANT_MATCH, stad_calib_want(&calib, &r));
    TEST_ASSERT_NOT_EQUAL(0, r.rig.a_q16);
    TEST_ASSERT_EQUAL(0, stad_calib_setup(&calib)->corrected); /* nothing adopted yet */
}

/* The camera comes loose for so many of the frames that are to confirm. */
static void deny(int frames)
{
    start();
    expose(DRIFTED);
    TEST_ASSERT_EQUAL(1, give());
    expose(DRIFTED_OTHER);
    TEST_ASSERT_EQUAL(1, give());
    TEST_ASSERT_EQUAL(STAD_CALIB_CONFIRM, stad_calib_report_of(&calib)->phase);
    for (int i = 0; i < 20 && stad_calib_report_of(&calib)->phase == STAD_CALIB_CONFIRM; i++) {
        expose(i < frames ? NEAR_POSE : DRIFTED);
        give();
    }
    TEST_ASSERT_NOT_EQUAL(STAD_CALIB_CONFIRM, stad_calib_report_of(&calib)->phase);
    TEST_ASSERT_EQUAL_MEMORY(&setup, stad_calib_setup(&calib), sizeof setup);
}

void test_calib_correction_that_fresh_frames_deny_is_refused(void)
{
    deny(4);
    deny(20);
    TEST_ASSERT_EQUAL(STAD_CALIB_IDLE, stad_calib_report_of(&calib)->phase);
    TEST_ASSERT_EQUAL(STAD_CALIB_RIG_FAILED, stad_calib_report_of(&calib)->outcome);
}

void test_calib_correction_is_dropped_when_the_rig_is_sound_again(void)
{
    setup.corrected = 1;
    setup.rig.a_q16 = 2 * 65536;
    start();
    give_until_idle(NEAR_POSE, NEAR_POSE, 40);
    stad_calib_saved(&calib, 0);
    TEST_ASSERT_EQUAL(STAD_CALIB_CORRECTED, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_EQUAL(0, stad_calib_setup(&calib)->corrected);
}

int main(void)
{
    render_all();
    UNITY_BEGIN();
    RUN_TEST(test_calib_black_cameras_are_told);
    RUN_TEST(test_calib_saturated_cameras_are_told);
    RUN_TEST(test_calib_dead_camera_is_told);
    RUN_TEST(test_calib_frozen_cameras_are_told);
    RUN_TEST(test_calib_still_recordings_are_allowed_when_asked_for);
    RUN_TEST(test_calib_swapped_cameras_are_told);
    RUN_TEST(test_calib_one_camera_for_both_views_is_told);
    RUN_TEST(test_calib_live_frames_tell_of_the_cameras_at_once);
    RUN_TEST(test_calib_stale_buffers_in_turns_are_told);
    RUN_TEST(test_calib_live_frame_may_be_looked_at_for_marks_too);
    RUN_TEST(test_calib_shifted_rows_are_told);
    RUN_TEST(test_calib_torn_frame_is_refused);
    RUN_TEST(test_calib_no_target_is_told);
    RUN_TEST(test_calib_target_out_of_range_is_told);
    RUN_TEST(test_calib_scheduled_look_tells_a_target_out_of_range);
    RUN_TEST(test_calib_wrong_focal_length_is_told);
    RUN_TEST(test_calib_wrong_size_is_told);
    RUN_TEST(test_calib_tuning_frame_that_deceives_adopts_nothing);
    RUN_TEST(test_calib_same_pose_does_not_judge);
    RUN_TEST(test_calib_two_poses_of_a_sound_rig_begin_the_trial);
    RUN_TEST(test_calib_drifted_rig_is_corrected_without_another_pose);
    RUN_TEST(test_calib_drifted_rig_is_tuned_only_through_its_correction);
    RUN_TEST(test_calib_correction_that_fresh_frames_deny_is_refused);
    RUN_TEST(test_calib_correction_is_dropped_when_the_rig_is_sound_again);
    return UNITY_END();
}
