/* SPDX-License-Identifier: MIT
 * unit/test_tune_edges.c - every search ends, whatever it is told. */
#include "tune_case.h"

#include <stdio.h>

static stad_tune tune;
static stad_tune_config config;
static uint32_t noise_state;

void setUp(void)
{
    stad_tune_config_stereo(&config, STAD_TUNE_FOR_ANY);
    config.budget = STAD_TUNE_LOG;
}

void tearDown(void)
{
}

static int32_t failing(const stad_point *x)
{
    (void)x;
    return STAD_COST_FAILED;
}

static int32_t flat(const stad_point *x)
{
    (void)x;
    return 12345;
}

static int32_t zero(const stad_point *x)
{
    (void)x;
    return 0;
}

static int32_t least_penalties(const stad_point *x)
{
    return 1000 + x->v[0] + x->v[1];
}

static int32_t steep(const stad_point *x)
{
    return (int32_t)(INT32_MAX - 1 - (int32_t)x->v[3] * 10000000); /* costs far above one, down as uniqueness goes up */
}

static uint32_t next_noise(void)
{
    noise_state ^= noise_state << 13;
    noise_state ^= noise_state >> 17;
    return noise_state ^= noise_state << 5;
}

/* Any cost at all, one in eight a failure. */
static int32_t noise(const stad_point *x)
{
    (void)x;
    const uint32_t r = next_noise();
    return r % 8 == 0 ? STAD_COST_FAILED : (int32_t)((r >> 1) >> (r % 24));
}

/* The bowl with holes: one point in five cannot be scored. */
static int32_t holed(const stad_point *x)
{
    return (x->v[0] + x->v[1] + x->v[3]) % 5 == 0 ? STAD_COST_FAILED : bowl(x);
}

static void for_every_method(cost_function cost)
{
    for (int i = 0; i < 2 * (STAD_TUNE_DESCENT + 1); i++) {
        config.method = (uint8_t)(i / 2);
        run_search(&tune, &config, &sample_start, cost);
        config.cheap_mask ^= 40; /* uniqueness and disp12: now without, now with */
    }
}

static void test_tune_plateau_ends(void)
{
    for_every_method(flat);
    stad_point x;
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_best(&tune, &x, NULL));
    TEST_ASSERT_EQUAL_MEMORY(&sample_start, &x, sizeof x); /* the earliest among equals */
}

static void test_tune_every_cost_failed_has_no_best(void)
{
    stad_point x = sample_start;
    int32_t cost = 77;
    for_every_method(failing);
    TEST_ASSERT_EQUAL_INT(STAD_E_STATE, stad_tune_best(&tune, &x, &cost));
    TEST_ASSERT_EQUAL_INT32(77, cost);
}

static void test_tune_failed_start_recovers(void)
{
    for (int method = STAD_TUNE_NCG; method <= STAD_TUNE_DESCENT; method++) {
        stad_point x;
        int32_t cost = 0;
        int n = 0;
        config.method = (uint8_t)method;
        config.budget = 60;
        stad_tune_init(&tune, &config, &sample_start);
        while (stad_tune_ask(&tune, &x) == 1)
            stad_tune_tell(&tune, n++ == 0 ? STAD_COST_FAILED : bowl(&x));
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_best(&tune, NULL, &cost));
        TEST_ASSERT_LESS_THAN_INT32(bowl(&sample_start), cost);
    }
}

static void test_tune_holes_do_not_stop_it(void)
{
    int32_t cost;
    run_search(&tune, &config, &sample_start, holed);
    stad_tune_best(&tune, NULL, &cost);
    TEST_ASSERT_LESS_THAN_INT32(40000 + 2000, cost);
}

static void test_tune_zero_cost_start_ends_at_once(void)
{
    for (int method = STAD_TUNE_NCG; method <= STAD_TUNE_DESCENT; method++) {
        config.method = (uint8_t)method;
        TEST_ASSERT_EQUAL_INT(1, run_search(&tune, &config, &sample_start, zero));
    }
}

static void test_tune_budget_of_one_scores_the_start(void)
{
    config.budget = 1;
    for (int method = STAD_TUNE_NCG; method <= STAD_TUNE_DESCENT; method++) {
        config.method = (uint8_t)method;
        TEST_ASSERT_EQUAL_INT(1, run_search(&tune, &config, &sample_start, bowl));
    }
}

static void test_tune_nothing_free_scores_the_start(void)
{
    config.free_mask = 0;
    for (int method = STAD_TUNE_NCG; method <= STAD_TUNE_DESCENT; method++) {
        config.method = (uint8_t)method;
        TEST_ASSERT_EQUAL_INT(1, run_search(&tune, &config, &sample_start, bowl));
    }
}

static void test_tune_huge_costs_do_not_overflow(void)
{
    for_every_method(steep);
    config.method = STAD_TUNE_NCG;
    run_search(&tune, &config, &sample_start, steep);
    stad_point x;
    stad_tune_best(&tune, &x, NULL);
    TEST_ASSERT_EQUAL_INT(40, x.v[STAD_TUNE_UNIQUENESS_RATIO]);
}

static void test_tune_smallest_pair_keeps_its_order(void)
{
    stad_point x;
    int32_t cost;
    config.axis[STAD_TUNE_P2].lo = 1; /* 1 and sqrt(2) round to the same integer */
    for (int method = STAD_TUNE_NCG; method <= STAD_TUNE_DESCENT; method++) {
        config.method = (uint8_t)method;
        run_search(&tune, &config, &sample_start, least_penalties);
        for (int i = 0; stad_tune_trace(&tune, i, &x, &cost) == STAD_OK; i++)
            TEST_ASSERT_GREATER_THAN_INT(x.v[STAD_TUNE_P1], x.v[STAD_TUNE_P2]);
    }
}

static void test_tune_noise_ends_for_every_seed(void)
{
    for (uint32_t seed = 1; seed <= 60; seed++) {
        noise_state = seed * 2654435761u;
        config.seed = seed;
        config.budget = (int16_t)(1 + next_noise() % STAD_TUNE_LOG);
        config.free_mask = (uint8_t)(next_noise() % 64);
        config.cheap_mask = (uint8_t)(next_noise() % 64);
        for_every_method(noise);
    }
}

static void test_tune_negative_cost_is_refused_and_asked_again(void)
{
    stad_point x, y;
    stad_tune_init(&tune, &config, &sample_start);
    stad_tune_ask(&tune, &x);
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_tune_tell(&tune, -1));
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_tune_tell(&tune, INT32_MIN));
    TEST_ASSERT_EQUAL_INT(1, stad_tune_ask(&tune, &y));
    TEST_ASSERT_EQUAL_MEMORY(&x, &y, sizeof x);
    TEST_ASSERT_EQUAL_INT(0, stad_tune_counts_of(&tune).evaluations);
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_tell(&tune, 5));
}

static void test_tune_start_out_of_bounds_is_brought_in(void)
{
    const stad_point outside = {{30000, 3, 40, 99, 1000, 700}};
    for_every_method(bowl); /* checks every point asked for */
    for (int method = STAD_TUNE_NCG; method <= STAD_TUNE_DESCENT; method++) {
        config.method = (uint8_t)method;
        run_search(&tune, &config, &outside, bowl);
    }
}

static void refused(const char *field)
{
    const char *culprit = NULL;
    stad_point x;
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_tune_config_check(&config, &culprit));
    TEST_ASSERT_EQUAL_STRING(field, culprit);
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_tune_init(&tune, &config, &sample_start));
    TEST_ASSERT_EQUAL_INT(0, stad_tune_ask(&tune, &x));
    TEST_ASSERT_EQUAL_INT(STAD_E_STATE, stad_tune_tell(&tune, 1));
    setUp();
}

static void test_tune_bad_config_is_refused_by_name(void)
{
    config.axis[STAD_TUNE_P2].lo = 9000;
    refused("p2");
    config.axis[STAD_TUNE_BLOCK_SIZE].lo = 0;
    refused("block_size");
    config.axis[STAD_TUNE_UNIQUENESS_RATIO].unit = 0;
    refused("uniqueness_ratio");
    config.axis[STAD_TUNE_PRE_FILTER_CAP].scale = 5;
    refused("pre_filter_cap");
    config.budget = 0;
    refused("budget");
    config.budget = STAD_TUNE_LOG + 1;
    refused("budget");
    config.method = STAD_TUNE_DESCENT + 1;
    refused("method");
    config.ladder_count = STAD_TUNE_LADDER + 1;
    refused("ladder_count");
    config.free_mask = 64;
    refused("free_mask");
}

static void test_tune_one_point_box_ends(void)
{
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        config.axis[i].lo = config.axis[i].hi = sample_start.v[i];
    for (int method = STAD_TUNE_NCG; method <= STAD_TUNE_DESCENT; method++) {
        config.method = (uint8_t)method;
        TEST_ASSERT_EQUAL_INT(1, run_search(&tune, &config, &sample_start, bowl));
    }
}

static void test_tune_tell_before_init_is_refused(void)
{
    memset(&tune, 0, sizeof tune);
    stad_point x;
    TEST_ASSERT_EQUAL_INT(0, stad_tune_ask(&tune, &x));
    TEST_ASSERT_EQUAL_INT(STAD_E_STATE, stad_tune_tell(&tune, 1));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_tune_plateau_ends);
    RUN_TEST(test_tune_every_cost_failed_has_no_best);
    RUN_TEST(test_tune_failed_start_recovers);
    RUN_TEST(test_tune_holes_do_not_stop_it);
    RUN_TEST(test_tune_zero_cost_start_ends_at_once);
    RUN_TEST(test_tune_budget_of_one_scores_the_start);
    RUN_TEST(test_tune_nothing_free_scores_the_start);
    RUN_TEST(test_tune_huge_costs_do_not_overflow);
    RUN_TEST(test_tune_smallest_pair_keeps_its_order);
    RUN_TEST(test_tune_noise_ends_for_every_seed);
    RUN_TEST(test_tune_negative_cost_is_refused_and_asked_again);
    RUN_TEST(test_tune_start_out_of_bounds_is_brought_in);
    RUN_TEST(test_tune_bad_config_is_refused_by_name);
    RUN_TEST(test_tune_one_point_box_ends);
    RUN_TEST(test_tune_tell_before_init_is_refused);
    return UNITY_END();
}
