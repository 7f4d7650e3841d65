/* SPDX-License-Identifier: MIT
 * test_extremes.c - numbers at the ends of their types, each of which the value analysis or a fuzzer once found mishandled.
 * The sanitizer tier runs them too. */
#include <string.h>

#include "base/affine.h"
#include "base/arith.h"
#include "base/log.h"
#include "stad/rig.h"
#include "stad/score.h"
#include "stad/tune.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

void test_log_of_the_upper_half_stays_in_32_bits(void)
{
    TEST_ASSERT_EQUAL_INT32(31 * 65536, stad_log2_q16(0x80000000u));
    TEST_ASSERT_EQUAL_INT32(32 * 65536, stad_log2_q16(UINT32_MAX));
}

void test_affine_offset_beyond_its_field_is_no_fit(void)
{
    stad_affine_sums sums = {0, 0, 0, 0, 0, 0, 0, 0, 0};
    stad_affine fit;
    for (int i = 0; i < 8; i++) /* slope 400 at x about 32000: the value at x = 0 is -12.8 million */
        stad_affine_add(&sums, 32000 + 10 * i, 20000 + 700 * (i % 3), 4000 * i);
    TEST_ASSERT_EQUAL(0, stad_affine_solve(&sums, &fit));
}

void test_affine_sums_that_no_points_make_are_no_fit(void)
{
    stad_affine fit;
    const stad_affine_sums good = {4, 0, 0, 0, 1000000, 0, 1000000, 500, 300};
    stad_affine_sums s = good;
    TEST_ASSERT_EQUAL(1, stad_affine_solve(&s, &fit));
    s.n = 2;
    TEST_ASSERT_EQUAL(0, stad_affine_solve(&s, &fit));
    s.n = STAD_AFFINE_MAX_POINTS + 1;
    TEST_ASSERT_EQUAL(0, stad_affine_solve(&s, &fit));
    s = good;
    s.xx = -1;
    TEST_ASSERT_EQUAL(0, stad_affine_solve(&s, &fit));
    s = good;
    s.yy = -1;
    TEST_ASSERT_EQUAL(0, stad_affine_solve(&s, &fit));
    for (int i = 0; i < 8; i++) { /* each sum as large as it may be, both ways */
        s = good;
        const int64_t large = i % 2 ? -((int64_t)1 << 45) : (int64_t)1 << 45;
        *(i / 2 == 0 ? &s.xy : i / 2 == 1 ? &s.xv : i / 2 == 2 ? &s.yv : &s.x) = large;
        if (i >= 6)
            s.x = i % 2 ? -(1 << 20) : 1 << 20;
        stad_affine_solve(&s, &fit);
    }
    s = good;
    s.xy = 1000000;
    TEST_ASSERT_EQUAL(0, stad_affine_solve(&s, &fit)); /* on a line */
    s = good;
    s.xv = (int64_t)1 << 40;
    s.xx = s.yy = 4;
    TEST_ASSERT_EQUAL(0, stad_affine_solve(&s, &fit)); /* too steep */
    s.xv = -((int64_t)1 << 40);
    TEST_ASSERT_EQUAL(0, stad_affine_solve(&s, &fit));
    s.xv = 0;
    s.yv = (int64_t)1 << 40;
    TEST_ASSERT_EQUAL(0, stad_affine_solve(&s, &fit));
}

void test_saturation_at_both_ends(void)
{
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, sat_i32((int64_t)INT32_MAX + 1));
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, sat_i32((int64_t)INT32_MIN - 1));
    TEST_ASSERT_EQUAL_INT32(-5, sat_i32(-5));
    TEST_ASSERT_EQUAL_INT16(INT16_MAX, sat_i16(40000));
    TEST_ASSERT_EQUAL_INT16(INT16_MIN, sat_i16(-40000));
    for (int32_t v = -200000; v < 200000; v += 77)
        TEST_ASSERT_EQUAL_INT16((int16_t)(uint16_t)((uint32_t)v & 0xFFFFu), wrap_i16(v));
}

void test_rig_with_the_least_shift_is_refused(void)
{
    static uint8_t pix[16 * 16], out[16];
    stad_image image = stad_image_packed(pix, 16, 16, 1);
    stad_rig rig = {INT32_MIN, 0, 0, 16, 16};
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_rig_row(&rig, &image, 3, out));
    rig.a_q16 = 0;
    rig.b_q24 = INT32_MIN;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_rig_row(&rig, &image, 3, out));
}

static stad_score scored(int cost, int32_t pixels)
{
    stad_score s;
    stad_score_config c;
    stad_score_config_init(&c, cost, 0, 64);
    TEST_ASSERT_EQUAL(STAD_OK, stad_score_begin(&s, &c));
    s.counts.considered = s.counts.matched = pixels;
    for (int i = 0; i < 32; i++)
        s.histogram[i] = pixels / 32;
    return s;
}

void test_score_entropy_of_many_frames_does_not_overflow(void)
{
    stad_score s = scored(STAD_SCORE_ENTROPY, 1 << 30);
    TEST_ASSERT_EQUAL_INT32(STAD_COST_ONE, stad_score_end(&s));
}

void test_score_blind_with_impossible_speckles_stays_a_cost(void)
{
    stad_score s = scored(STAD_SCORE_BLIND, 1);
    s.counts.photo_sum = 80 * 16;
    stad_score_frame_blind(&s, INT32_MAX, 0);
    TEST_ASSERT_GREATER_OR_EQUAL_INT32(STAD_COST_ONE, stad_score_end(&s));
    stad_score_frame_blind(&s, -1000, 0);
    TEST_ASSERT_GREATER_OR_EQUAL_INT32(0, stad_score_end(&s));
}

void test_score_labels_of_the_farthest_truth(void)
{
    const int32_t truth[4] = {-(1 << 28) + 1, STAD_TRUTH_NONE, (1 << 28) - 1, -1};
    uint8_t label[4];
    int32_t work[4];
    stad_score_label_row(truth, 4, label, work);
    TEST_ASSERT_EQUAL(STAD_LABEL_IGNORED, label[1]);
    TEST_ASSERT_EQUAL(STAD_LABEL_OCCLUDED, label[0]);
    TEST_ASSERT_EQUAL(STAD_LABEL_OCCLUDED, label[2]);
    TEST_ASSERT_EQUAL(STAD_LABEL_VISIBLE, label[3]);
}

/* Coordinates that are not free keep any value, 0 included; nothing may divide by them. */
void test_tune_fixed_zero_on_a_power_axis(void)
{
    static stad_tune t;
    stad_tune_config c;
    stad_point x = {{40, 150, 3, 0, 21, 0}};
    stad_tune_config_stereo(&c, STAD_TUNE_FOR_ANY);
    c.free_mask = 31;
    c.budget = STAD_TUNE_LOG;
    TEST_ASSERT_EQUAL(STAD_OK, stad_tune_init(&t, &c, &x));
    int turns = 0;
    for (; stad_tune_ask(&t, &x) == 1; turns++) {
        TEST_ASSERT_EQUAL(0, x.v[STAD_TUNE_DISP12_MAX_DIFF]);
        stad_tune_tell(&t, 1000 + x.v[0] % 97 * 7 + x.v[1] % 89);
    }
    TEST_ASSERT_GREATER_THAN(100, turns);
}

/* A grid of even numbers has no odd one, and differences of coordinates must fit 32 bits. */
void test_tune_axes_that_no_point_fits_are_refused(void)
{
    stad_tune_config c;
    const char *culprit = NULL;
    stad_tune_config_stereo(&c, STAD_TUNE_FOR_ANY);
    c.axis[STAD_TUNE_BLOCK_SIZE].lo = c.axis[STAD_TUNE_BLOCK_SIZE].hi = 8;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_tune_config_check(&c, &culprit));
    TEST_ASSERT_EQUAL_STRING("block_size", culprit);
    c.axis[STAD_TUNE_BLOCK_SIZE].hi = 9;
    TEST_ASSERT_EQUAL(STAD_OK, stad_tune_config_check(&c, &culprit));
    stad_tune_axis wide = {-STAD_TUNE_UNITS, STAD_TUNE_UNITS, 1, STAD_TUNE_LINEAR, 1};
    c.axis[STAD_TUNE_P1] = c.axis[STAD_TUNE_P2] = wide;
    TEST_ASSERT_EQUAL(STAD_OK, stad_tune_config_check(&c, &culprit));
    c.axis[STAD_TUNE_P1].lo--;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_tune_config_check(&c, &culprit));
    TEST_ASSERT_EQUAL_STRING("p1", culprit);
    c.axis[STAD_TUNE_P1].lo++;
    c.axis[STAD_TUNE_P2].hi++;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_tune_config_check(&c, &culprit));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_log_of_the_upper_half_stays_in_32_bits);
    RUN_TEST(test_affine_offset_beyond_its_field_is_no_fit);
    RUN_TEST(test_affine_sums_that_no_points_make_are_no_fit);
    RUN_TEST(test_saturation_at_both_ends);
    RUN_TEST(test_rig_with_the_least_shift_is_refused);
    RUN_TEST(test_score_entropy_of_many_frames_does_not_overflow);
    RUN_TEST(test_score_blind_with_impossible_speckles_stays_a_cost);
    RUN_TEST(test_score_labels_of_the_farthest_truth);
    RUN_TEST(test_tune_fixed_zero_on_a_power_axis);
    RUN_TEST(test_tune_axes_that_no_point_fits_are_refused);
    return UNITY_END();
}
