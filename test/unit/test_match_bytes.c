/* SPDX-License-Identifier: MIT
 * unit/test_match_bytes.c - the workspace: one number, whether the compiler, the function or the parts add it up. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "stad/match.h"
#include "support/fixture.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* Usable for a static array: an integer constant expression. */
static unsigned char qvga[STAD_MATCH_BYTES(320, 240, 1, 64, 5, 800, 63, STAD_MODE_SGBM, STAD_MEMORY_SMALL)];
enum { HH_BYTES = STAD_MATCH_BYTES(160, 120, 3, 32, 3, 255, 31, STAD_MODE_HH, STAD_MEMORY_SMALL) };

static size_t by_macro(const stad_geometry *g)
{
    return STAD_MATCH_BYTES(g->width, g->height, g->channels, g->max_disparities, g->max_block_size, g->max_p2,
                            g->max_pre_filter_cap, g->mode, g->memory);
}

static void expect_equal(const stad_geometry *g)
{
    size_t sum = 0, part;
    const char *name;
    char message[160];
    snprintf(message, sizeof message, "%dx%d cn %d D %d block %d p2 %d cap %d mode %d memory %d", g->width, g->height,
             g->channels, g->max_disparities, g->max_block_size, g->max_p2, g->max_pre_filter_cap, g->mode, g->memory);
    TEST_ASSERT_EQUAL_INT_MESSAGE(STAD_OK, stad_geometry_check(g, NULL), message);
    TEST_ASSERT_EQUAL_size_t_MESSAGE(by_macro(g), stad_match_bytes(g), message);
    for (int i = 0; (part = stad_match_part(g, i, &name)) != 0 || name; i++) {
        TEST_ASSERT_NOT_NULL(name);
        TEST_ASSERT_EQUAL_size_t_MESSAGE(0, part % STAD_ALIGN, name);
        sum += part;
    }
    TEST_ASSERT_NULL(name);
    TEST_ASSERT_EQUAL_size_t_MESSAGE(stad_match_bytes(g), sum, message);
}

static void test_match_bytes_macro_function_and_parts_agree(void)
{
    uint32_t s = 5;
    for (int i = 0; i < 20000; i++) {
        stad_geometry g;
        memset(&g, 0, sizeof g);
        g.width = (int16_t)rng_range(&s, 200, 1400);
        g.height = (int16_t)rng_range(&s, 1, 800);
        g.channels = (int16_t)(rng_range(&s, 0, 1) ? 1 : 3);
        g.max_disparities = (int16_t)(16 * rng_range(&s, 1, 10));
        g.max_block_size = (int16_t)(2 * rng_range(&s, 0, 18) + 1);
        g.max_p2 = (int16_t)rng_range(&s, 2, rng_range(&s, 0, 1) ? 300 : 32767);
        g.max_pre_filter_cap = (int16_t)(2 * rng_range(&s, 7, rng_range(&s, 0, 1) ? 60 : 500) + 1);
        g.mode = (uint8_t)rng_range(&s, 0, 3);
        g.memory = (uint8_t)rng_range(&s, 0, 1);
        expect_equal(&g);
    }
}

static void test_match_bytes_static_arrays_fit(void)
{
    stad_geometry g = {320, 240, 1, 64, 5, 800, 63, STAD_MODE_SGBM, STAD_MEMORY_SMALL};
    stad_geometry hh = {160, 120, 3, 32, 3, 255, 31, STAD_MODE_HH, STAD_MEMORY_SMALL};
    TEST_ASSERT_EQUAL_size_t(sizeof qvga, stad_match_bytes(&g));
    TEST_ASSERT_EQUAL_size_t(HH_BYTES, stad_match_bytes(&hh));
    TEST_ASSERT_NOT_NULL(qvga);
}

/* A larger geometry never takes less, so a workspace for the largest parameters holds all smaller ones. */
static void test_match_bytes_grow_with_every_limit(void)
{
    uint32_t s = 6;
    for (int i = 0; i < 2000; i++) {
        stad_geometry g = {640, 100, 1, 64, 5, 800, 63, (uint8_t)(i & 3), (uint8_t)(i >> 2 & 1)}, more;
        g.max_block_size = (int16_t)(2 * rng_range(&s, 0, 18) + 1);
        g.max_disparities = (int16_t)(16 * rng_range(&s, 1, 12));
        more = g;
        more.width = (int16_t)(g.width + rng_range(&s, 1, 40));
        TEST_ASSERT_GREATER_OR_EQUAL_size_t(stad_match_bytes(&g), stad_match_bytes(&more));
        more = g;
        more.max_disparities = (int16_t)(g.max_disparities + 16);
        TEST_ASSERT_GREATER_OR_EQUAL_size_t(stad_match_bytes(&g), stad_match_bytes(&more));
        more = g;
        more.max_block_size = (int16_t)(g.max_block_size + 2);
        TEST_ASSERT_GREATER_OR_EQUAL_size_t(stad_match_bytes(&g), stad_match_bytes(&more));
    }
}

/* Planned bytes must be used bytes. A part that no frame touches would be waste: nine tenths of the workspace change
 * under one of two fills. */
static void test_match_bytes_planned_are_touched(void)
{
    for (int mode = 0; mode < 4; mode++) {
        for (int memory = 0; memory < 2; memory++) {
            fixture f;
            bound_match b;
            size_t touched = 0;
            uint8_t *first;
            char message[100];
            fixture_make(&f, 3, 0, mode, memory, 0);
            fixture_free(&f);
            f.c.width = 160, f.c.height = 60, f.c.channels = 1;
            f.c.view.kind = SCENE_NOISE;
            stad_params_sample(&f.c.params, 32, 5, 1);
            f.left = malloc(160 * 60), f.right = malloc(160 * 60);
            f.expected = malloc(160 * 120), f.got = malloc(160 * 120);
            case_render(&f.c, f.left, f.right);
            bound_make(&b, &f, 1);
            first = malloc(b.bytes);
            for (int pass = 0; pass < 2; pass++) {
                memset(b.work, pass ? 0xa5 : 0x5a, b.bytes);
                TEST_ASSERT_EQUAL_INT(STAD_OK, stad_match_begin(&b.m, &b.p));
                bound_finish(&b, &f, 0);
                for (size_t i = 0; i < b.bytes; i++) {
                    uint8_t now = ((uint8_t *)b.work)[i];
                    if (pass == 0) {
                        first[i] = now == 0x5a;
                    } else {
                        touched += !(first[i] && now == 0xa5);
                    }
                }
            }
            snprintf(message, sizeof message, "mode %d memory %d: %lu of %lu bytes touched", mode, memory, (unsigned long)touched,
                     (unsigned long)b.bytes);
            TEST_MESSAGE(message);
            TEST_ASSERT_TRUE_MESSAGE(touched * 10 >= b.bytes * 9, message);
            free(first);
            bound_free(&b);
            fixture_free(&f);
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_match_bytes_macro_function_and_parts_agree);
    RUN_TEST(test_match_bytes_static_arrays_fit);
    RUN_TEST(test_match_bytes_grow_with_every_limit);
    RUN_TEST(test_match_bytes_planned_are_touched);
    return UNITY_END();
}
