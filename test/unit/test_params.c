/* SPDX-License-Identifier: MIT
 * unit/test_params.c - what is refused, under which name; and OpenCV's silent repairs done openly. */
#include <limits.h>
#include <string.h>

#include "stad/match.h"
#include "unity.h"

#define WIDTH 200

void setUp(void)
{
}

void tearDown(void)
{
}

static stad_params sound(void)
{
    stad_params p;
    stad_params_sample(&p, 64, 5, 1);
    return p;
}

static void expect_refused(const stad_params *p, int mode, int width, const char *field)
{
    const char *culprit = "untouched";
    TEST_ASSERT_EQUAL_INT_MESSAGE(STAD_E_PARAM, stad_params_check(p, mode, width, &culprit), field);
    TEST_ASSERT_EQUAL_STRING(field, culprit);
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_params_check(p, mode, width, NULL));
}

static void expect_accepted(const stad_params *p, int mode, int width)
{
    const char *culprit = "untouched";
    int status = stad_params_check(p, mode, width, &culprit);
    TEST_ASSERT_EQUAL_INT_MESSAGE(STAD_OK, status, culprit);
}

/* A table row: a field, values outside its domain, and the nearest ones inside. */
#define ROW(field) #field, offsetof(stad_params, field), sizeof(((stad_params *)0)->field)
static const struct {
    const char *name;
    size_t at, size;
    int bad[4], good[2];
    int bads, goods;
} table[] = {
    {ROW(num_disparities), {0, -16, 12, 196 + 4}, {8, 192}, 4, 2},
    {ROW(min_disparity), {-2048, 2047 - 63, 32767, -32768}, {-100, 100}, 4, 2},
    {ROW(block_size), {0, 2, -1, 137 * 2}, {1, 37}, 4, 2},
    {ROW(p1), {0, -1, 32767, -32768}, {1, 799}, 4, 2},
    {ROW(p2), {0, 200, -1, 199}, {201, 32767}, 4, 2},
    {ROW(disp12_max_diff), {0, -1, -32768, 0}, {1, 32767}, 4, 2},
    {ROW(pre_filter_cap), {14, 13, 0, 64}, {15, 32767}, 4, 2},
    {ROW(uniqueness_ratio), {-1, 100, 32767, -32768}, {0, 99}, 4, 2},
    {ROW(speckle_window_size), {-1, INT_MIN, -5, -2}, {0, INT_MAX}, 4, 2},
    {ROW(speckle_range), {-1, INT_MIN, INT_MAX, -2}, {0, 4096}, 4, 2},
};

static stad_params with(size_t row, int value)
{
    stad_params p = sound();
    if (table[row].size == 2) {
        int16_t v = (int16_t)value;
        memcpy((char *)&p + table[row].at, &v, 2);
    } else {
        int32_t v = value;
        memcpy((char *)&p + table[row].at, &v, 4);
    }
    return p;
}

static void test_params_each_field_out_of_domain_is_refused_by_name(void)
{
    for (size_t row = 0; row < sizeof table / sizeof table[0]; row++) {
        for (int mode = 0; mode < 4; mode++) {
            for (int i = 0; i < table[row].bads; i++) {
                stad_params p = with(row, table[row].bad[i]);
                expect_refused(&p, mode, WIDTH, table[row].name);
            }
        }
    }
}

static void test_params_each_field_at_the_edge_of_its_domain_is_accepted(void)
{
    for (size_t row = 0; row < sizeof table / sizeof table[0]; row++) {
        for (int i = 0; i < table[row].goods; i++) {
            stad_params p = with(row, table[row].good[i]);
            expect_accepted(&p, STAD_MODE_SGBM, WIDTH);
        }
    }
}

static void test_params_disparities_of_a_multiple_of_8_only_outside_3way(void)
{
    stad_params p = sound();
    p.num_disparities = 24;
    expect_accepted(&p, STAD_MODE_SGBM, WIDTH);
    expect_accepted(&p, STAD_MODE_HH, WIDTH);
    expect_accepted(&p, STAD_MODE_HH4, WIDTH);
    expect_refused(&p, STAD_MODE_3WAY, WIDTH, "num_disparities");
}

static void test_params_unknown_mode_is_refused(void)
{
    stad_params p = sound();
    expect_refused(&p, 4, WIDTH, "mode");
    expect_refused(&p, -1, WIDTH, "mode");
}

/* W > r: as many columns as the block's radius are too few. Only then, nothing else, is the width's fault. */
static void test_params_too_few_columns_are_refused(void)
{
    stad_params p = sound(); /* D = 64, radius 2 */
    expect_accepted(&p, STAD_MODE_SGBM, 64 + 3);
    expect_refused(&p, STAD_MODE_SGBM, 64 + 2, "block_size");
    expect_refused(&p, STAD_MODE_SGBM, 64, "num_disparities");
    p.min_disparity = -100;
    expect_accepted(&p, STAD_MODE_SGBM, 100 + 3);
    expect_refused(&p, STAD_MODE_SGBM, 100 + 2, "block_size");
}

static stad_geometry geometry(void)
{
    stad_geometry g = {WIDTH, 20, 1, 64, 5, 800, 63, STAD_MODE_SGBM, STAD_MEMORY_FAST};
    return g;
}

static void test_geometry_each_field_out_of_domain_is_refused_by_name(void)
{
    static const struct {
        const char *name;
        size_t at;
        int16_t bad[3];
    } fields[] = {
        {"width", offsetof(stad_geometry, width), {0, -1, -32768}},
        {"height", offsetof(stad_geometry, height), {0, -1, -32768}},
        {"channels", offsetof(stad_geometry, channels), {0, 2, 4}},
        {"max_disparities", offsetof(stad_geometry, max_disparities), {0, -8, 12}},
        {"max_block_size", offsetof(stad_geometry, max_block_size), {0, 2, -1}},
        {"max_p2", offsetof(stad_geometry, max_p2), {0, -1, -32768}},
        {"max_pre_filter_cap", offsetof(stad_geometry, max_pre_filter_cap), {0, 14, -1}},
    };
    for (size_t i = 0; i < sizeof fields / sizeof fields[0]; i++) {
        for (int k = 0; k < 3; k++) {
            stad_geometry g = geometry();
            const char *culprit = NULL;
            memcpy((char *)&g + fields[i].at, &fields[i].bad[k], 2);
            TEST_ASSERT_EQUAL_INT_MESSAGE(STAD_E_PARAM, stad_geometry_check(&g, &culprit), fields[i].name);
            TEST_ASSERT_EQUAL_STRING(fields[i].name, culprit);
            TEST_ASSERT_EQUAL_size_t(0, stad_match_bytes(&g));
            TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_geometry_check(&g, NULL));
        }
    }
}

static void test_geometry_unknown_mode_or_memory_plan_is_refused(void)
{
    stad_geometry g = geometry();
    const char *culprit = NULL;
    g.mode = 4;
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_geometry_check(&g, &culprit));
    TEST_ASSERT_EQUAL_STRING("mode", culprit);
    g = geometry();
    g.memory = 2;
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_geometry_check(&g, &culprit));
    TEST_ASSERT_EQUAL_STRING("memory", culprit);
}

static void test_begin_above_the_geometry_is_a_limit_by_name(void)
{
    static uint64_t work[STAD_MATCH_BYTES(WIDTH, 20, 1, 64, 5, 800, 63, 0, 0) / 8 + 4] STAD_ALIGNED;
    stad_geometry g = geometry();
    stad_match m;
    stad_params p = sound();
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_match_init(&m, &g, work, sizeof work));
    p.num_disparities = 72;
    TEST_ASSERT_EQUAL_INT(STAD_E_LIMIT, stad_match_begin(&m, &p));
    TEST_ASSERT_EQUAL_STRING("num_disparities", stad_match_culprit(&m));
    p = sound();
    p.block_size = 7;
    TEST_ASSERT_EQUAL_INT(STAD_E_LIMIT, stad_match_begin(&m, &p));
    TEST_ASSERT_EQUAL_STRING("block_size", stad_match_culprit(&m));
    p = sound();
    p.p2 = 801;
    TEST_ASSERT_EQUAL_INT(STAD_E_LIMIT, stad_match_begin(&m, &p));
    TEST_ASSERT_EQUAL_STRING("p2", stad_match_culprit(&m));
    p = sound();
    p.pre_filter_cap = 65;
    TEST_ASSERT_EQUAL_INT(STAD_E_LIMIT, stad_match_begin(&m, &p));
    TEST_ASSERT_EQUAL_STRING("pre_filter_cap", stad_match_culprit(&m));
    p = sound();
    p.uniqueness_ratio = 100;
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_match_begin(&m, &p));
    TEST_ASSERT_EQUAL_STRING("uniqueness_ratio", stad_match_culprit(&m));
    p = sound();
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_match_begin(&m, &p));
    TEST_ASSERT_NULL(stad_match_culprit(&m));
}

static void expect_normal(stad_params p, int mode, int changes, stad_params expected)
{
    TEST_ASSERT_EQUAL_INT(changes, stad_params_normalize(&p, mode));
    TEST_ASSERT_EQUAL_MEMORY(&expected, &p, sizeof p);
    TEST_ASSERT_EQUAL_INT(0, stad_params_normalize(&p, mode));
}

static void test_params_normalize_does_what_opencv_does(void)
{
    stad_params odd = {0, 64, 0, 0, 0, 0, 0, -1, -1, 0}, sgbm = {0, 64, 5, 2, 5, 1, 15, 10, 0, 0}, way3 = sgbm;
    way3.block_size = 3;
    expect_normal(odd, STAD_MODE_SGBM, 7, sgbm);
    expect_normal(odd, STAD_MODE_HH, 7, sgbm);
    expect_normal(odd, STAD_MODE_HH4, 7, sgbm);
    expect_normal(odd, STAD_MODE_3WAY, 7, way3);
    sgbm.block_size = 4;
    sgbm.p1 = 50;
    sgbm.p2 = 50;
    sgbm.pre_filter_cap = 30;
    way3 = sgbm;
    way3.block_size = 5;
    way3.p2 = 51;
    way3.pre_filter_cap = 31;
    expect_normal(sgbm, STAD_MODE_SGBM, 3, way3);
    expect_normal(sound(), STAD_MODE_SGBM, 0, sound());
}

static void test_params_starting_sets_are_opencv_s(void)
{
    stad_params p, expected = {0, 64, 3, 72, 288, 1, 63, 10, 0, 0};
    stad_params_sample(&p, 64, 3, 1);
    TEST_ASSERT_EQUAL_MEMORY(&expected, &p, sizeof p);
    stad_params_sample(&p, 64, 37, 3);
    TEST_ASSERT_EQUAL_INT(32766, p.p1);
    TEST_ASSERT_EQUAL_INT(32767, p.p2);
    stad_params_sample(&p, 65536 + 64, 3, 1);
    expect_refused(&p, STAD_MODE_SGBM, 32767, "num_disparities");
    stad_params_sample(&p, 64, 65536 + 3, 1);
    expect_refused(&p, STAD_MODE_SGBM, 640, "block_size");
    stad_params_default(&p, 64);
    expected = (stad_params){0, 64, 3, 2, 5, 1, 15, 0, 0, 0};
    TEST_ASSERT_EQUAL_MEMORY(&expected, &p, sizeof p);
}

static void test_status_every_status_has_its_name(void)
{
    TEST_ASSERT_EQUAL_STRING("STAD_OK", stad_status_name(0));
    TEST_ASSERT_EQUAL_STRING("STAD_OK", stad_status_name(7));
    TEST_ASSERT_EQUAL_STRING("STAD_AGAIN", stad_status_name(STAD_AGAIN));
    TEST_ASSERT_EQUAL_STRING("STAD_E_PARAM", stad_status_name(STAD_E_PARAM));
    TEST_ASSERT_EQUAL_STRING("STAD_E_SIZE", stad_status_name(STAD_E_SIZE));
    TEST_ASSERT_EQUAL_STRING("STAD_E_STATE", stad_status_name(STAD_E_STATE));
    TEST_ASSERT_EQUAL_STRING("STAD_E_LIMIT", stad_status_name(STAD_E_LIMIT));
    TEST_ASSERT_EQUAL_STRING("STAD_E_CORRUPT", stad_status_name(STAD_E_CORRUPT));
    TEST_ASSERT_EQUAL_STRING("STAD_E_NO_MARK", stad_status_name(STAD_E_NO_MARK));
    TEST_ASSERT_EQUAL_STRING("STAD_E_RIG", stad_status_name(STAD_E_RIG));
    TEST_ASSERT_EQUAL_STRING("STAD_E_UNKNOWN", stad_status_name(-99));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_params_each_field_out_of_domain_is_refused_by_name);
    RUN_TEST(test_params_each_field_at_the_edge_of_its_domain_is_accepted);
    RUN_TEST(test_params_disparities_of_a_multiple_of_8_only_outside_3way);
    RUN_TEST(test_params_unknown_mode_is_refused);
    RUN_TEST(test_params_too_few_columns_are_refused);
    RUN_TEST(test_geometry_each_field_out_of_domain_is_refused_by_name);
    RUN_TEST(test_geometry_unknown_mode_or_memory_plan_is_refused);
    RUN_TEST(test_begin_above_the_geometry_is_a_limit_by_name);
    RUN_TEST(test_params_normalize_does_what_opencv_does);
    RUN_TEST(test_params_starting_sets_are_opencv_s);
    RUN_TEST(test_status_every_status_has_its_name);
    return UNITY_END();
}
