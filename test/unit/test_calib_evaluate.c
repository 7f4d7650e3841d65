/* SPDX-License-Identifier: MIT
 * unit/test_calib_evaluate.c - what a MATCH costs: frames rendered, found, matched and scored, with and without a correction,
 * in one channel and in three. */
#include "support/calib_bench.h"

#include <string.h>

#include "unity.h"

static uint8_t held[2][2][3 * PIXELS];
static uint8_t memory[4000000] STAD_ALIGNED;
static stad_evaluator evaluator;
static int channels;

void setUp(void)
{
    channels = 1;
    bench_reset();
}

void tearDown(void)
{
}

static stad_image view(const uint8_t *pix)
{
    return stad_image_packed(pix, W, H, channels);
}

/* Gives a shot to the loop, every sample as often as there are channels, and holds it. */
static int show(enum shot which, int hold)
{
    expose(which);
    for (size_t i = 0; i < PIXELS * (size_t)channels; i++) {
        held[hold][0][i] = left_pix[i / (size_t)channels];
        held[hold][1][i] = right_pix[i / (size_t)channels];
    }
    const stad_image left = view(held[hold][0]), right = view(held[hold][1]);
    return stad_calib_frame(&calib, &left, &right, work, sizeof work);
}

static int32_t evaluate(const stad_request *r)
{
    const stad_image left = view(held[r->hold][0]), right = view(held[r->hold][1]);
    TEST_ASSERT_LESS_OR_EQUAL(sizeof memory, stad_calib_evaluate_bytes(&config.geometry));
    return stad_calib_evaluate(&calib, r, &evaluator, &left, &right, memory, sizeof memory);
}

/* Shows two poses, and more of the second until a match is asked for. */
static stad_request ask(enum shot first, enum shot second)
{
    stad_request r;
    start();
    TEST_ASSERT_EQUAL(1, show(first, 0));
    for (int i = 0; i < 20 && stad_calib_want(&calib, &r) == STAD_WANT_FRAME; i++)
        show(second, 1);
    TEST_ASSERT_EQUAL(STAD_WANT_MATCH, stad_calib_want(&calib, &r));
    return r;
}

static void test_calib_cost_of_a_sound_pair_is_small_and_repeats(void)
{
    stad_request r = ask(NEAR_POSE, FAR_POSE);
    const int32_t cost = evaluate(&r);
    TEST_ASSERT_LESS_THAN(STAD_COST_ONE / 4, cost);
    TEST_ASSERT_GREATER_THAN(0, cost);
    TEST_ASSERT_EQUAL(cost, evaluate(&r));
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_cost(&calib, cost));
}

static void test_calib_cost_of_a_drifted_pair_is_small_through_its_correction_only(void)
{
    stad_request r = ask(DRIFTED, DRIFTED_OTHER);
    TEST_ASSERT_NOT_EQUAL(0, r.rig.a_q16);
    const int32_t corrected = evaluate(&r);
    stad_rig_identity(&r.rig, W, H);
    TEST_ASSERT_LESS_THAN(evaluate(&r), corrected);
    TEST_ASSERT_LESS_THAN(STAD_COST_ONE / 4, corrected);
}

static void test_calib_rotation_or_scale_alone_is_a_correction(void)
{
    stad_request r = ask(NEAR_POSE, FAR_POSE);
    const int32_t sound = evaluate(&r);
    r.rig.b_q24 = 1 << 17; /* a 128th: 1.2 px at the ends of a row */
    TEST_ASSERT_GREATER_THAN(sound, evaluate(&r));
    r.rig.b_q24 = 0;
    r.rig.c_q24 = 1 << 17;
    TEST_ASSERT_GREATER_THAN(sound, evaluate(&r));
}

static void test_calib_three_channels_find_the_same_target(void)
{
    channels = 3;
    config.geometry.channels = setup.channels = 3;
    stad_params_sample(&setup.params, 64, 3, 3);
    stad_request r = ask(NEAR_POSE, FAR_POSE);
    const int32_t cost = evaluate(&r);
    TEST_ASSERT_LESS_THAN(STAD_COST_ONE / 4, cost);
    memset(held[0][0], 0, sizeof held[0][0]);
    TEST_ASSERT_GREATER_THAN(cost, evaluate(&r));
}

/* A firmware's mistake, not the scene's: told as a fault, and no cost is reported. */
static void test_calib_run_without_room_to_match_ends_as_a_fault(void)
{
    stad_request r = ask(NEAR_POSE, FAR_POSE);
    const stad_calib_report *report = stad_calib_report_of(&calib);
    for (int i = 0; i < 100 && stad_calib_want(&calib, &r) == STAD_WANT_MATCH; i++) {
        const stad_image left = view(held[r.hold][0]), right = view(held[r.hold][1]);
        stad_calib_cost(&calib, stad_calib_evaluate(&calib, &r, &evaluator, &left, &right, memory, 64));
    }
    TEST_ASSERT_EQUAL(STAD_CALIB_IDLE, report->phase);
    TEST_ASSERT_EQUAL(STAD_CALIB_FAULT, report->outcome);
    TEST_ASSERT_EQUAL(STAD_FAULT_MATCH, report->fault);
    TEST_ASSERT_EQUAL(-1, report->tune_before_q20);
    TEST_ASSERT_EQUAL(-1, report->judge_before_q20);
}

int main(void)
{
    render_all();
    UNITY_BEGIN();
    RUN_TEST(test_calib_cost_of_a_sound_pair_is_small_and_repeats);
    RUN_TEST(test_calib_cost_of_a_drifted_pair_is_small_through_its_correction_only);
    RUN_TEST(test_calib_rotation_or_scale_alone_is_a_correction);
    RUN_TEST(test_calib_three_channels_find_the_same_target);
    RUN_TEST(test_calib_run_without_room_to_match_ends_as_a_fault);
    return UNITY_END();
}
