/* SPDX-License-Identifier: MIT
 * unit/test_divide.c - 64-bit division bit by bit is C's. */
#include "base/divide.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* xorshift64, shifted so that every length of number comes. */
static int64_t draw(uint64_t *state, int least_shift)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    const uint64_t v = *state >> (least_shift + (int)(*state % (unsigned)(62 - least_shift)));
    return *state & 1024 ? -(int64_t)v : (int64_t)v;
}

static void test_divide_equals_the_operator(void)
{
    uint64_t state = 88172645463325252u;
    for (int i = 0; i < 200000; i++) {
        const int64_t a = draw(&state, 1), b = draw(&state, 2);
        TEST_ASSERT_EQUAL_INT64(a / (b ? b : 1), stad_div_i64(a, b ? b : 1));
    }
}

static void test_divide_ends_of_the_range(void)
{
    const int64_t most = INT64_MAX, divisor = ((int64_t)1 << 62) - 1;
    TEST_ASSERT_EQUAL_INT64(most, stad_div_i64(most, 1));
    TEST_ASSERT_EQUAL_INT64(-most, stad_div_i64(most, -1));
    TEST_ASSERT_EQUAL_INT64(most / divisor, stad_div_i64(most, divisor));
    TEST_ASSERT_EQUAL_INT64(0, stad_div_i64(0, -5));
    TEST_ASSERT_EQUAL_INT64(0, stad_div_i64(-4, 5));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_divide_equals_the_operator);
    RUN_TEST(test_divide_ends_of_the_range);
    return UNITY_END();
}
