/* SPDX-License-Identifier: MIT
 * property/test_property_relations.c - what the mathematics says of flipped, equal and repeated views.
 *
 * All relations need sums that do not saturate: block 3, cap 31, small penalties. */
#include <stdlib.h>
#include <string.h>

#include "support/fixture.h"
#include "unity.h"

#define SEED 1234u

void setUp(void)
{
}

void tearDown(void)
{
}

/* The case was changed: new buffers, new images. */
static void render_again(fixture *f)
{
    size_t px = (size_t)f->c.width * (size_t)f->c.height;
    fixture_free(f);
    f->left = malloc(3 * px);
    f->right = malloc(3 * px);
    f->expected = malloc(2 * px);
    f->got = malloc(2 * px);
    case_render(&f->c, f->left, f->right);
    case_text(&f->c, f->text, sizeof f->text);
}

/* N (P2 + 9 * 3 * (63 + 63)) <= 32767 for N = 8 paths and 3 channels: P2 up to 693. */
static void gentle(fixture *f, uint32_t i, int mode)
{
    fixture_make(f, SEED, i, mode, (int)(i & 1), 0);
    f->c.params.block_size = 3;
    f->c.params.pre_filter_cap = 31;
    f->c.params.p1 = (int16_t)(8 + i);
    f->c.params.p2 = (int16_t)(40 + 2 * i);
    f->c.params.speckle_window_size = 0;
    f->c.width += 3; /* more than the block's radius is left */
    render_again(f);
}

static void flip_rows(uint8_t *rows, size_t line, int height)
{
    for (int y = 0; y < height / 2; y++) {
        for (size_t i = 0; i < line; i++) {
            uint8_t *a = &rows[(size_t)y * line + i], *b = &rows[(size_t)(height - 1 - y) * line + i], t = *a;
            *a = *b;
            *b = t;
        }
    }
}

/* HH walks all eight ways, so that turning both views upside down turns the map upside down. */
static void test_property_hh_upside_down_views_give_upside_down_map(void)
{
    for (uint32_t i = 0; i < 60; i++) {
        fixture f;
        size_t line;
        gentle(&f, i, STAD_MODE_HH);
        line = (size_t)f.c.width * (size_t)f.c.channels;
        fixture_run(&f, SUBJECT_ROWS);
        memcpy(f.expected, f.got, (size_t)f.c.width * (size_t)f.c.height * 2);
        flip_rows((uint8_t *)f.expected, (size_t)f.c.width * 2, f.c.height);
        flip_rows(f.left, line, f.c.height);
        flip_rows(f.right, line, f.c.height);
        fixture_run(&f, SUBJECT_ROWS);
        fixture_expect_same(&f, "upside down");
        fixture_free(&f);
    }
}

/* Equal views cost nothing at disparity 0: no cheaper one exists, and the first of equals wins. 3WAY breaks ties otherwise. */
static void test_property_equal_views_give_disparity_zero(void)
{
    static const int modes[] = {STAD_MODE_SGBM, STAD_MODE_HH, STAD_MODE_HH4};
    for (uint32_t i = 0; i < 90; i++) {
        fixture f;
        gentle(&f, i, modes[i % 3]);
        f.c.params.min_disparity = 0;
        f.c.width = f.c.params.num_disparities + 5 + (int)(i % 7);
        f.c.height = 9;
        f.c.channels = 1;
        render_again(&f);
        memcpy(f.right, f.left, (size_t)f.c.width * 9);
        for (int k = 0; k < f.c.width * 9; k++) {
            f.expected[k] = k % f.c.width < f.c.params.num_disparities ? -16 : 0;
        }
        fixture_run(&f, SUBJECT_FRAME);
        fixture_expect_same(&f, "equal views");
        fixture_free(&f);
    }
}

/* Three equal channels triple every cost; with tripled penalties nothing else changes. */
static void test_property_three_equal_channels_equal_grey_with_tripled_penalties(void)
{
    for (uint32_t i = 0; i < 120; i++) {
        fixture f;
        size_t px;
        gentle(&f, i % 60, (int)(i & 3));
        f.c.channels = 1;
        f.c.params.uniqueness_ratio = (int16_t)(f.c.mode == STAD_MODE_3WAY ? 0 : i % 30); /* 3WAY rounds its limit */
        px = (size_t)f.c.width * (size_t)f.c.height;
        render_again(&f);
        fixture_run(&f, SUBJECT_FRAME);
        memcpy(f.expected, f.got, px * 2);
        for (size_t k = 3 * px; k-- > 0;) {
            f.left[k] = f.left[k / 3];
            f.right[k] = f.right[k / 3];
        }
        f.c.channels = 3;
        f.c.params.p1 = (int16_t)(f.c.params.p1 * 3);
        f.c.params.p2 = (int16_t)(f.c.params.p2 * 3);
        fixture_run(&f, SUBJECT_FRAME);
        fixture_expect_same(&f, "three equal channels");
        fixture_free(&f);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_property_hh_upside_down_views_give_upside_down_map);
    RUN_TEST(test_property_equal_views_give_disparity_zero);
    RUN_TEST(test_property_three_equal_channels_equal_grey_with_tripled_penalties);
    return UNITY_END();
}
