/* SPDX-License-Identifier: MIT
 * unit/test_score_label.c - what the right camera cannot see, and the costs that need no truth. */
#include <string.h>

#include "stad/score.h"
#include "unity.h"

#define PX(v) ((int32_t)((v) * 65536))
#define NO    STAD_TRUTH_NONE

void setUp(void)
{
}

void tearDown(void)
{
}

static void expect_labels(const int32_t *truth, int n, const char *expected)
{
    static const char letter[] = "-VO";
    uint8_t label[32];
    int32_t work[32];
    char got[33] = {0};
    stad_score_label_row(truth, n, label, work);
    for (int i = 0; i < n; i++)
        got[i] = letter[label[i]];
    TEST_ASSERT_EQUAL_STRING(expected, got);
}

static void test_label_flat_row_is_visible_where_it_lands_inside(void)
{
    const int32_t truth[] = {PX(2), PX(2), PX(2), PX(2), PX(2), PX(2)};
    expect_labels(truth, 6, "OOVVVV");
}

static void test_label_near_edge_hides_its_left(void)
{
    /* near pixels at x = 6..8 of 4 px land on right columns 2..4; far ones of 1 px at x = 3, 4, 5 land there too */
    const int32_t truth[] = {PX(1), PX(1), PX(1), PX(1), PX(1), PX(1), PX(4), PX(4), PX(4), PX(1)};
    expect_labels(truth, 10, "OVVOOOVVVV");
}

static void test_label_one_px_nearer_does_not_hide(void)
{
    /* x = 3 of 2 px and x = 2 of 1 px both land on column 1 */
    const int32_t equal[] = {PX(1), PX(1), PX(1), PX(2)};
    const int32_t above[] = {PX(1), PX(1), PX(1), PX(2) + 1};
    expect_labels(equal, 4, "OVVV");
    expect_labels(above, 4, "OOOV"); /* 2 px and a bit covers columns 0 and 1: x = 1 and x = 2 are hidden */
}

static void test_label_fraction_covers_both_columns(void)
{
    /* x = 7 of 4.5 px lands on 2 and 3: hides x = 3 and x = 4 of 1 px */
    const int32_t truth[] = {NO, PX(1), PX(1), PX(1), PX(1), PX(1), NO, PX(4.5)};
    expect_labels(truth, 8, "-VVOOV-V");
}

static void test_label_rounds_at_the_border(void)
{
    const int32_t half[] = {PX(0.5)};      /* -0.5 rounds up to column 0: d + 1/2 = 1 moves it to -1 */
    const int32_t below[] = {PX(0.5) - 1}; /* nearer to column 0 */
    const int32_t right[] = {PX(-0.75)};   /* column 1 of 1 */
    expect_labels(half, 1, "O");
    expect_labels(below, 1, "V");
    expect_labels(right, 1, "O");
}

static void test_label_negative_disparities_hide_alike(void)
{
    /* far -3 px at x = 0 lands on column 3, near 0 px at x = 3 hides it */
    const int32_t truth[] = {PX(-3), NO, NO, PX(0), NO, NO};
    expect_labels(truth, 6, "O--V--");
}

static void test_label_no_truth_is_ignored(void)
{
    const int32_t truth[] = {NO, NO};
    expect_labels(truth, 2, "--");
}

static void blind_score(stad_score *s, int cost, const int16_t *disp, const uint8_t *left, const uint8_t *right, int n)
{
    stad_score_config c;
    stad_score_config_init(&c, cost, 0, 2);
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_score_begin(s, &c));
    stad_score_row_blind(s, 0, disp, left, right, n);
}

static const uint8_t step_row[] = {10, 10, 10, 10, 60, 60, 60, 60, 60, 60, 10, 10};

static void test_score_blind_perfect_match_has_no_photometric_error(void)
{
    const int16_t disp[12] = {0};
    stad_score s;
    blind_score(&s, STAD_SCORE_PHOTO, disp, step_row, step_row, 12);
    TEST_ASSERT_EQUAL_INT32(10, s.counts.considered);
    TEST_ASSERT_EQUAL_INT32(10, s.counts.matched);
    TEST_ASSERT_EQUAL_INT32(0, stad_score_end(&s));
}

static void test_score_blind_ignores_gain_offset(void)
{
    const int16_t disp[12] = {0};
    uint8_t brighter[12];
    stad_score s;
    for (int i = 0; i < 12; i++)
        brighter[i] = (uint8_t)(step_row[i] + 40);
    blind_score(&s, STAD_SCORE_PHOTO, disp, step_row, brighter, 12);
    TEST_ASSERT_EQUAL_INT32(0, stad_score_end(&s));
}

static void test_score_blind_error_by_hand(void)
{
    const uint8_t row[3] = {0, 0, 20};
    const int16_t disp[3] = {0, 0, 8};
    stad_score s;
    stad_score_config c;
    stad_score_config_init(&c, STAD_SCORE_PHOTO, 0, 2);
    c.photo_limit = 16;
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_score_begin(&s, &c));
    stad_score_row_blind(&s, 0, disp, row, row, 3);
    /* sums around x = 2, held at the border: 0 + 0 + 20 + 20 + 20 = 60, so left is 100 - 60 = 40; around x = 1: 0 + 0 + 0 +
     * 20 + 20 = 40, so right is -40 and 40, in between 0: error 40 of 5 levels = 8 levels = 640 / 80 */
    TEST_ASSERT_EQUAL_INT64(640, s.counts.photo_sum);
    TEST_ASSERT_EQUAL_INT32(STAD_COST_ONE / 2, stad_score_end(&s)); /* 8 of 16 levels */
}

static void test_score_blind_missing_costs_half(void)
{
    int16_t disp[12];
    stad_score s;
    for (int i = 0; i < 12; i++)
        disp[i] = -16;
    blind_score(&s, STAD_SCORE_PHOTO, disp, step_row, step_row, 12);
    TEST_ASSERT_EQUAL_INT32(STAD_COST_ONE / 2, stad_score_end(&s));
    TEST_ASSERT_EQUAL_INT32(STAD_COST_ONE * 3 / 2, stad_score_cost_of(&s, STAD_SCORE_BLIND)); /* 1 missing + 1/2 */
    TEST_ASSERT_EQUAL_INT32(0, stad_score_cost_of(&s, STAD_SCORE_ENTROPY));
}

static void test_score_blind_frame_counters_enter(void)
{
    const int16_t disp[12] = {0};
    stad_score s;
    blind_score(&s, STAD_SCORE_BLIND, disp, step_row, step_row, 12);
    stad_score_frame_blind(&s, 2, 5);
    TEST_ASSERT_EQUAL_INT32((2 * STAD_COST_ONE * 2 + 5) / 10, stad_score_end(&s)); /* 2 * 2 / 10 */
    TEST_ASSERT_EQUAL_INT32((2 * STAD_COST_ONE + 5) / 10, stad_score_cost_of(&s, STAD_SCORE_SPECKLE));
    TEST_ASSERT_EQUAL_INT32(STAD_COST_ONE / 2, stad_score_cost_of(&s, STAD_SCORE_LR));
}

static void test_score_entropy_of_flat_histogram_is_one(void)
{
    int16_t disp[34];
    uint8_t grey[34] = {0};
    stad_score s;
    for (int i = 0; i < 34; i++)
        disp[i] = (int16_t)(i - 2); /* columns 2..33 take 0..31 sixteenths of 0..2 px */
    blind_score(&s, STAD_SCORE_ENTROPY, disp, grey, grey, 34);
    TEST_ASSERT_EQUAL_INT32(STAD_COST_ONE, stad_score_end(&s));
    memset(disp, 0, sizeof disp);
    blind_score(&s, STAD_SCORE_ENTROPY, disp, grey, grey, 34);
    TEST_ASSERT_EQUAL_INT32(0, stad_score_end(&s));
}

static void test_label_of_two_on_one_column_the_nearer_is_kept(void)
{
    int32_t truth[12], work[12];
    uint8_t label[12];
    for (int x = 0; x < 12; x++)
        truth[x] = STAD_TRUTH_NONE;
    truth[8] = 2 * 65536 + 60000; /* covers columns 5 and 6, as the next does */
    truth[9] = 3 * 65536 + 1000;
    stad_score_label_row(truth, 12, label, work);
    TEST_ASSERT_EQUAL(3 * 65536 + 1000, work[5]);
    truth[9] = 2 * 65536 + 1000; /* columns 6 and 7 */
    stad_score_label_row(truth, 12, label, work);
    TEST_ASSERT_EQUAL(2 * 65536 + 60000, work[6]);
    TEST_ASSERT_EQUAL(STAD_LABEL_VISIBLE, label[8]);
    TEST_ASSERT_EQUAL(STAD_LABEL_VISIBLE, label[9]);
}

/* The sub-pixel step can leave the range by half a pixel. */
static void test_score_blind_below_the_range_counts_in_the_first_bin(void)
{
    int16_t disp[24];
    uint8_t grey[24] = {0};
    stad_score_config c;
    stad_score s;
    for (int i = 0; i < 24; i++)
        disp[i] = -9;
    stad_score_config_init(&c, STAD_SCORE_ENTROPY, 0, 16);
    TEST_ASSERT_EQUAL(STAD_OK, stad_score_begin(&s, &c));
    stad_score_row_blind(&s, 0, disp, grey, grey, 24);
    TEST_ASSERT_EQUAL(s.counts.considered, s.counts.matched);
    TEST_ASSERT_EQUAL(s.counts.considered, s.histogram[0]);
    TEST_ASSERT_GREATER_THAN(0, s.histogram[0]);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_label_flat_row_is_visible_where_it_lands_inside);
    RUN_TEST(test_label_near_edge_hides_its_left);
    RUN_TEST(test_label_one_px_nearer_does_not_hide);
    RUN_TEST(test_label_fraction_covers_both_columns);
    RUN_TEST(test_label_rounds_at_the_border);
    RUN_TEST(test_label_negative_disparities_hide_alike);
    RUN_TEST(test_label_no_truth_is_ignored);
    RUN_TEST(test_score_blind_perfect_match_has_no_photometric_error);
    RUN_TEST(test_score_blind_ignores_gain_offset);
    RUN_TEST(test_score_blind_error_by_hand);
    RUN_TEST(test_score_blind_missing_costs_half);
    RUN_TEST(test_score_blind_frame_counters_enter);
    RUN_TEST(test_score_entropy_of_flat_histogram_is_one);
    RUN_TEST(test_label_of_two_on_one_column_the_nearer_is_kept);
    RUN_TEST(test_score_blind_below_the_range_counts_in_the_first_bin);
    return UNITY_END();
}
