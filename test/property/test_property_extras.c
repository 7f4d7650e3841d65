/* SPDX-License-Identifier: MIT
 * property/test_property_extras.c - what lies beyond OpenCV, against the reference: median off, confidence, right view, counts. */
#include <stdlib.h>
#include <string.h>

#include "stad/status.h"
#include "support/fixture.h"
#include "support/reference.h"
#include "unity.h"

#define CASES 60
#define SEED  91u

void setUp(void)
{
}

void tearDown(void)
{
}

typedef struct maps {
    uint8_t *confidence, *expected_confidence;
    int16_t *right, *expected_right;
} maps;

static void pull_rows(bound_match *b, fixture *f, const maps *m)
{
    size_t w = (size_t)f->c.width;
    int pulled = 0, pushed = 0;
    while (pulled < f->c.height) {
        int16_t disp[8192], right[8192];
        uint8_t confidence[8192];
        int y = stad_match_pull_all(&b->m, disp, confidence, right);
        if (y < 0) {
            TEST_ASSERT_EQUAL_INT_MESSAGE(STAD_AGAIN, y, f->text);
            TEST_ASSERT_EQUAL_INT_MESSAGE(STAD_OK, bound_push(b, f, pushed++), f->text);
            continue;
        }
        memcpy(f->got + (size_t)y * w, disp, 2 * w);
        memcpy(m->right + (size_t)y * w, right, 2 * w);
        memcpy(m->confidence + (size_t)y * w, confidence, w);
        pulled++;
    }
}

static void expect_counts(const fixture *f, const stad_match_counts *n, const reference_extras *x)
{
    TEST_ASSERT_EQUAL_INT32_MESSAGE(x->considered, n->considered, f->text);
    TEST_ASSERT_EQUAL_INT32_MESSAGE(x->firm, n->firm, f->text);
    TEST_ASSERT_EQUAL_INT32_MESSAGE(x->rejected_uniqueness, n->rejected_uniqueness, f->text);
    TEST_ASSERT_EQUAL_INT32_MESSAGE(x->rejected_check, n->rejected_check, f->text);
    TEST_ASSERT_EQUAL_INT32_MESSAGE(x->valid, n->valid, f->text);
    TEST_ASSERT_EQUAL_INT32_MESSAGE(x->rejected_speckle, n->rejected_speckle, f->text);
}

static void expect_extras(uint32_t index, int mode, int memory, unsigned options)
{
    fixture f;
    bound_match b;
    maps m;
    size_t px;
    reference_extras x = {0, 0, 0, 0, 0, 0, NULL, NULL};
    fixture_make(&f, SEED, index, mode, memory, (int)(index & 1));
    f.c.params.speckle_window_size = 0;
    px = (size_t)f.c.width * (size_t)f.c.height;
    m.confidence = calloc(px, 1), m.expected_confidence = calloc(px, 1);
    m.right = calloc(px, 2), m.expected_right = calloc(px, 2);
    x.right_q4 = m.expected_right;
    x.confidence = options & STAD_MATCH_CONFIDENCE ? m.expected_confidence : NULL;
    reference_match_extras(&f.c.params, mode, options & STAD_MATCH_NO_MEDIAN ? MEND_MEDIAN : 0, f.left, f.right, f.c.width,
                           f.c.height, f.c.channels, f.expected, &x);
    bound_make(&b, &f, index);
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_match_options(&b.m, options));
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_match_begin(&b.m, &b.p));
    pull_rows(&b, &f, &m);
    fixture_expect_same(&f, options & STAD_MATCH_NO_MEDIAN ? "median off" : "with extras");
    TEST_ASSERT_EQUAL_HEX8_ARRAY_MESSAGE(m.expected_confidence, m.confidence, px, f.text);
    TEST_ASSERT_EQUAL_INT16_ARRAY_MESSAGE(m.expected_right, m.right, px, f.text);
    expect_counts(&f, stad_match_counts_of(&b.m), &x);
    bound_free(&b);
    free(m.confidence), free(m.expected_confidence), free(m.right), free(m.expected_right);
    fixture_free(&f);
}

static void test_property_extras_equal_reference(void)
{
    for (uint32_t i = 0; i < CASES; i++) {
        for (int mode = 0; mode < 4; mode++) {
            expect_extras(i, mode, (int)(i / 2 & 1), (i / 4) & 3);
        }
    }
}

/* The counters of a whole frame hold the speckle filter's too. */
static void test_property_counts_of_a_whole_frame_equal_reference(void)
{
    for (uint32_t i = 0; i < CASES; i++) {
        fixture f;
        bound_match b;
        reference_extras x = {0, 0, 0, 0, 0, 0, NULL, NULL};
        size_t bytes;
        void *work;
        fixture_make(&f, SEED + 1, i, (int)(i & 3), 0, 0);
        f.c.params.speckle_window_size = 30;
        f.c.params.speckle_range = 1;
        bytes = STAD_SPECKLE_BYTES(f.c.width, f.c.height);
        work = subject_alloc(bytes, 0, i);
        reference_match_extras(&f.c.params, f.c.mode, 0, f.left, f.right, f.c.width, f.c.height, f.c.channels, f.expected, &x);
        bound_make(&b, &f, i);
        b.p.speckle_window_size = 30;
        {
            stad_image l = stad_image_packed(f.left, f.c.width, f.c.height, f.c.channels);
            stad_image r = stad_image_packed(f.right, f.c.width, f.c.height, f.c.channels);
            TEST_ASSERT_EQUAL_INT(STAD_E_SIZE, stad_match_frame(&b.m, &b.p, &l, &r, f.got, f.c.width, work, bytes - 1));
            TEST_ASSERT_EQUAL_INT(STAD_E_SIZE, stad_match_frame(&b.m, &b.p, &l, &r, f.got, f.c.width, NULL, bytes));
            TEST_ASSERT_EQUAL_INT(0, stad_match_frame(&b.m, &b.p, &l, &r, f.got, f.c.width, work, bytes));
        }
        fixture_expect_same(&f, "frame with speckle filter");
        expect_counts(&f, stad_match_counts_of(&b.m), &x);
        TEST_ASSERT_TRUE(subject_guards_stand(work));
        subject_free(work);
        bound_free(&b);
        fixture_free(&f);
    }
}

static void test_property_unknown_option_is_refused(void)
{
    fixture f;
    bound_match b;
    fixture_make(&f, SEED, 0, 0, 0, 0);
    bound_make(&b, &f, 0);
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_match_options(&b.m, 4));
    bound_free(&b);
    fixture_free(&f);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_property_extras_equal_reference);
    RUN_TEST(test_property_counts_of_a_whole_frame_equal_reference);
    RUN_TEST(test_property_unknown_option_is_refused);
    return UNITY_END();
}
