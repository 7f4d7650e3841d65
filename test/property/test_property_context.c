/* SPDX-License-Identifier: MIT
 * property/test_property_context.c - workspaces, contexts and the order of calls: nothing leaks from one to another. */
#include <stdlib.h>
#include <string.h>

#include "stad/status.h"
#include "support/fixture.h"
#include "unity.h"

#define SEED 77u

void setUp(void)
{
}

void tearDown(void)
{
}

/* What a fresh matcher gives, into expected; speckle off. */
static void make(fixture *f, uint32_t index, int mode, int memory)
{
    fixture_make(f, SEED, index, mode, memory, (int)(index & 1));
    f->c.params.speckle_window_size = 0;
    fixture_run(f, SUBJECT_FRAME);
    memcpy(f->expected, f->got, (size_t)f->c.width * (size_t)f->c.height * 2);
}

#define FOR_EACH_PLAN(mode, memory)      \
    for (int mode = 0; mode < 4; mode++) \
        for (int memory = 0; memory < 2; memory++)

static void test_property_workspace_every_offset_is_refused_or_right(void)
{
    FOR_EACH_PLAN(mode, memory)
    {
        fixture f;
        bound_match b;
        make(&f, 3, mode, memory);
        bound_make(&b, &f, 1);
        for (size_t offset = 0; offset < 2 * STAD_ALIGN; offset++) {
            stad_geometry g = subject_geometry(&f.c, &b.p);
            void *work = subject_alloc(b.bytes, offset, (uint32_t)offset);
            stad_match m;
            int status = stad_match_init(&m, &g, work, b.bytes);
            if (offset % STAD_ALIGN == 0) {
                TEST_ASSERT_EQUAL_INT(STAD_OK, status);
            }
            if (status == STAD_OK) {
                bound_match moved = {m, b.p, work, b.bytes};
                TEST_ASSERT_EQUAL_INT(STAD_OK, stad_match_begin(&moved.m, &moved.p));
                bound_finish(&moved, &f, 0);
                fixture_expect_same(&f, "workspace at an offset");
            } else {
                TEST_ASSERT_EQUAL_INT(STAD_E_SIZE, status);
            }
            TEST_ASSERT_TRUE(subject_guards_stand(work));
            subject_free(work);
        }
        bound_free(&b);
        fixture_free(&f);
    }
}

static void test_property_workspace_too_small_or_null_is_refused(void)
{
    FOR_EACH_PLAN(mode, memory)
    {
        fixture f;
        bound_match b;
        stad_geometry g;
        make(&f, 4, mode, memory);
        bound_make(&b, &f, 1);
        g = subject_geometry(&f.c, &b.p);
        TEST_ASSERT_EQUAL_INT(STAD_E_SIZE, stad_match_init(&b.m, &g, b.work, b.bytes - 1));
        TEST_ASSERT_EQUAL_INT(STAD_E_SIZE, stad_match_init(&b.m, &g, b.work, 0));
        TEST_ASSERT_EQUAL_INT(STAD_E_SIZE, stad_match_init(&b.m, &g, NULL, b.bytes));
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_match_init(&b.m, &g, b.work, b.bytes));
        bound_free(&b);
        fixture_free(&f);
    }
}

static void test_property_poisoned_relocated_workspace_same_bits(void)
{
    for (uint32_t i = 0; i < 24; i++) {
        FOR_EACH_PLAN(mode, memory)
        {
            fixture f;
            make(&f, i, mode, memory);
            for (uint32_t poison = 0; poison < 3; poison++) {
                bound_match b;
                bound_make(&b, &f, hash_pair(i, poison));
                memset(b.work, poison == 0 ? 0 : poison == 1 ? 0xff : 0x7f, b.bytes);
                TEST_ASSERT_EQUAL_INT(STAD_OK, stad_match_begin(&b.m, &b.p));
                bound_finish(&b, &f, 0);
                fixture_expect_same(&f, "poisoned workspace");
                bound_free(&b);
            }
            fixture_free(&f);
        }
    }
}

static void test_property_two_contexts_interleaved_do_not_disturb(void)
{
    for (uint32_t i = 0; i < 60; i++) {
        fixture f[2];
        bound_match b[2];
        uint32_t order = hash_pair(SEED, i);
        int pushed[2] = {0, 0}, pulled[2] = {0, 0};
        for (int k = 0; k < 2; k++) {
            make(&f[k], 2 * i + (uint32_t)k, rng_range(&order, 0, 3), rng_range(&order, 0, 1));
            bound_make(&b[k], &f[k], i + (uint32_t)k);
            TEST_ASSERT_EQUAL_INT(STAD_OK, stad_match_begin(&b[k].m, &b[k].p));
        }
        while (pulled[0] < f[0].c.height || pulled[1] < f[1].c.height) {
            int k = rng_range(&order, 0, 1);
            if (pushed[k] < f[k].c.height && rng_range(&order, 0, 1)) {
                pushed[k] += bound_push(&b[k], &f[k], pushed[k]) == STAD_OK;
            } else if (pulled[k] < f[k].c.height) {
                pulled[k] += bound_pull(&b[k], &f[k]) >= 0;
            }
        }
        for (int k = 0; k < 2; k++) {
            fixture_expect_same(&f[k], "one of two contexts");
            bound_free(&b[k]);
            fixture_free(&f[k]);
        }
    }
}

/* One matcher for several frames: other parameters, and frames dropped half way, leave no trace. */
static void test_property_parameters_changed_between_frames_leave_no_trace(void)
{
    for (uint32_t i = 0; i < 40; i++) {
        FOR_EACH_PLAN(mode, memory)
        {
            fixture f;
            bound_match b;
            uint32_t s = hash_pair(SEED + 1, i);
            make(&f, i, mode, memory);
            bound_make(&b, &f, i);
            for (int frame = 0; frame < 4; frame++) {
                stad_params p = b.p;
                int drop = rng_range(&s, 0, f.c.height - 1), step = mode == STAD_MODE_3WAY ? 16 : 8;
                test_case whole = f.c;
                p.num_disparities = (int16_t)(step * rng_range(&s, 1, b.p.num_disparities / step));
                p.min_disparity = (int16_t)rng_range(&s, -f.c.width, f.c.width);
                whole.params = p;
                if (!case_defined(&whole)) {
                    p.num_disparities = b.p.num_disparities;
                    p.min_disparity = b.p.min_disparity;
                }
                p.p1 = (int16_t)rng_range(&s, 1, b.p.p1);
                p.p2 = (int16_t)rng_range(&s, p.p1 + 1, b.p.p2 > p.p1 ? b.p.p2 : p.p1 + 1);
                p.block_size = (int16_t)(rng_range(&s, 0, b.p.block_size / 2) * 2 + 1);
                p.pre_filter_cap = (int16_t)(rng_range(&s, 7, b.p.pre_filter_cap / 2) * 2 + 1);
                p.uniqueness_ratio = (int16_t)rng_range(&s, 0, 99);
                TEST_ASSERT_EQUAL_INT_MESSAGE(STAD_OK, stad_match_begin(&b.m, &p), f.text);
                if (frame % 2) {
                    for (int y = 0; y < drop; y++) {
                        while (bound_pull(&b, &f) >= 0) {
                        }
                        TEST_ASSERT_EQUAL_INT(STAD_OK, bound_push(&b, &f, y));
                    }
                } else {
                    fixture own;
                    fixture_make(&own, SEED, i, mode, memory, (int)(i & 1));
                    own.c.params = p;
                    case_text(&own.c, own.text, sizeof own.text);
                    fixture_run(&own, SUBJECT_FRAME);
                    bound_finish(&b, &f, 0);
                    memcpy(own.expected, own.got, (size_t)f.c.width * (size_t)f.c.height * 2);
                    memcpy(own.got, f.got, (size_t)f.c.width * (size_t)f.c.height * 2);
                    fixture_expect_same(&own, "frame with changed parameters");
                    fixture_free(&own);
                }
            }
            TEST_ASSERT_EQUAL_INT(STAD_OK, stad_match_begin(&b.m, &b.p));
            bound_finish(&b, &f, 0);
            fixture_expect_same(&f, "back to the first parameters");
            bound_free(&b);
            fixture_free(&f);
        }
    }
}

static void test_property_rows_past_the_end_are_refused(void)
{
    FOR_EACH_PLAN(mode, memory)
    {
        fixture f;
        bound_match b;
        make(&f, 6, mode, memory);
        bound_make(&b, &f, 9);
        TEST_ASSERT_EQUAL_INT(STAD_E_STATE, bound_push(&b, &f, 0));
        TEST_ASSERT_EQUAL_INT(STAD_E_STATE, bound_pull(&b, &f));
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_match_begin(&b.m, &b.p));
        TEST_ASSERT_EQUAL_INT(STAD_AGAIN, bound_pull(&b, &f));
        for (int y = 0; y < f.c.height; y++) {
            while (bound_pull(&b, &f) >= 0) {
            }
            TEST_ASSERT_EQUAL_INT(STAD_OK, bound_push(&b, &f, y));
        }
        for (int k = 0; k < 3; k++) {
            TEST_ASSERT_EQUAL_INT(STAD_E_STATE, bound_push(&b, &f, 0));
        }
        bound_finish(&b, &f, f.c.height);
        fixture_expect_same(&f, "after a row too many");
        TEST_ASSERT_EQUAL_INT(STAD_E_STATE, bound_pull(&b, &f));
        TEST_ASSERT_EQUAL_INT(STAD_E_STATE, bound_push(&b, &f, 0));
        bound_free(&b);
        fixture_free(&f);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_property_workspace_every_offset_is_refused_or_right);
    RUN_TEST(test_property_workspace_too_small_or_null_is_refused);
    RUN_TEST(test_property_poisoned_relocated_workspace_same_bits);
    RUN_TEST(test_property_two_contexts_interleaved_do_not_disturb);
    RUN_TEST(test_property_parameters_changed_between_frames_leave_no_trace);
    RUN_TEST(test_property_rows_past_the_end_are_refused);
    return UNITY_END();
}
