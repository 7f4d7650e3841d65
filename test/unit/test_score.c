/* SPDX-License-Identifier: MIT
 * unit/test_score.c - counts and costs of rows small enough to be worked out by hand. */
#include <string.h>

#include "stad/score.h"
#include "unity.h"

#define PX(v)   ((int32_t)((v) * 65536))
#define NONE_Q4 (-16) /* min_disparity 0 */
#define VIS     STAD_LABEL_VISIBLE
#define OCC     STAD_LABEL_OCCLUDED
#define IGN     STAD_LABEL_IGNORED

static stad_score score;
static stad_score_config config;

void setUp(void)
{
    stad_score_config_init(&config, STAD_SCORE_BAD, 0, 16);
}

void tearDown(void)
{
}

/* Rows of 16 ignored columns, then the given ones. */
static void feed(const int16_t *disp, const int32_t *truth, const uint8_t *label, int n)
{
    int16_t d[64] = {0};
    int32_t t[64] = {0};
    uint8_t l[64];
    memset(l, VIS, sizeof l); /* left of column 16 all would be wrong: they must not count */
    for (int i = 0; i < 16; i++)
        t[i] = PX(9);
    memcpy(d + 16, disp, (size_t)n * sizeof *d);
    memcpy(t + 16, truth, (size_t)n * sizeof *t);
    memcpy(l + 16, label, (size_t)n);
    stad_score_row(&score, 0, d, t, l, 16 + n);
}

/* A row with one of each kind; threshold 1 px:
 *   visible: right by 0, right by exactly 1 px, wrong by 1/65536 more than 1 px, wrong by 4 px, missing
 *   occluded: right, wrong, missing;  ignored: wrong, missing, no truth */
static const int16_t mixed_disp[] = {80, 96, 96, 144, NONE_Q4, 80, 160, NONE_Q4, 160, NONE_Q4, 80};
static const int32_t mixed_truth[] = {PX(5), PX(5), PX(5) - 1, PX(5), PX(5), PX(5), PX(5), PX(5), PX(5), PX(5), STAD_TRUTH_NONE};
static const uint8_t mixed_label[] = {VIS, VIS, VIS, VIS, VIS, OCC, OCC, OCC, IGN, IGN, VIS};

static void feed_mixed(int cost)
{
    config.cost = (uint8_t)cost;
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_score_begin(&score, &config));
    feed(mixed_disp, mixed_truth, mixed_label, 11);
}

static void test_score_mixed_row_counts_each_kind(void)
{
    feed_mixed(STAD_SCORE_BAD);
    TEST_ASSERT_EQUAL_INT32(5, score.counts.visible);
    TEST_ASSERT_EQUAL_INT32(3, score.counts.occluded);
    TEST_ASSERT_EQUAL_INT32(2, score.counts.wrong_visible);
    TEST_ASSERT_EQUAL_INT32(1, score.counts.wrong_occluded);
    TEST_ASSERT_EQUAL_INT32(1, score.counts.missing_visible);
    TEST_ASSERT_EQUAL_INT32(1, score.counts.missing_occluded);
    TEST_ASSERT_EQUAL_INT32(1, score.counts.d1_visible);
    TEST_ASSERT_EQUAL_INT32(1, score.counts.d1_occluded);
    TEST_ASSERT_EQUAL_INT64(PX(0) + PX(1) + PX(1) + 1 + PX(4), score.counts.abs_sum_q16);
    TEST_ASSERT_EQUAL_INT64(PX(0) + PX(1) + PX(1) + PX(16), score.counts.square_sum_q16);
}

static void test_score_mixed_row_costs_by_hand(void)
{
    feed_mixed(STAD_SCORE_BAD);
    TEST_ASSERT_EQUAL_INT32((3 * STAD_COST_ONE + 2) / 5, stad_score_end(&score)); /* (2 + 1) / 5 */
    feed_mixed(STAD_SCORE_CHOW);
    TEST_ASSERT_EQUAL_INT32((7 * STAD_COST_ONE + 8) / 16, stad_score_end(&score)); /* (2*2 + 2*1 + 1) / (2*8) */
    feed_mixed(STAD_SCORE_D1);
    TEST_ASSERT_EQUAL_INT32((2 * STAD_COST_ONE + 2) / 5, stad_score_end(&score)); /* (1 + 1) / 5 */
    feed_mixed(STAD_SCORE_MISSING);
    TEST_ASSERT_EQUAL_INT32((STAD_COST_ONE + 2) / 5, stad_score_end(&score));
}

static void test_score_rmse_and_mae_by_hand(void)
{
    /* errors 0, 1, 1 + 1/65536, 4 over 4 pixels: mean square 18/4 = 4.5, mean 6/4 = 1.5 */
    feed_mixed(STAD_SCORE_RMSE);
    TEST_ASSERT_INT32_WITHIN(1, 139022, stad_score_rmse_q16(&score)); /* sqrt(4.5) * 65536 = 139022.9 */
    TEST_ASSERT_EQUAL_INT32(PX(1.5), stad_score_mae_q16(&score));
    TEST_ASSERT_INT32_WITHIN(1, 139022, stad_score_end(&score)); /* / 16 px, * 16 from Q16 to Q20 */
    TEST_ASSERT_EQUAL_INT32(PX(1.5), stad_score_cost_of(&score, STAD_SCORE_MAE));
}

static void test_score_threshold_is_exact(void)
{
    static const int32_t thresholds[] = {0, 1, 32768, 65535, 65536, 65537, 3 * 65536};
    static const int expected[] = {3, 3, 3, 3, 2, 1, 1};
    for (int i = 0; i < 7; i++) {
        config.threshold_q16 = thresholds[i];
        feed_mixed(STAD_SCORE_BAD);
        TEST_ASSERT_EQUAL_INT32(expected[i], score.counts.wrong_visible);
    }
}

static void test_score_d1_needs_three_px_and_five_percent(void)
{
    /* truth 80 px: 5 % is 4 px */
    static const int16_t disp[] = {84 * 16, 84 * 16 + 1, 83 * 16 + 1, 83 * 16, 3 * 16 + 1, 3 * 16};
    static const int32_t truth[] = {PX(80), PX(80), PX(80), PX(80), 0, 0};
    static const uint8_t label[] = {VIS, VIS, VIS, VIS, VIS, VIS};
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_score_begin(&score, &config));
    feed(disp, truth, label, 6);
    TEST_ASSERT_EQUAL_INT32(2, score.counts.d1_visible); /* 84 + 1/16, and 3 + 1/16 against 0 */
}

static void test_score_none_follows_min_disparity(void)
{
    int16_t disp[4] = {-80, -79, -64, -96}; /* min_disparity -4: none is -80 */
    const int32_t truth[4] = {PX(-5), PX(-4), PX(-4), PX(-4)};
    const uint8_t label[4] = {VIS, VIS, VIS, VIS};
    stad_score_config_init(&config, STAD_SCORE_BAD, -4, 4); /* scored from x = 0 on */
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_score_begin(&score, &config));
    stad_score_row(&score, 0, disp, truth, label, 4);
    TEST_ASSERT_EQUAL_INT32(4, score.counts.visible);
    TEST_ASSERT_EQUAL_INT32(2, score.counts.missing_visible);
    TEST_ASSERT_EQUAL_INT32(0, score.counts.wrong_visible);
}

static void test_score_columns_left_of_range_do_not_count(void)
{
    static const struct {
        int min, num, scored;
    } edge[] = {{0, 16, 4}, {3, 16, 1}, {4, 16, 0}, {10, 16, 0}, {-16, 16, 20}, {-20, 16, 20}, {-15, 16, 19}};
    int16_t disp[20] = {0};
    int32_t truth[20] = {0};
    uint8_t label[20];
    memset(label, VIS, sizeof label);
    for (int i = 0; i < 7; i++) {
        stad_score_config_init(&config, STAD_SCORE_BAD, edge[i].min, edge[i].num);
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_score_begin(&score, &config));
        stad_score_row(&score, 0, disp, truth, label, 20);
        TEST_ASSERT_EQUAL_INT32(edge[i].scored, score.counts.visible);
    }
}

static void test_score_frames_add_up(void)
{
    feed_mixed(STAD_SCORE_CHOW);
    const stad_score_counts once = score.counts;
    feed(mixed_disp, mixed_truth, mixed_label, 11);
    TEST_ASSERT_EQUAL_INT32(2 * once.visible, score.counts.visible);
    TEST_ASSERT_EQUAL_INT32(2 * once.wrong_occluded, score.counts.wrong_occluded);
    TEST_ASSERT_EQUAL_INT64(2 * once.square_sum_q16, score.counts.square_sum_q16);
    TEST_ASSERT_EQUAL_INT32((7 * STAD_COST_ONE + 8) / 16, stad_score_end(&score));
}

static void test_score_nothing_scored_has_failed(void)
{
    for (int cost = STAD_SCORE_BAD; cost < STAD_SCORE_TERMS; cost++) {
        config.cost = (uint8_t)cost;
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_score_begin(&score, &config));
        TEST_ASSERT_EQUAL_INT32(STAD_COST_FAILED, stad_score_end(&score));
    }
}

static void test_score_everything_missing_is_bad_but_half_chow(void)
{
    static const int16_t disp[] = {NONE_Q4, NONE_Q4};
    static const int32_t truth[] = {PX(5), PX(5)};
    static const uint8_t label[] = {VIS, VIS};
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_score_begin(&score, &config));
    feed(disp, truth, label, 2);
    TEST_ASSERT_EQUAL_INT32(STAD_COST_ONE, stad_score_end(&score));
    TEST_ASSERT_EQUAL_INT32(STAD_COST_ONE / 2, stad_score_cost_of(&score, STAD_SCORE_CHOW));
    TEST_ASSERT_EQUAL_INT32(STAD_COST_ONE, stad_score_cost_of(&score, STAD_SCORE_RMSE));
    TEST_ASSERT_EQUAL_INT32(0, stad_score_rmse_q16(&score));
}

static void test_score_weighted_sum_is_the_sum(void)
{
    config.weight_q8[STAD_SCORE_BAD] = 128;
    config.weight_q8[STAD_SCORE_MISSING] = 512;
    feed_mixed(STAD_SCORE_WEIGHTED);
    const int64_t expected = ((int64_t)stad_score_cost_of(&score, STAD_SCORE_BAD) * 128 +
                              (int64_t)stad_score_cost_of(&score, STAD_SCORE_MISSING) * 512 + 128) >>
                             8;
    TEST_ASSERT_EQUAL_INT32((int32_t)expected, stad_score_end(&score)); /* 0.5 * 0.6 + 2 * 0.2 = 0.7 */
    TEST_ASSERT_INT32_WITHIN(2, STAD_COST_ONE * 7 / 10, stad_score_end(&score));
    config.weight_q8[STAD_SCORE_BLIND] = 1; /* a term that was never fed */
    feed_mixed(STAD_SCORE_WEIGHTED);
    TEST_ASSERT_EQUAL_INT32(STAD_COST_FAILED, stad_score_end(&score));
}

static void test_score_bad_config_is_refused(void)
{
    config.num_disparities = 0;
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_score_begin(&score, &config));
    setUp();
    config.threshold_q16 = -1;
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_score_begin(&score, &config));
    setUp();
    config.cost = STAD_SCORE_WEIGHTED + 1;
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_score_begin(&score, &config));
    setUp();
    config.photo_limit = 0;
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_score_begin(&score, &config));
    setUp();
    config.weight_q8[3] = -1;
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_score_begin(&score, &config));
}

static void test_score_extreme_errors_do_not_overflow(void)
{
    static const int16_t disp[] = {32767, -15};
    static const int32_t truth[] = {-PX(4095), PX(4095)};
    static const uint8_t label[] = {VIS, VIS};
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_score_begin(&score, &config));
    for (int i = 0; i < 100000; i++)
        feed(disp, truth, label, 2);
    TEST_ASSERT_EQUAL_INT32(200000, score.counts.wrong_visible);
    TEST_ASSERT_GREATER_THAN_INT32(PX(5000), stad_score_rmse_q16(&score));
    TEST_ASSERT_EQUAL_INT32(STAD_COST_ONE, stad_score_cost_of(&score, STAD_SCORE_RMSE));
}

/* Counts that no rows make, from a hand that writes into the struct, are no cost below nothing. */
static void test_score_negative_counts_cost_nothing(void)
{
    TEST_ASSERT_EQUAL(STAD_OK, stad_score_begin(&score, &config));
    score.counts.considered = 100;
    score.counts.speckle = -7;
    TEST_ASSERT_EQUAL_INT32(0, stad_score_cost_of(&score, STAD_SCORE_SPECKLE));
}

/* Rows longer than what is counted at a time; every pixel the same, of each kind in turn. */
static void test_score_long_rows_count_every_pixel(void)
{
    enum { MOST = 1024 };
    static const int lengths[] = {1, 254, 255, 256, 510, 511, MOST};
    static int16_t d[16 + MOST];
    static int32_t t[16 + MOST];
    static uint8_t l[16 + MOST];
    for (int k = 0; k < 7 * 4; k++) {
        const int n = lengths[k / 4], occluded = k & 1, missing = k >> 1 & 1;
        for (int x = 0; x < 16 + n; x++) {
            d[x] = missing ? NONE_Q4 : 160;
            t[x] = PX(5);
            l[x] = occluded ? OCC : VIS;
        }
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_score_begin(&score, &config));
        stad_score_row(&score, 0, d, t, l, 16 + n);
        TEST_ASSERT_EQUAL_INT32(occluded ? 0 : n, score.counts.visible);
        TEST_ASSERT_EQUAL_INT32(occluded ? n : 0, score.counts.occluded);
        TEST_ASSERT_EQUAL_INT32(missing && !occluded ? n : 0, score.counts.missing_visible);
        TEST_ASSERT_EQUAL_INT32(missing && occluded ? n : 0, score.counts.missing_occluded);
        TEST_ASSERT_EQUAL_INT32(missing || occluded ? 0 : n, score.counts.wrong_visible);
        TEST_ASSERT_EQUAL_INT32(missing || occluded ? 0 : n, score.counts.d1_visible);
        TEST_ASSERT_EQUAL_INT32(!missing && occluded ? n : 0, score.counts.wrong_occluded);
        TEST_ASSERT_EQUAL_INT32(!missing && occluded ? n : 0, score.counts.d1_occluded);
        TEST_ASSERT_EQUAL_INT64(missing || occluded ? 0 : (int64_t)n * 5 * 65536, score.counts.abs_sum_q16);
        TEST_ASSERT_EQUAL_INT64(missing || occluded ? 0 : (int64_t)n * 25 * 65536, score.counts.square_sum_q16);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_score_long_rows_count_every_pixel);
    RUN_TEST(test_score_mixed_row_counts_each_kind);
    RUN_TEST(test_score_mixed_row_costs_by_hand);
    RUN_TEST(test_score_rmse_and_mae_by_hand);
    RUN_TEST(test_score_threshold_is_exact);
    RUN_TEST(test_score_d1_needs_three_px_and_five_percent);
    RUN_TEST(test_score_none_follows_min_disparity);
    RUN_TEST(test_score_columns_left_of_range_do_not_count);
    RUN_TEST(test_score_frames_add_up);
    RUN_TEST(test_score_nothing_scored_has_failed);
    RUN_TEST(test_score_everything_missing_is_bad_but_half_chow);
    RUN_TEST(test_score_weighted_sum_is_the_sum);
    RUN_TEST(test_score_bad_config_is_refused);
    RUN_TEST(test_score_extreme_errors_do_not_overflow);
    RUN_TEST(test_score_negative_counts_cost_nothing);
    return UNITY_END();
}
