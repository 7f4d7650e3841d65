/* SPDX-License-Identifier: MIT
 * unit/test_tune.c - the search finds what it should. */
#include "tune_case.h"

#include <stdio.h>

static stad_tune tune;
static stad_tune_config config;

void setUp(void)
{
    stad_tune_config_stereo(&config, STAD_TUNE_FOR_ANY);
}

void tearDown(void)
{
}

static int32_t best_cost(const stad_tune *t)
{
    int32_t cost = -1;
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_best(t, NULL, &cost));
    return cost;
}

static void test_tune_state_fits_four_kib(void)
{
    TEST_ASSERT_LESS_OR_EQUAL_size_t(4096, sizeof(stad_tune));
}

static void test_tune_bowl_reaches_floor_in_sixty(void)
{
    config.budget = 60;
    run_search(&tune, &config, &sample_start, bowl);
    TEST_ASSERT_LESS_THAN_INT32(40000 + 400, best_cost(&tune)); /* the floor is 40000 and up to 63 of noise; 1 percent */
}

static void test_tune_every_method_improves_bowl(void)
{
    for (int method = STAD_TUNE_NCG; method <= STAD_TUNE_DESCENT; method++) {
        config.method = (uint8_t)method;
        config.budget = 150;
        run_search(&tune, &config, &sample_start, bowl);
        TEST_ASSERT_LESS_THAN_INT32_MESSAGE(bowl(&sample_start) * 6 / 10, best_cost(&tune), "a method did not get far");
    }
}

/* 100 (y - x^2)^2 + (1 - x)^2 in 1/65536, x and y in 1/1024. */
static int32_t rosenbrock(const stad_point *p)
{
    const int64_t x = p->v[0], y = p->v[1];
    const int64_t valley = (y * 1024 - x * x) / 64;                                  /* in 1/2^14, below 2^18 */
    const int64_t cost = 25 * valley * valley / 1024 + (1024 - x) * (1024 - x) / 16; /* in 1/65536 */
    return (int32_t)(cost < 1 << 30 ? cost : 1 << 30);
}

/* How many of the points differ from an earlier one in uniqueness and disp12 alone. */
static int cheap_points(const stad_tune *t)
{
    stad_point x, y;
    int32_t cost;
    int count = 0;
    for (int i = 0; stad_tune_trace(t, i, &x, &cost) == STAD_OK; i++) {
        int found = 0;
        for (int k = 0; k < i && !found; k++) {
            TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_trace(t, k, &y, &cost));
            y.v[STAD_TUNE_UNIQUENESS_RATIO] = x.v[STAD_TUNE_UNIQUENESS_RATIO];
            y.v[STAD_TUNE_DISP12_MAX_DIFF] = x.v[STAD_TUNE_DISP12_MAX_DIFF];
            found = memcmp(&x, &y, sizeof x) == 0;
        }
        count += found;
    }
    return count;
}

static void test_tune_cheap_coordinates_are_settled(void)
{
    config.budget = 80;
    run_search(&tune, &config, &sample_start, bowl);
    const int few = cheap_points(&tune);
    config.cheap_mask = 1 << STAD_TUNE_UNIQUENESS_RATIO | 1 << STAD_TUNE_DISP12_MAX_DIFF;
    run_search(&tune, &config, &sample_start, bowl);
    TEST_ASSERT_GREATER_OR_EQUAL_INT(few + 8, cheap_points(&tune));
    TEST_ASSERT_LESS_THAN_INT32(40000 + 400, best_cost(&tune));
}

static void test_tune_cheap_coordinates_that_are_held_stay(void)
{
    stad_point x;
    int32_t cost;
    config.free_mask = 1 << STAD_TUNE_P1 | 1 << STAD_TUNE_P2;
    config.cheap_mask = 1 << STAD_TUNE_UNIQUENESS_RATIO | 1 << STAD_TUNE_DISP12_MAX_DIFF;
    run_search(&tune, &config, &sample_start, bowl);
    for (int i = 0; stad_tune_trace(&tune, i, &x, &cost) == STAD_OK; i++) {
        TEST_ASSERT_EQUAL_INT(10, x.v[STAD_TUNE_UNIQUENESS_RATIO]);
        TEST_ASSERT_EQUAL_INT(1, x.v[STAD_TUNE_DISP12_MAX_DIFF]);
    }
}

static void rosenbrock_config(stad_tune_config *c)
{
    memset(c, 0, sizeof *c);
    c->free_mask = 3;
    c->budget = STAD_TUNE_LOG;
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        c->axis[i] = (stad_tune_axis){-2048, 2047, 64, STAD_TUNE_LINEAR, 1};
}

static void test_tune_rosenbrock_finds_valley(void)
{
    const stad_point start = {{-1229, 1024, 0, 0, 0, 0}}; /* (-1.2, 1) */
    rosenbrock_config(&config);
    const int n = run_search(&tune, &config, &start, rosenbrock);
    stad_point x;
    int32_t cost;
    stad_tune_best(&tune, &x, &cost);
    char text[80];
    snprintf(text, sizeof text, "%d evaluations, (%d, %d) / 1024, cost %d", n, x.v[0], x.v[1], (int)cost);
    TEST_ASSERT_LESS_THAN_INT32_MESSAGE(rosenbrock(&start) / 100, cost, text);
}

static void test_tune_fixed_coordinates_stay(void)
{
    stad_point x;
    int32_t cost;
    config.free_mask = (1u << STAD_TUNE_P1) | (1u << STAD_TUNE_UNIQUENESS_RATIO);
    run_search(&tune, &config, &sample_start, bowl);
    for (int i = 0; stad_tune_trace(&tune, i, &x, &cost) == STAD_OK; i++) {
        TEST_ASSERT_EQUAL_INT(288, x.v[STAD_TUNE_P2]);
        TEST_ASSERT_EQUAL_INT(3, x.v[STAD_TUNE_BLOCK_SIZE]);
        TEST_ASSERT_EQUAL_INT(63, x.v[STAD_TUNE_PRE_FILTER_CAP]);
        TEST_ASSERT_EQUAL_INT(1, x.v[STAD_TUNE_DISP12_MAX_DIFF]);
    }
}

static void test_tune_pair_keeps_p2_above_p1(void)
{
    stad_point x;
    int32_t cost;
    for (int method = STAD_TUNE_NCG; method <= STAD_TUNE_DESCENT; method++) {
        config.method = (uint8_t)method;
        run_search(&tune, &config, &sample_start, bowl);
        for (int i = 0; stad_tune_trace(&tune, i, &x, &cost) == STAD_OK; i++)
            TEST_ASSERT_GREATER_THAN_INT(x.v[STAD_TUNE_P1], x.v[STAD_TUNE_P2]);
    }
}

static void test_tune_ladder_is_scored_first_and_counts(void)
{
    const stad_point rung = {{30, 90, 5, 20, 31, 2}};
    stad_point x;
    int32_t cost;
    config.ladder[0] = rung;
    config.ladder[1] = sample_start; /* the start again: no second evaluation */
    config.ladder_count = 2;
    run_search(&tune, &config, &sample_start, bowl);
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_trace(&tune, 0, &x, &cost));
    TEST_ASSERT_EQUAL_MEMORY(&sample_start, &x, sizeof x);
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_trace(&tune, 1, &x, &cost));
    TEST_ASSERT_EQUAL_MEMORY(&rung, &x, sizeof x);
}

static void test_tune_copy_goes_on_alike(void)
{
    static stad_tune copy;
    stad_point x, y;
    config.budget = 150;
    for (int cut = 0; cut < 150; cut += 7) {
        stad_tune_init(&tune, &config, &sample_start);
        for (int i = 0; i < cut && stad_tune_ask(&tune, &x) == 1; i++)
            stad_tune_tell(&tune, bowl(&x));
        memcpy(&copy, &tune, sizeof copy);
        while (stad_tune_ask(&tune, &x) == 1) {
            TEST_ASSERT_EQUAL_INT(1, stad_tune_ask(&copy, &y));
            TEST_ASSERT_EQUAL_MEMORY(&x, &y, sizeof x);
            stad_tune_tell(&tune, bowl(&x));
            stad_tune_tell(&copy, bowl(&y));
        }
        TEST_ASSERT_EQUAL_INT(0, stad_tune_ask(&copy, &y));
        TEST_ASSERT_EQUAL_MEMORY(&tune, &copy, sizeof tune);
    }
}

/* The seed of ncg serves the crosses alone: up to them two searches are alike, then they part and both gain. */
static void test_tune_crosses_spend_the_budget_and_gain(void)
{
    static stad_tune other;
    stad_point x, y;
    int32_t cost, other_cost, least = INT32_MAX;
    int same = 0;
    config.budget = STAD_TUNE_LOG;
    config.seed = 1;
    TEST_ASSERT_EQUAL_INT(STAD_TUNE_LOG, run_search(&tune, &config, &sample_start, bowl));
    config.seed = 2;
    TEST_ASSERT_EQUAL_INT(STAD_TUNE_LOG, run_search(&other, &config, &sample_start, bowl));
    for (; same < STAD_TUNE_LOG; same++) {
        stad_tune_trace(&tune, same, &x, &cost);
        stad_tune_trace(&other, same, &y, &other_cost);
        if (memcmp(&x, &y, sizeof x) != 0)
            break;
        least = cost < least ? cost : least;
    }
    TEST_ASSERT_GREATER_THAN_INT(30, same);
    TEST_ASSERT_LESS_THAN_INT(STAD_TUNE_LOG, same);
    TEST_ASSERT_LESS_THAN_INT32(least, best_cost(&tune));
    TEST_ASSERT_LESS_THAN_INT32(least, best_cost(&other));
}

static void test_tune_single_method_equals_chosen(void)
{
    static stad_tune one;
    stad_point x;
    run_search(&tune, &config, &sample_start, bowl);
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_ncg_init(&one, &config, &sample_start));
    while (stad_tune_ask(&one, &x) == 1)
        stad_tune_ncg_tell(&one, bowl(&x));
    TEST_ASSERT_EQUAL_HEX32(hash_of(&tune), hash_of(&one));
}

static void test_tune_counters_tell_memo_hits(void)
{
    config.budget = 150;
    run_search(&tune, &config, &sample_start, bowl);
    const stad_tune_counts n = stad_tune_counts_of(&tune);
    TEST_ASSERT_GREATER_THAN_INT(n.evaluations, n.calls);
    TEST_ASSERT_GREATER_THAN_INT(0, n.iterations);
}

static void expect_damaged(const stad_tune *t)
{
    TEST_ASSERT_EQUAL_INT(STAD_E_CORRUPT, stad_tune_check(t));
}

static void test_tune_check_knows_a_state(void)
{
    stad_tune sound, t;
    stad_point x;
    memset(&t, 0, sizeof t);
    TEST_ASSERT_EQUAL_INT(STAD_E_STATE, stad_tune_check(&t));
    stad_tune_config_stereo(&config, STAD_TUNE_FOR_BAD);
    stad_tune_init(&sound, &config, &sample_start);
    while (stad_tune_ask(&sound, &x) == 1) {
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_check(&sound));
        stad_tune_tell(&sound, bowl(&x));
    }
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_check(&sound));
    t = sound, t.count = 32767, expect_damaged(&t);
    t = sound, t.count = -1, expect_damaged(&t);
    t = sound, t.best = sound.count, expect_damaged(&t);
    t = sound, t.lead = -2, expect_damaged(&t);
    t = sound, t.cursor = (int16_t)(sound.count + 1), expect_damaged(&t);
    t = sound, t.phase = 3, expect_damaged(&t);
    t = sound, t.config.budget = 0, expect_damaged(&t);
    t = sound, t.cost[0] = -1, expect_damaged(&t);
    t = sound, t.start.v[0] = 0, expect_damaged(&t);
    t = sound, t.phase = 1, t.config.budget = sound.count, expect_damaged(&t);
}

/* Told up to a third of its budget. */
static void begin_search(stad_tune *t, int method, int free_mask)
{
    stad_point x;
    stad_tune_config_stereo(&config, STAD_TUNE_FOR_BAD);
    config.method = (uint8_t)method;
    config.free_mask = (uint8_t)free_mask;
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_init(t, &config, &sample_start));
    for (int n = 0; n < 33 && stad_tune_ask(t, &x) == 1; n++)
        stad_tune_tell(t, bowl(&x));
}

static int within_axes(const stad_tune *t, const stad_point *x)
{
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        const stad_tune_axis *a = &config.axis[i];
        if (config.free_mask >> i & 1 ? x->v[i] < a->lo || x->v[i] > a->hi : x->v[i] != t->start.v[i])
            return 0;
    }
    return 1;
}

/* Goes on to the end; every point asked for is one of the search's. */
static void expect_goes_on(stad_tune *t)
{
    stad_point x;
    while (stad_tune_ask(t, &x) == 1) {
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_check(t));
        TEST_ASSERT_TRUE(within_axes(t, &x));
        stad_tune_tell(t, bowl(&x));
    }
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_check(t));
}

static void test_tune_check_refuses_points_outside_their_axes(void)
{
    char text[80];
    for (int method = STAD_TUNE_NCG; method <= STAD_TUNE_DESCENT; method++) {
        for (int free_mask = 1; free_mask < 1 << STAD_TUNE_DIMS; free_mask += 2) {
            stad_tune sound;
            begin_search(&sound, method, free_mask);
            for (int k = 0; k < 4 * STAD_TUNE_DIMS; k++) {
                const int i = k % STAD_TUNE_DIMS, v = k < 12 ? 0 : config.axis[i].hi + k % 2;
                stad_tune t = sound;
                stad_point *x = k / 6 == 0 ? &t.pending : &t.point[k * 5 % t.count];
                x->v[i] = (int16_t)v;
                snprintf(text, sizeof text, "method %d, free %d, coordinate %d to %d", method, free_mask, i, v);
                TEST_ASSERT_EQUAL_INT_MESSAGE(within_axes(&t, x) ? STAD_OK : STAD_E_CORRUPT, stad_tune_check(&t), text);
                if (within_axes(&t, x))
                    expect_goes_on(&t);
            }
            expect_goes_on(&sound);
        }
    }
}

static void test_tune_best_is_least_of_trace(void)
{
    stad_point x;
    int32_t cost, least = INT32_MAX;
    run_search(&tune, &config, &sample_start, bowl);
    for (int i = 0; stad_tune_trace(&tune, i, &x, &cost) == STAD_OK; i++) {
        TEST_ASSERT_EQUAL_INT32(bowl(&x), cost);
        least = cost < least ? cost : least;
    }
    TEST_ASSERT_EQUAL_INT32(least, best_cost(&tune));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_tune_state_fits_four_kib);
    RUN_TEST(test_tune_bowl_reaches_floor_in_sixty);
    RUN_TEST(test_tune_every_method_improves_bowl);
    RUN_TEST(test_tune_cheap_coordinates_are_settled);
    RUN_TEST(test_tune_cheap_coordinates_that_are_held_stay);
    RUN_TEST(test_tune_rosenbrock_finds_valley);
    RUN_TEST(test_tune_fixed_coordinates_stay);
    RUN_TEST(test_tune_pair_keeps_p2_above_p1);
    RUN_TEST(test_tune_ladder_is_scored_first_and_counts);
    RUN_TEST(test_tune_copy_goes_on_alike);
    RUN_TEST(test_tune_crosses_spend_the_budget_and_gain);
    RUN_TEST(test_tune_single_method_equals_chosen);
    RUN_TEST(test_tune_counters_tell_memo_hits);
    RUN_TEST(test_tune_check_knows_a_state);
    RUN_TEST(test_tune_check_refuses_points_outside_their_axes);
    RUN_TEST(test_tune_best_is_least_of_trace);
    return UNITY_END();
}
