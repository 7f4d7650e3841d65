/* SPDX-License-Identifier: MIT
 * unit/test_kernel_ends.c - the kernels in C at the ends of their contracts, where no matcher of today calls them. */
#include <string.h>

#include "kernel/kernel.h"
#include "unity.h"

enum { D = 16, WIDTH = 24, LANES = 2, SLOTS = 2, STRIDE = D + 8 };

void setUp(void)
{
}

void tearDown(void)
{
}

static void test_kernel_range_of_one_column_is_the_sample(void)
{
    const uint8_t plane[1] = {77};
    for (int reverse = 0; reverse < 2; reverse++) {
        uint8_t out[4] = {0, 0, 0, 9};
        stad_range_row_c(plane, 1, reverse, out);
        TEST_ASSERT_EACH_EQUAL_UINT8(77, out, 3);
        TEST_ASSERT_EQUAL(9, out[3]);
    }
}

/* Three channels whose planes together stay below 256: bytes and words say the same. */
static void test_kernel_cost_of_three_small_channels_is_one_in_bytes_and_words(void)
{
    uint8_t left[18 * WIDTH], right[18 * WIDTH], narrow[8 * D];
    uint16_t wide[8 * D];
    uint32_t state = 5;
    for (int i = 0; i < 18 * WIDTH; i++) {
        state = state * 1664525u + 1013904223u;
        left[i] = (uint8_t)(state >> 24 & 15);
        right[i] = (uint8_t)(state >> 16 & 15);
    }
    const stad_cost_job job = {left, right, WIDTH, 3, D - 1, 8, 0, D};
    stad_cost_row_u8_c(&job, narrow);
    stad_cost_row_u16_c(&job, wide);
    int differ = 0, some = 0;
    for (int i = 0; i < 8 * D; i++) {
        differ += narrow[i] != wide[i];
        some += wide[i] > 15; /* more than one channel can give */
    }
    TEST_ASSERT_EQUAL(0, differ);
    TEST_ASSERT_GREATER_THAN(0, some);
}

/* Lanes in bytes keep what enters the next step; the sums are those of lanes in words. */
static void test_kernel_path_of_two_fresh_lanes_sums_alike_in_bytes_and_words(void)
{
    static int16_t cells[LANES][SLOTS * STRIDE + 16], least[LANES][SLOTS], block[WIDTH * D], total[WIDTH * D],
        total_u8[WIDTH * D];
    static uint8_t bytes[LANES][SLOTS * STRIDE + 16];
    stad_path_job job = {block, total, WIDTH, D, STRIDE, 1, 10, 90, 1};
    stad_lane lanes[LANES];
    stad_lane_u8 lanes_u8[LANES];
    uint32_t state = 9;
    for (int i = 0; i < WIDTH * D; i++) {
        state = state * 1664525u + 1013904223u;
        block[i] = (int16_t)(90 + (state >> 16 & 1023));
    }
    for (int k = 0; k < LANES; k++) {
        for (int i = 0; i < SLOTS * STRIDE + 16; i++) {
            cells[k][i] = STAD_COST_MAX;
            bytes[k][i] = 255;
        }
        for (int s = 0; s < SLOTS; s++) {
            memset(cells[k] + 8 + s * STRIDE, 0, D * sizeof(int16_t));
            memset(bytes[k] + 8 + s * STRIDE, 0, D);
        }
        const stad_lane lane = {cells[k] + 8, least[k], SLOTS, 0};
        const stad_lane_u8 lane_u8 = {bytes[k] + 8, SLOTS, 0};
        lanes[k] = lane;
        lanes_u8[k] = lane_u8;
    }
    stad_path_row_c(&job, lanes, LANES);
    job.total = total_u8;
    stad_path_row_u8_c(&job, lanes_u8, LANES);
    TEST_ASSERT_EQUAL_INT16_ARRAY(total, total_u8, WIDTH * D);
}

/* A winner whose place in the right view lies left of it is a disparity all the same; nobody is voted for. */
static void test_kernel_select_outside_the_right_view_does_not_vote(void)
{
    const stad_best best = {9, 100, 30000};
    const int16_t fine = 9 * 16;
    int16_t disp[WIDTH] = {0}, votes[WIDTH] = {0}, costs[WIDTH];
    const int16_t no_votes[WIDTH] = {0};
    for (int i = 0; i < WIDTH; i++)
        costs[i] = STAD_COST_MAX;
    stad_select_job job = {&best, &fine, 4, 1, WIDTH, 0, 10, 0, disp, votes, costs, NULL, 0, 0};
    stad_select_row_c(&job);
    TEST_ASSERT_EQUAL(9 * 16, disp[4]);
    TEST_ASSERT_EQUAL_INT16_ARRAY(no_votes, votes, WIDTH);
    job.x = WIDTH - 1;
    job.min_disparity = -12; /* right of it */
    stad_select_row_c(&job);
    TEST_ASSERT_EQUAL((9 - 12) * 16, disp[WIDTH - 1]);
    TEST_ASSERT_EQUAL_INT16_ARRAY(no_votes, votes, WIDTH);
}

/* A disparity that leads out of the row on either side has no vote against it. */
static void test_kernel_check_outside_the_right_view_rejects_nothing(void)
{
    int16_t disp[WIDTH], votes[WIDTH];
    for (int i = 0; i < WIDTH; i++) {
        disp[i] = (int16_t)(i < WIDTH / 2 ? 16 * 20 : -16 * 20);
        votes[i] = 5;
    }
    const stad_check_job job = {disp, votes, 0, WIDTH, WIDTH, -30, 1};
    TEST_ASSERT_EQUAL(0, stad_check_row_c(&job));
    disp[3] = 16 * 2; /* lands on column 1, whose vote says 5 */
    TEST_ASSERT_EQUAL(1, stad_check_row_c(&job));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_kernel_range_of_one_column_is_the_sample);
    RUN_TEST(test_kernel_cost_of_three_small_channels_is_one_in_bytes_and_words);
    RUN_TEST(test_kernel_path_of_two_fresh_lanes_sums_alike_in_bytes_and_words);
    RUN_TEST(test_kernel_select_outside_the_right_view_does_not_vote);
    RUN_TEST(test_kernel_check_outside_the_right_view_rejects_nothing);
    return UNITY_END();
}
