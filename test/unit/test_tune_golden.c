/* SPDX-License-Identifier: MIT
 * unit/test_tune_golden.c - the same costs give the same trajectory, on every compiler and core.
 *
 * The hash covers every point asked for and every cost told. A change of the method changes it: then take the printed value,
 * and say in the commit what the change is good for. test_tune_targets.sh runs this file on other cores. */
#include "tune_case.h"

static const struct {
    int method;
    int purpose;
    int budget;
    int cheap; /* mask */
    uint32_t hash;
} golden[] = {
    {STAD_TUNE_NCG, STAD_TUNE_FOR_ANY, 150, 0, 0xd2d3b7bcu},       {STAD_TUNE_NCG, STAD_TUNE_FOR_BAD, 100, 0, 0x5148f803u},
    {STAD_TUNE_NCG, STAD_TUNE_FOR_CHOW, 200, 0, 0x2e6fd0d4u},      {STAD_TUNE_NCG, STAD_TUNE_FOR_BAD, 100, 40, 0x4ed9f637u},
    {STAD_TUNE_NCG_PAPER, STAD_TUNE_FOR_ANY, 150, 0, 0xf6563426u}, {STAD_TUNE_SD, STAD_TUNE_FOR_ANY, 150, 0, 0xeb5f8045u},
    {STAD_TUNE_HYBRID, STAD_TUNE_FOR_ANY, 150, 0, 0x58c77a84u},
};

void setUp(void)
{
}

void tearDown(void)
{
}

static void test_tune_trajectory_is_the_golden_one(void)
{
    static stad_tune tune;
    stad_tune_config config;
    for (size_t i = 0; i < sizeof golden / sizeof *golden; i++) {
        stad_tune_config_stereo(&config, golden[i].purpose);
        config.method = (uint8_t)golden[i].method;
        config.budget = (int16_t)golden[i].budget;
        config.cheap_mask = (uint8_t)golden[i].cheap;
        config.seed = 12345;
        run_search(&tune, &config, &sample_start, bowl);
        TEST_ASSERT_EQUAL_HEX32(golden[i].hash, hash_of(&tune));
    }
}

static void test_tune_logarithm_and_power_are_inverse(void)
{
    for (uint32_t v = 1; v <= 32767; v++)
        TEST_ASSERT_EQUAL_UINT32(v, (uint32_t)((stad_exp2_q16(stad_log2_q16(v)) + 32768) >> 16));
    TEST_ASSERT_EQUAL_INT32(31 * 65536 / 2, stad_log2_q16(46341)); /* 2^15.5 = 46340.95 */
    TEST_ASSERT_EQUAL_INT32(0, stad_log2_q16(0));
    TEST_ASSERT_EQUAL_INT64(1, stad_exp2_q16(INT32_MIN));
}

static void test_tune_square_root_rounds_down(void)
{
    static const uint64_t edge[] = {0, 1, 2, 3, 4, 15, 16, 17, 4294967295u, 4294967296u, UINT64_MAX};
    for (size_t i = 0; i < sizeof edge / sizeof *edge; i++) {
        const uint64_t r = stad_isqrt(edge[i]);
        TEST_ASSERT_TRUE(r * r <= edge[i]);
        TEST_ASSERT_TRUE(r == UINT32_MAX || (r + 1) * (r + 1) > edge[i]);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_tune_trajectory_is_the_golden_one);
    RUN_TEST(test_tune_logarithm_and_power_are_inverse);
    RUN_TEST(test_tune_square_root_rounds_down);
    return UNITY_END();
}
