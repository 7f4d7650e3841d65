/* SPDX-License-Identifier: MIT
 * unit/test_winners.c - kept winners and what they refuse: memory, sizes, modes, parameters, the buffers of a frame. */
#include <string.h>

#include "stad/winners.h"
#include "unity.h"

enum { W = 40, H = 12, D = 16 };

static const stad_geometry geometry = {W, H, 1, D, 5, 1000, 63, STAD_MODE_SGBM, STAD_MEMORY_FAST};
static uint8_t work[STAD_MATCH_BYTES(W, H, 1, D, 5, 1000, 63, STAD_MODE_SGBM, STAD_MEMORY_FAST)] STAD_ALIGNED;
static uint8_t memory[STAD_WINNERS_BYTES(W, H) + 8] STAD_ALIGNED;
static uint8_t left_pix[W * H], right_pix[W * H];
static int16_t disp[W * H], again[W * H];
static stad_match matcher;
static stad_winners winners;
static stad_params params;

void setUp(void)
{
    for (int i = 0; i < W * H; i++)
        left_pix[i] = right_pix[i] = (uint8_t)(i * i * 37 >> 3);
    stad_params_sample(&params, D, 3, 1);
    TEST_ASSERT_EQUAL(STAD_OK, stad_match_init(&matcher, &geometry, work, sizeof work));
    TEST_ASSERT_EQUAL(STAD_OK, stad_winners_init(&winners, &geometry, memory, sizeof memory));
}

void tearDown(void)
{
}

static int match(void)
{
    const stad_image left = stad_image_packed(left_pix, W, H, 1), right = stad_image_packed(right_pix, W, H, 1);
    return stad_match_frame(&matcher, &params, &left, &right, disp, W, NULL, 0);
}

static int match_again(void)
{
    return stad_match_frame_again(&matcher, &params, &winners, again, W, NULL, 0);
}

static void test_winners_memory_is_checked(void)
{
    const size_t need = stad_winners_bytes(&geometry);
    stad_geometry bad = geometry;
    bad.width = 0;
    TEST_ASSERT_EQUAL(STAD_WINNERS_BYTES(W, H), need);
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_winners_init(&winners, &bad, memory, need));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_winners_init(&winners, &geometry, NULL, need));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_winners_init(&winners, &geometry, memory, need - 1));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_winners_init(&winners, &geometry, memory + 1, need));
    TEST_ASSERT_EQUAL(STAD_OK, stad_winners_init(&winners, &geometry, memory + 2, need));
}

static void test_winners_of_another_geometry_are_refused(void)
{
    for (int i = 0; i < 3; i++) {
        stad_winners other = winners;
        other.width = (int16_t)(W + (i == 0));
        other.height = (int16_t)(H + (i == 1));
        other.mode = (uint8_t)(i == 2 ? STAD_MODE_HH : STAD_MODE_SGBM);
        TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_match_keep(&matcher, &other));
        TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_match_again(&matcher, &params, &other));
    }
    TEST_ASSERT_EQUAL(STAD_OK, stad_match_keep(&matcher, NULL));
}

static void test_winners_that_are_not_there_do_not_serve(void)
{
    stad_winners none;
    memset(&none, 0, sizeof none);
    TEST_ASSERT_EQUAL(0, stad_winners_serve(&none, &params));
    TEST_ASSERT_EQUAL(0, stad_winners_serve(&winners, &params));
    TEST_ASSERT_EQUAL(STAD_E_STATE, match_again());
}

static void test_winners_with_parameters_out_of_range_are_refused(void)
{
    stad_match_keep(&matcher, &winners);
    TEST_ASSERT_EQUAL(STAD_OK, match());
    params.uniqueness_ratio = 100;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, match_again());
    TEST_ASSERT_EQUAL_STRING("uniqueness_ratio", stad_match_culprit(&matcher));
}

static void test_winners_again_asks_for_its_buffers(void)
{
    uint8_t speckles[64];
    stad_match_keep(&matcher, &winners);
    TEST_ASSERT_EQUAL(STAD_OK, match());
    TEST_ASSERT_EQUAL(STAD_OK, match_again());
    TEST_ASSERT_EQUAL_INT16_ARRAY(disp, again, W * H);
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_match_frame_again(&matcher, &params, &winners, NULL, W, NULL, 0));
    params.speckle_window_size = 20;
    params.speckle_range = 2;
    TEST_ASSERT_EQUAL(STAD_E_SIZE, match_again());
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_match_frame_again(&matcher, &params, &winners, again, W, speckles, sizeof speckles));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_winners_memory_is_checked);
    RUN_TEST(test_winners_of_another_geometry_are_refused);
    RUN_TEST(test_winners_that_are_not_there_do_not_serve);
    RUN_TEST(test_winners_with_parameters_out_of_range_are_refused);
    RUN_TEST(test_winners_again_asks_for_its_buffers);
    return UNITY_END();
}
