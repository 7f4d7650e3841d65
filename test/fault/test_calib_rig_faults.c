/* SPDX-License-Identifier: MIT
 * test_calib_rig_faults.c - a rig that moves and views that come late or stuck while the loop is at work: it is told,
 * nothing is adopted on it, and the alarm is not taken for answered.
 *
 * The target in two poses before a room, rendered once; a knock rolls the right view down by whole rows. Costs are
 * made up. */
#include "support/calib_bench.h"

#include <stdio.h>
#include <string.h>

#include "unity.h"

void setUp(void)
{
    bench_reset();
    config.probation_frames = 3;
    start();
}

void tearDown(void)
{
}

static uint8_t noisy(uint8_t v)
{
    int a = v + (int)(dice() % 3) - 1;
    return (uint8_t)(a < 0 ? 0 : a > 255 ? 255 : a);
}

/* A pair with noise of its own, the right view `rows` lower. */
static int give_pose(int pose, int rows)
{
    for (size_t i = 0; i < PIXELS; i++) {
        left_pix[i] = noisy(shots[pose][0][i]);
        right_pix[i] = noisy(shots[pose][1][i < (size_t)rows * W ? i : i - (size_t)rows * W]);
    }
    stad_image left = stad_image_packed(left_pix, W, H, 1), right = stad_image_packed(right_pix, W, H, 1);
    return stad_calib_frame(&calib, &left, &right, work, sizeof work);
}

static int phase(void)
{
    return stad_calib_report_of(&calib)->phase;
}

static int32_t points(int p)
{
    return p * (STAD_COST_ONE / 100);
}

/* Blocks of 7 and more help, wherever the start is. */
static int32_t helps(const stad_request *r, int least)
{
    return points(least + (r->params.block_size < 7 ? 5 * (7 - r->params.block_size) : 0));
}

/* Answers MATCH and SAVE until something else is wanted. */
static void answer(int least)
{
    stad_request r;
    for (int i = 0; i < 500; i++) {
        int want = stad_calib_want(&calib, &r);
        if (want == STAD_WANT_MATCH)
            stad_calib_cost(&calib, helps(&r, least));
        else if (want == STAD_WANT_SAVE)
            stad_calib_saved(&calib, 0);
        else
            return;
    }
    TEST_FAIL_MESSAGE("it asks for ever");
}

static void expect_nothing_changed(int outcome, const char *what)
{
    TEST_ASSERT_EQUAL_MESSAGE(STAD_CALIB_IDLE, phase(), what);
    TEST_ASSERT_EQUAL_MESSAGE(outcome, stad_calib_report_of(&calib)->outcome, what);
    TEST_ASSERT_EQUAL_MESSAGE(STAD_FAULT_RIG, stad_calib_report_of(&calib)->fault, what);
    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&setup, stad_calib_setup(&calib), sizeof setup, what);
}

/* -- knocked while it looks -------------------------------------------------------------------------------------- */

static void knock_before_the_other_pose(int rows)
{
    TEST_ASSERT_EQUAL(1, give_pose(0, 0));
    TEST_ASSERT_EQUAL(STAD_RIG_GOOD, stad_calib_report_of(&calib)->verdict_before);
    for (int i = 0; i < config.patience; i++) {
        TEST_ASSERT_EQUAL(STAD_CALIB_OTHER, phase());
        TEST_ASSERT_EQUAL(STAD_E_RIG, give_pose(1, rows));
    }
}

void test_calib_knock_before_the_other_pose_is_told(void)
{
    const int rows[] = {1, 2, 3, 4, 5, 6, 12};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char what[32];
        snprintf(what, sizeof what, "%d rows", rows[i]);
        start();
        knock_before_the_other_pose(rows[i]);
        expect_nothing_changed(STAD_CALIB_RIG_FAILED, what);
    }
}

void test_calib_one_torn_frame_of_the_other_pose_costs_patience_only(void)
{
    stad_request r;
    TEST_ASSERT_EQUAL(1, give_pose(0, 0));
    TEST_ASSERT_EQUAL(STAD_E_RIG, give_pose(1, 2));
    TEST_ASSERT_EQUAL(1, give_pose(1, 0));
    TEST_ASSERT_EQUAL(STAD_WANT_MATCH, stad_calib_want(&calib, &r));
}

void test_calib_knock_of_a_rig_to_be_corrected_is_told(void)
{
    give_pose(0, 2);
    for (int i = 0; i < 60 && phase() != STAD_CALIB_IDLE; i++) {
        give_pose(1, 3);
        answer(10);
    }
    expect_nothing_changed(STAD_CALIB_RIG_FAILED, "2 rows, then 3");
}

/* -- one view late ----------------------------------------------------------------------------------------------- */

/* The target glides down by a row a frame, and the right view is a frame late: a rig 1 px off, by every frame. */
static int glide(int at, int lag)
{
    for (size_t i = 0; i < PIXELS; i++) {
        size_t down = (size_t)at * W, late = (size_t)(at - lag) * W;
        left_pix[i] = noisy(shots[0][0][i < down ? i : i - down]);
        right_pix[i] = noisy(shots[0][1][i < late ? i : i - late]);
    }
    stad_image left = stad_image_packed(left_pix, W, H, 1), right = stad_image_packed(right_pix, W, H, 1);
    return stad_calib_frame(&calib, &left, &right, work, sizeof work);
}

void test_calib_late_view_of_a_moving_target_is_not_taken_for_drift(void)
{
    for (int at = 1; at < 20 && phase() != STAD_CALIB_IDLE; at++) {
        glide(at, 1);
        TEST_ASSERT_LESS_THAN(STAD_CALIB_PICK, phase());
    }
    TEST_ASSERT_EQUAL(STAD_CALIB_RIG_FAILED, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_EQUAL(STAD_FAULT_MOVING, stad_calib_report_of(&calib)->fault);
    TEST_ASSERT_EQUAL_MEMORY(&setup, stad_calib_setup(&calib), sizeof setup);
}

void test_calib_late_view_of_a_target_that_stops_is_not_taken_for_drift(void)
{
    for (int i = 1; i < 40 && phase() != STAD_CALIB_IDLE; i++) {
        glide(i < 12 ? i : 12, i <= 12 ? 1 : 0);
        answer(10);
    }
    TEST_ASSERT_EQUAL_MEMORY(&setup, stad_calib_setup(&calib), sizeof setup);
}

/* Both views in time: motion is no fault of the rig, and the correction waits until it ends. */
void test_calib_drift_is_corrected_when_the_target_stops(void)
{
    for (int i = 1; i < 40 && phase() != STAD_CALIB_SAVE; i++)
        glide(i < 9 ? i + 2 : 10, 2);
    TEST_ASSERT_EQUAL(STAD_CALIB_SAVE, phase());
    TEST_ASSERT_INT_WITHIN(65536 / 4, -2 * 65536, stad_calib_setup(&calib)->rig.a_q16);
}

/* Buffers handed out in turns that nobody fills any more. */
void test_calib_stuck_buffers_are_told(void)
{
    static uint8_t stuck[5][PIXELS];
    for (int buffers = 1; buffers <= 5; buffers++) {
        char what[32];
        snprintf(what, sizeof what, "%d buffers", buffers);
        for (int k = 0; k < buffers; k++)
            for (size_t i = 0; i < PIXELS; i++)
                stuck[k][i] = noisy(shots[0][1][i]);
        start();
        for (int f = 0; f < 2 * buffers; f++) {
            for (size_t i = 0; i < PIXELS; i++)
                left_pix[i] = noisy(shots[0][0][i]);
            stad_image left = stad_image_packed(left_pix, W, H, 1);
            stad_image right = stad_image_packed(stuck[f % buffers], W, H, 1);
            int status = stad_calib_frame(&calib, &left, &right, work, sizeof work);
            int told = status == STAD_E_CORRUPT && stad_calib_report_of(&calib)->fault == STAD_FAULT_FROZEN;
            if (phase() == STAD_CALIB_LOOK || phase() == STAD_CALIB_OTHER)
                TEST_ASSERT_EQUAL_MESSAGE(f >= buffers && buffers <= 4, told, what);
        }
    }
}

/* -- knocked on probation ---------------------------------------------------------------------------------------- */

static void adopt(void)
{
    TEST_ASSERT_EQUAL(1, give_pose(0, 0));
    TEST_ASSERT_EQUAL(1, give_pose(1, 0));
    answer(10);
    TEST_ASSERT_EQUAL(STAD_CALIB_PROBATION, phase());
    for (int i = 0; i < config.probation_frames; i++)
        live(800);
    TEST_ASSERT_EQUAL(STAD_CALIB_RECHECK, phase());
}

void test_calib_knock_on_probation_takes_it_back(void)
{
    adopt();
    for (int i = 0; i < config.patience; i++)
        TEST_ASSERT_EQUAL(STAD_E_RIG, give_pose(2, 2));
    answer(10);
    expect_nothing_changed(STAD_CALIB_ROLLED_BACK, "2 rows");
}

void test_calib_sound_probation_still_ends_well(void)
{
    adopt();
    TEST_ASSERT_EQUAL(1, give_pose(2, 0));
    answer(10);
    TEST_ASSERT_EQUAL(STAD_CALIB_ADOPTED, stad_calib_report_of(&calib)->outcome);
}

/* -- the alarm --------------------------------------------------------------------------------------------------- */

/* Live frames, none of them worse than the last, until a run begins. */
static int frames_until_a_run(int most, int firm)
{
    int frames = 0;
    while (phase() == STAD_CALIB_IDLE && frames < most) {
        live(firm);
        frames++;
    }
    return frames;
}

void test_calib_alarm_of_a_knock_is_raised_again(void)
{
    stad_calib_cancel(&calib);
    for (int i = 0; i < 30; i++)
        live(800);
    TEST_ASSERT_LESS_THAN(20, frames_until_a_run(100, 300));
    knock_before_the_other_pose(2);
    TEST_ASSERT_EQUAL(1, stad_calib_report_of(&calib)->alarmed);
    TEST_ASSERT_EQUAL(config.monitor.cooldown_frames, frames_until_a_run(200, 300));
    TEST_ASSERT_EQUAL(STAD_CALIB_LOOK, phase());
}

/* What the monitor never saw. */
void test_calib_knock_in_a_run_begun_by_hand_raises_the_alarm(void)
{
    stad_calib_cancel(&calib);
    for (int i = 0; i < 30; i++)
        live(800);
    stad_calib_start(&calib);
    knock_before_the_other_pose(2);
    TEST_ASSERT_EQUAL(1, stad_calib_report_of(&calib)->alarmed);
    TEST_ASSERT_EQUAL(config.monitor.cooldown_frames, frames_until_a_run(200, 800));
    TEST_ASSERT_EQUAL(STAD_CALIB_LOOK, phase());
}

/* Torn, for instance. */
void test_calib_one_scheduled_look_alone_raises_no_alarm(void)
{
    config.monitor.mark_every = 40;
    start();
    stad_calib_cancel(&calib);
    TEST_ASSERT_EQUAL(40, frames_until_a_run(100, 800));
    TEST_ASSERT_EQUAL(STAD_E_RIG, give_pose(0, 12));
    TEST_ASSERT_EQUAL(STAD_CALIB_RIG_FAILED, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_EQUAL(0, stad_calib_report_of(&calib)->alarmed);
    TEST_ASSERT_EQUAL(40, frames_until_a_run(100, 800));
}

void test_calib_alarm_after_the_last_frame_outlives_the_run(void)
{
    stad_request r;
    stad_calib_cancel(&calib);
    for (int i = 0; i < 30; i++)
        live(800);
    stad_calib_start(&calib);
    give_pose(0, 0);
    give_pose(1, 0);
    TEST_ASSERT_EQUAL(STAD_CALIB_PICK, phase());
    for (int i = 0; i < 5; i++)
        live(300);
    while (stad_calib_want(&calib, &r) == STAD_WANT_MATCH)
        stad_calib_cost(&calib, points(20));
    TEST_ASSERT_EQUAL(STAD_CALIB_KEPT, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_EQUAL(1, stad_calib_report_of(&calib)->alarmed);
    TEST_ASSERT_EQUAL(config.monitor.cooldown_frames, frames_until_a_run(200, 300));
}

/* -- a pose that is no judge ------------------------------------------------------------------------------------- */

void test_calib_pose_on_which_nearly_all_is_wrong_does_not_judge(void)
{
    config.probation_frames = 0;
    start();
    give_pose(0, 0);
    give_pose(1, 0);
    answer(70); /* 90 of 100 with the set in use, 70 with others */
    TEST_ASSERT_EQUAL(STAD_CALIB_KEPT, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_EQUAL_MEMORY(&setup, stad_calib_setup(&calib), sizeof setup);
    start();
    give_pose(0, 0);
    give_pose(1, 0);
    answer(40);
    TEST_ASSERT_EQUAL(STAD_CALIB_ADOPTED, stad_calib_report_of(&calib)->outcome);
}

int main(void)
{
    render_all();
    UNITY_BEGIN();
    RUN_TEST(test_calib_knock_before_the_other_pose_is_told);
    RUN_TEST(test_calib_one_torn_frame_of_the_other_pose_costs_patience_only);
    RUN_TEST(test_calib_knock_of_a_rig_to_be_corrected_is_told);
    RUN_TEST(test_calib_late_view_of_a_moving_target_is_not_taken_for_drift);
    RUN_TEST(test_calib_late_view_of_a_target_that_stops_is_not_taken_for_drift);
    RUN_TEST(test_calib_drift_is_corrected_when_the_target_stops);
    RUN_TEST(test_calib_stuck_buffers_are_told);
    RUN_TEST(test_calib_knock_on_probation_takes_it_back);
    RUN_TEST(test_calib_sound_probation_still_ends_well);
    RUN_TEST(test_calib_alarm_of_a_knock_is_raised_again);
    RUN_TEST(test_calib_knock_in_a_run_begun_by_hand_raises_the_alarm);
    RUN_TEST(test_calib_one_scheduled_look_alone_raises_no_alarm);
    RUN_TEST(test_calib_alarm_after_the_last_frame_outlives_the_run);
    RUN_TEST(test_calib_pose_on_which_nearly_all_is_wrong_does_not_judge);
    return UNITY_END();
}
