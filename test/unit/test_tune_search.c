/* SPDX-License-Identifier: MIT
 * unit/test_tune_search.c - what the swept search does besides walking: runs of powers, leaps, another block, close draws. */
#include "tune_case.h"

#include <stdlib.h>

static stad_tune tune;
static stad_tune_config config;

void setUp(void)
{
    stad_tune_config_stereo(&config, STAD_TUNE_FOR_ANY);
    config.budget = 200;
}

void tearDown(void)
{
}

static int32_t best_value(int i)
{
    stad_point x;
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_best(&tune, &x, NULL));
    return x.v[i];
}

/* Lower with every doubling of disp12, and towards a uniqueness of 20. */
static int32_t doublings(const stad_point *x)
{
    return 100000 - 10000 * stad_log2_q16((uint32_t)x->v[STAD_TUNE_DISP12_MAX_DIFF]) / 65536 +
           10 * abs(x->v[STAD_TUNE_UNIQUENESS_RATIO] - 20);
}

static void test_tune_poll_runs_along_powers_as_far_as_it_pays(void)
{
    stad_point x;
    int32_t cost;
    int i = 0;
    config.method = STAD_TUNE_DESCENT;
    config.free_mask = 1 << STAD_TUNE_DISP12_MAX_DIFF | 1 << STAD_TUNE_UNIQUENESS_RATIO;
    run_search(&tune, &config, &sample_start, doublings);
    do {
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_trace(&tune, i++, &x, &cost));
    } while (x.v[STAD_TUNE_DISP12_MAX_DIFF] == 1);
    for (int d = 4; d <= 8; d *= 2) {
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_trace(&tune, i++, &x, &cost));
        TEST_ASSERT_EQUAL_INT(d, x.v[STAD_TUNE_DISP12_MAX_DIFF]);
    }
}

/* Evaluations of the first descent alone, and then the whole search with a few more. */
static void run_a_little_further(int more, cost_function cost)
{
    config.method = STAD_TUNE_DESCENT;
    config.budget = (int16_t)(run_search(&tune, &config, &sample_start, cost) + more);
    config.method = STAD_TUNE_NCG;
    run_search(&tune, &config, &sample_start, cost);
}

/* Two valleys of the uniqueness, the lower one out of sight of every slope. */
static int32_t two_valleys(const stad_point *x)
{
    const int u = x->v[STAD_TUNE_UNIQUENESS_RATIO];
    return u < 34 ? 60000 + 100 * abs(u - 8) : 30000 + 100 * abs(u - 38);
}

static void test_tune_leap_finds_the_other_valley(void)
{
    config.free_mask = 1 << STAD_TUNE_UNIQUENESS_RATIO;
    run_a_little_further(0, two_valleys);
    TEST_ASSERT_EQUAL_INT(8, best_value(STAD_TUNE_UNIQUENESS_RATIO));
    run_a_little_further(5, two_valleys);
    TEST_ASSERT_GREATER_THAN_INT(33, best_value(STAD_TUNE_UNIQUENESS_RATIO));
}

/* Block 5 is worse than 3 until P1 has found its place there. */
static int32_t other_block(const stad_point *x)
{
    const int p1 = x->v[STAD_TUNE_P1], block = x->v[STAD_TUNE_BLOCK_SIZE];
    if (block == 3)
        return 50000 + 10 * abs(p1 - 72);
    return block == 5 ? 40000 + 400 * abs(p1 - 190) : 90000;
}

static void test_tune_another_block_is_descended_from_once(void)
{
    config.free_mask = 1 << STAD_TUNE_P1 | 1 << STAD_TUNE_BLOCK_SIZE;
    run_a_little_further(0, other_block);
    TEST_ASSERT_EQUAL_INT(3, best_value(STAD_TUNE_BLOCK_SIZE));
    run_a_little_further(4, other_block);
    TEST_ASSERT_EQUAL_INT(5, best_value(STAD_TUNE_BLOCK_SIZE));
}

static void test_tune_every_third_cross_lies_close_to_the_best(void)
{
    stad_point x, best = sample_start;
    int32_t cost, least = INT32_MAX;
    int close = 0;
    const int n = run_search(&tune, &config, &sample_start, bowl);
    for (int i = 0; i < n; i++) {
        stad_tune_trace(&tune, i, &x, &cost);
        const int near = memcmp(&x.v[2], &best.v[2], 4 * sizeof *x.v) == 0 && 10 * abs(x.v[0] - best.v[0]) <= best.v[0] + 10 &&
                         10 * abs(x.v[1] - best.v[1]) <= best.v[1];
        if (i >= 150 && i % 3 == 0)
            close += near;
        if (cost < least) {
            least = cost;
            best = x;
        }
    }
    TEST_ASSERT_EQUAL_INT(200, n);
    TEST_ASSERT_GREATER_OR_EQUAL_INT(12, close); /* of 17; the rest are crosses, where all that is close has been tried */
}

/* A bowl whose floor is next to nothing. */
static int32_t tiny(const stad_point *x)
{
    return 50 + abs(x->v[STAD_TUNE_UNIQUENESS_RATIO] - 23) / 2 + abs(x->v[STAD_TUNE_PRE_FILTER_CAP] - 31) / 8;
}

static void test_tune_tiny_costs_reach_the_least_step(void)
{
    config.method = STAD_TUNE_DESCENT;
    run_search(&tune, &config, &sample_start, tiny);
    TEST_ASSERT_LESS_THAN_INT(20, stad_tune_counts_of(&tune).iterations);
}

/* Down by a few percent an iteration for as long as anyone walks. */
static int32_t endless_slope(const stad_point *x)
{
    return 10000000 - 40000 * (x->v[STAD_TUNE_UNIQUENESS_RATIO] < 240 ? x->v[STAD_TUNE_UNIQUENESS_RATIO] : 240);
}

static void test_tune_descent_ends_after_thirty_iterations(void)
{
    const stad_tune_axis axis = {0, 8000, 1, STAD_TUNE_LINEAR, 1};
    config.method = STAD_TUNE_DESCENT;
    config.budget = STAD_TUNE_LOG;
    config.axis[STAD_TUNE_UNIQUENESS_RATIO] = axis;
    config.free_mask = 1 << STAD_TUNE_UNIQUENESS_RATIO;
    run_search(&tune, &config, &sample_start, endless_slope);
    TEST_ASSERT_EQUAL_INT(30, stad_tune_counts_of(&tune).iterations);
}

static int32_t zero_at_last(const stad_point *x)
{
    return x->v[STAD_TUNE_UNIQUENESS_RATIO] > 30 ? 0 : bowl(x);
}

static void test_tune_cost_of_zero_keeps_the_counts(void)
{
    TEST_ASSERT_GREATER_THAN_INT(2, run_search(&tune, &config, &sample_start, zero_at_last));
    TEST_ASSERT_GREATER_OR_EQUAL_INT(2, stad_tune_counts_of(&tune).calls);
}

/* Linear axes to the far ends of what is allowed: pairs there are spread about their mean. */
static int32_t at_the_ends(const stad_point *x)
{
    return abs(x->v[0]) > 8000 && abs(x->v[1]) > 8000 ? 100 + abs(x->v[3] - 10) + abs(x->v[2] - 3) : 500000 + x->v[0];
}

static void test_tune_far_linear_ends_do_not_overflow(void)
{
    const stad_tune_axis far = {-STAD_TUNE_UNITS, STAD_TUNE_UNITS, 1, STAD_TUNE_LINEAR, 1};
    const stad_point start = {{-STAD_TUNE_UNITS, -8190, 3, 10, 63, 1}};
    const stad_point ladder[] = {{{8191, 8192, 3, 10, 63, 1}},
                                 {{-8192, -8191, 3, 10, 63, 1}},
                                 {{8190, 8192, 5, 10, 63, 1}},
                                 {{-8192, 8192, 3, 10, 63, 1}}};
    config.axis[STAD_TUNE_P1] = config.axis[STAD_TUNE_P2] = far;
    config.free_mask = 3;
    memcpy(config.ladder, ladder, sizeof ladder);
    config.ladder_count = 4;
    for (config.seed = 1; config.seed < 40; config.seed++)
        run_search(&tune, &config, &start, at_the_ends);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_tune_poll_runs_along_powers_as_far_as_it_pays);
    RUN_TEST(test_tune_leap_finds_the_other_valley);
    RUN_TEST(test_tune_another_block_is_descended_from_once);
    RUN_TEST(test_tune_every_third_cross_lies_close_to_the_best);
    RUN_TEST(test_tune_tiny_costs_reach_the_least_step);
    RUN_TEST(test_tune_descent_ends_after_thirty_iterations);
    RUN_TEST(test_tune_cost_of_zero_keeps_the_counts);
    RUN_TEST(test_tune_far_linear_ends_do_not_overflow);
    return UNITY_END();
}
