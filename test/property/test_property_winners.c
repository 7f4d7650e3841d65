/* SPDX-License-Identifier: MIT
 * property/test_property_winners.c - a frame made of kept winners is the frame that a match makes: bits and counts. */
#include <stdlib.h>
#include <string.h>

#include "stad/status.h"
#include "stad/winners.h"
#include "support/fixture.h"
#include "unity.h"

#define CASES 80
#define SEED  117u

void setUp(void)
{
}

void tearDown(void)
{
}

/* A matched case whose winners are kept, and what a frame of either kind is compared by. */
typedef struct kept_case {
    fixture f;
    bound_match b;
    stad_geometry g;
    stad_image left, right;
    stad_winners w;
    void *memory, *speckle;
    size_t speckle_bytes;
} kept_case;

static void make(kept_case *k, uint32_t index, int mode, int memory)
{
    fixture_make(&k->f, SEED, index, mode, memory, (int)(index & 1));
    bound_make(&k->b, &k->f, index);
    k->g = subject_geometry(&k->f.c, &k->b.p);
    const size_t bytes = stad_winners_bytes(&k->g);
    TEST_ASSERT_EQUAL_size_t(STAD_WINNERS_BYTES(k->f.c.width, k->f.c.height), bytes);
    k->memory = subject_alloc(bytes, 0, index);
    k->speckle_bytes = STAD_SPECKLE_BYTES(k->f.c.width, k->f.c.height);
    k->speckle = subject_alloc(k->speckle_bytes, 0, index);
    k->left = stad_image_packed(k->f.left, k->f.c.width, k->f.c.height, k->f.c.channels);
    k->right = stad_image_packed(k->f.right, k->f.c.width, k->f.c.height, k->f.c.channels);
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_winners_init(&k->w, &k->g, k->memory, bytes));
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_match_keep(&k->b.m, &k->w));
}

static int match(kept_case *k, const stad_params *p, int16_t *disp)
{
    return stad_match_frame(&k->b.m, p, &k->left, &k->right, disp, k->f.c.width, k->speckle, k->speckle_bytes);
}

static int again(kept_case *k, const stad_params *p, int16_t *disp)
{
    return stad_match_frame_again(&k->b.m, p, &k->w, disp, k->f.c.width, k->speckle, k->speckle_bytes);
}

static void drop(kept_case *k)
{
    TEST_ASSERT_TRUE_MESSAGE(subject_guards_stand(k->memory), k->f.text);
    subject_free(k->memory);
    subject_free(k->speckle);
    bound_free(&k->b);
    fixture_free(&k->f);
}

static stad_params decided_otherwise(stad_params p, uint32_t index, int turn)
{
    p.uniqueness_ratio = (int16_t)((index * 7 + (uint32_t)turn * 13) % 60);
    p.disp12_max_diff = (int16_t)(1 + (index + (uint32_t)turn) % 8);
    p.speckle_window_size = turn == 1 ? 12 : 0;
    p.speckle_range = 1;
    return p;
}

static void expect_same_frames(uint32_t index, int mode, int memory)
{
    kept_case k;
    make(&k, index, mode, memory);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, match(&k, &k.b.p, k.f.expected), k.f.text);
    for (int turn = 0; turn < 3; turn++) {
        const stad_params p = decided_otherwise(k.b.p, index, turn);
        TEST_ASSERT_EQUAL_INT_MESSAGE(1, stad_winners_serve(&k.w, &p), k.f.text);
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, again(&k, &p, k.f.got), k.f.text);
        const stad_match_counts counts = *stad_match_counts_of(&k.b.m);
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_match_keep(&k.b.m, NULL));
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, match(&k, &p, k.f.expected), k.f.text);
        fixture_expect_same(&k.f, "of winners");
        TEST_ASSERT_EQUAL_MEMORY_MESSAGE(stad_match_counts_of(&k.b.m), &counts, sizeof counts, k.f.text);
    }
    drop(&k);
}

static void test_property_winners_give_the_frame_of_a_match(void)
{
    for (uint32_t i = 0; i < CASES; i++)
        for (int mode = 0; mode < 4; mode++)
            expect_same_frames(i, mode, (int)(i / 2 & 1));
}

static void expect_not_served(const kept_case *k, stad_params p)
{
    TEST_ASSERT_EQUAL_INT(0, stad_winners_serve(&k->w, &p));
}

static void test_property_winners_serve_nothing_else(void)
{
    kept_case k;
    make(&k, 2, 0, 0);
    stad_params p = k.b.p;
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, stad_winners_serve(&k.w, &p), "before a match");
    TEST_ASSERT_EQUAL_INT(STAD_E_STATE, again(&k, &p, k.f.got));
    TEST_ASSERT_EQUAL_INT(STAD_E_STATE, stad_match_pull(&k.b.m, k.f.got));
    TEST_ASSERT_EQUAL_INT(0, match(&k, &p, k.f.got));
    p.p1++, expect_not_served(&k, p), p = k.b.p;
    p.p2++, expect_not_served(&k, p), p = k.b.p;
    p.block_size += 2, expect_not_served(&k, p), p = k.b.p;
    p.pre_filter_cap += 2, expect_not_served(&k, p), p = k.b.p;
    p.min_disparity++, expect_not_served(&k, p), p = k.b.p;
    p.num_disparities += 8, expect_not_served(&k, p), p = k.b.p;
    TEST_ASSERT_EQUAL_INT(1, stad_winners_serve(&k.w, &p));
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_match_begin(&k.b.m, &p));
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, stad_winners_serve(&k.w, &p), "a frame under way");
    TEST_ASSERT_EQUAL_INT(0, match(&k, &p, k.f.got));
    stad_winners_forget(&k.w);
    expect_not_served(&k, p);
    drop(&k);
}

static void test_property_winners_take_no_rows(void)
{
    kept_case k;
    make(&k, 4, 0, 1);
    TEST_ASSERT_EQUAL_INT(0, match(&k, &k.b.p, k.f.got));
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_match_again(&k.b.m, &k.b.p, &k.w));
    TEST_ASSERT_EQUAL_INT(STAD_E_STATE, stad_match_push(&k.b.m, k.f.left, k.f.right));
    drop(&k);
}

static void test_property_winners_of_another_size_are_refused(void)
{
    kept_case k;
    make(&k, 6, 0, 0);
    const stad_winners sound = k.w;
    stad_geometry bad = k.g;
    k.w.width++;
    TEST_ASSERT_EQUAL_INT(STAD_E_SIZE, stad_match_keep(&k.b.m, &k.w));
    TEST_ASSERT_EQUAL_INT(STAD_E_SIZE, stad_match_again(&k.b.m, &k.b.p, &k.w));
    k.w = sound;
    TEST_ASSERT_EQUAL_INT(STAD_E_SIZE, stad_winners_init(&k.w, &k.g, k.memory, stad_winners_bytes(&k.g) - 1));
    TEST_ASSERT_EQUAL_INT(STAD_E_SIZE, stad_winners_init(&k.w, &k.g, NULL, stad_winners_bytes(&k.g)));
    bad.width = 0;
    TEST_ASSERT_EQUAL_size_t(0, stad_winners_bytes(&bad));
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_winners_init(&k.w, &bad, k.memory, 1 << 20));
    drop(&k);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_property_winners_give_the_frame_of_a_match);
    RUN_TEST(test_property_winners_serve_nothing_else);
    RUN_TEST(test_property_winners_take_no_rows);
    RUN_TEST(test_property_winners_of_another_size_are_refused);
    return UNITY_END();
}
