/* SPDX-License-Identifier: MIT
 * unit/test_tune_extremes.c - what the tuner meets seldom: quotients beyond 32 bits, a method of another name, a generator's 0. */
#include "tune_case.h"

#include "tune/tune_walk.h"

static stad_tune tune;
static stad_tune_config config;

void setUp(void)
{
    stad_tune_config_stereo(&config, STAD_TUNE_FOR_ANY);
}

void tearDown(void)
{
}

static void test_tune_quotient_beyond_32_bits_is_held(void)
{
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, stad_tune_div_q16((int64_t)1 << 40, 1));
    TEST_ASSERT_EQUAL_INT32(-INT32_MAX, stad_tune_div_q16(-((int64_t)1 << 40), 1));
    TEST_ASSERT_EQUAL_INT32(3 << 15, stad_tune_div_q16(3, 2));
}

static void test_tune_method_of_another_name_is_refused(void)
{
    stad_point x;
    config.method = STAD_TUNE_SD;
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_tune_ncg_init(&tune, &config, &sample_start));
    TEST_ASSERT_EQUAL_INT(0, stad_tune_ask(&tune, &x));
    config.method = STAD_TUNE_NCG;
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_tune_sd_init(&tune, &config, &sample_start));
}

/* A generator's state of 0 would stay 0: for each number of points known when draws begin, the seed that makes it 0. */
static void test_tune_seed_that_begins_at_0_draws_all_the_same(void)
{
    config.method = STAD_TUNE_HYBRID;
    config.budget = 100;
    for (uint32_t count = 1; count <= 100; count++) {
        config.seed = 2463534242u ^ (0u - count * 2654435761u);
        TEST_ASSERT_GREATER_OR_EQUAL_INT(40, run_search(&tune, &config, &sample_start, bowl));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_tune_quotient_beyond_32_bits_is_held);
    RUN_TEST(test_tune_method_of_another_name_is_refused);
    RUN_TEST(test_tune_seed_that_begins_at_0_draws_all_the_same);
    return UNITY_END();
}
