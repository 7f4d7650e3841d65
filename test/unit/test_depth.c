/* SPDX-License-Identifier: MIT
 * unit/test_depth.c - depth in millimetres: rounding, offset, saturation, and what has none. */
#include "stad/depth.h"
#include "unity.h"

#define NONE (-16)

void setUp(void)
{
}

void tearDown(void)
{
}

static uint16_t depth_of(uint32_t focal_baseline_q4, int16_t offset_q4, int16_t disp_q4)
{
    const stad_depth depth = {focal_baseline_q4, offset_q4, NONE};
    uint16_t mm = 4242;
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_depth_row(&depth, &disp_q4, 1, &mm));
    return mm;
}

/* f * B = 1000 px mm: 16000 in sixteenths. */
static void test_depth_divides_and_rounds_half_up(void)
{
    TEST_ASSERT_EQUAL_UINT16(1000, depth_of(16000, 0, 16)); /* 1 px */
    TEST_ASSERT_EQUAL_UINT16(100, depth_of(16000, 0, 160)); /* 10 px */
    TEST_ASSERT_EQUAL_UINT16(333, depth_of(16000, 0, 48));  /* 333.33 */
    TEST_ASSERT_EQUAL_UINT16(667, depth_of(16000, 0, 24));  /* 666.67 */
    TEST_ASSERT_EQUAL_UINT16(3, depth_of(10, 0, 4));        /* 2.5 */
    TEST_ASSERT_EQUAL_UINT16(0, depth_of(1, 0, 32767));     /* nearer than half a millimetre */
}

static void test_depth_offset_moves_infinity(void)
{
    TEST_ASSERT_EQUAL_UINT16(500, depth_of(16000, 16, 16));
    TEST_ASSERT_EQUAL_UINT16(0, depth_of(16000, -16, 16)); /* at infinity */
    TEST_ASSERT_EQUAL_UINT16(0, depth_of(16000, -32, 16)); /* beyond it */
    TEST_ASSERT_EQUAL_UINT16(16000, depth_of(16000, 1, 0));
}

static void test_depth_of_no_disparity_is_zero(void)
{
    TEST_ASSERT_EQUAL_UINT16(0, depth_of(16000, 100, NONE)); /* though the sum would be positive */
    TEST_ASSERT_EQUAL_UINT16(0, depth_of(16000, 0, 0));
    TEST_ASSERT_EQUAL_UINT16(0, depth_of(16000, 0, -1));
}

static void test_depth_saturates_at_65535(void)
{
    TEST_ASSERT_EQUAL_UINT16(65534, depth_of(65534, 0, 1));
    TEST_ASSERT_EQUAL_UINT16(65535, depth_of(65535, 0, 1));
    TEST_ASSERT_EQUAL_UINT16(65535, depth_of(65536, 0, 1));
    TEST_ASSERT_EQUAL_UINT16(65535, depth_of((uint32_t)1 << 31, 0, 32767));
    TEST_ASSERT_EQUAL_UINT16(32769, depth_of((uint32_t)1 << 31, 32767, 32767));
}

static void test_depth_refuses_a_bad_product_and_writes_nothing(void)
{
    const stad_depth zero = {0, 0, NONE}, huge = {((uint32_t)1 << 31) + 1, 0, NONE};
    const int16_t disp = 16;
    uint16_t mm = 4242;
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_depth_row(&zero, &disp, 1, &mm));
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_depth_row(&huge, &disp, 1, &mm));
    TEST_ASSERT_EQUAL_UINT16(4242, mm);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_depth_divides_and_rounds_half_up);
    RUN_TEST(test_depth_offset_moves_infinity);
    RUN_TEST(test_depth_of_no_disparity_is_zero);
    RUN_TEST(test_depth_saturates_at_65535);
    RUN_TEST(test_depth_refuses_a_bad_product_and_writes_nothing);
    return UNITY_END();
}
