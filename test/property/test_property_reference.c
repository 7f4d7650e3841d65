/* SPDX-License-Identifier: MIT
 * property/test_property_reference.c - random cases: the library against the specification written out plainly. */
#include <stdlib.h>
#include <string.h>

#include "support/fixture.h"
#include "support/reference.h"
#include "unity.h"

#define CASES 200
#define SEED  501u

void setUp(void)
{
}

void tearDown(void)
{
}

static void expect_mode(int mode)
{
    for (uint32_t i = 0; i < CASES; i++) {
        for (int memory = 0; memory < 2; memory++) {
            fixture f;
            fixture_make(&f, SEED, i, mode, memory, (int)(i & 1));
            reference_match(&f.c.params, mode, 0, f.left, f.right, f.c.width, f.c.height, f.c.channels, f.expected);
            fixture_run(&f, SUBJECT_FRAME);
            fixture_expect_same(&f, "whole frame");
            for (uint32_t order = 0; order < 4; order++) {
                f.c.interleave = hash_pair(i, order);
                fixture_run(&f, SUBJECT_ROWS);
                fixture_expect_same(&f, "rows in a random order of pushes and pulls");
            }
            fixture_free(&f);
        }
    }
}

static void test_property_sgbm_random_equals_reference(void)
{
    expect_mode(STAD_MODE_SGBM);
}

static void test_property_hh_random_equals_reference(void)
{
    expect_mode(STAD_MODE_HH);
}

static void test_property_3way_random_equals_reference(void)
{
    expect_mode(STAD_MODE_3WAY);
}

static void test_property_hh4_random_equals_reference(void)
{
    expect_mode(STAD_MODE_HH4);
}

/* Row strides that are wider than the row, or negative; every second pixel of a frame: no copy is needed. */
static void test_property_strides_same_bits(void)
{
    for (uint32_t i = 0; i < 20; i++) {
        fixture f;
        bound_match b;
        fixture_make(&f, SEED + 1, i, (int)(i & 3), 0, 0);
        f.c.params.speckle_window_size = 0;
        fixture_run(&f, SUBJECT_FRAME);
        memcpy(f.expected, f.got, (size_t)f.c.width * (size_t)f.c.height * 2);
        bound_make(&b, &f, i);
        {
            int step = 2 * f.c.channels, w = f.c.width, h = f.c.height;
            ptrdiff_t stride = (ptrdiff_t)w * step + 5, top = (h - 1) * stride;
            uint8_t *wide_l = malloc((size_t)(stride * h)), *wide_r = malloc((size_t)(stride * h));
            int16_t *out = malloc((size_t)(w + 3) * (size_t)h * 2);
            for (int y = 0; y < h; y++) { /* stored bottom up */
                for (int k = 0; k < w * f.c.channels; k++) {
                    ptrdiff_t at = top - y * stride + k / f.c.channels * step + k % f.c.channels;
                    wide_l[at] = f.left[y * w * f.c.channels + k];
                    wide_r[at] = f.right[y * w * f.c.channels + k];
                }
            }
            {
                stad_image l = {wide_l + top, w, h, f.c.channels, step, -stride};
                stad_image r = {wide_r + top, w, h, f.c.channels, step, -stride};
                TEST_ASSERT_EQUAL_INT_MESSAGE(0, stad_match_frame(&b.m, &b.p, &l, &r, out, w + 3, NULL, 0), f.text);
            }
            for (int y = 0; y < h; y++) {
                memcpy(f.got + y * w, out + y * (w + 3), (size_t)w * 2);
            }
            free(wide_l), free(wide_r), free(out);
        }
        fixture_expect_same(&f, "strided images");
        bound_free(&b);
        fixture_free(&f);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_property_sgbm_random_equals_reference);
    RUN_TEST(test_property_3way_random_equals_reference);
    RUN_TEST(test_property_hh_random_equals_reference);
    RUN_TEST(test_property_hh4_random_equals_reference);
    RUN_TEST(test_property_strides_same_bits);
    return UNITY_END();
}
