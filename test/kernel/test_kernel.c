/* SPDX-License-Identifier: MIT
 * test_kernel.c - every kernel of every tier this build holds against plain C.
 *
 * Sizes are swept, the rest is drawn from a seed (environment: STAD_SEED, default 1; STAD_ROUNDS cases a size, default 24). A
 * difference is printed with what repeats it. A tier that the processor lacks is UNAVAILABLE and its tests are ignored.
 * `test_kernel tier` runs nothing: it says whether the tier that STAD_ISA asks for is in use (exit 77: it is not). */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "kernel/kernel_case.h"
#include "unity.h"

typedef int any_case(kernel_case *);
typedef void (*any)(void);

static const kernel_set plain = KERNEL_SET("c", 8, _c, stad_path_row_sat_c, stad_path_row_u8_c);
static const kernel_set sets[] = {
    {"bound",
     8,
     stad_prefilter_row,
     stad_range_row,
     stad_cost_row_u8,
     stad_cost_row_u16,
     stad_box_add_row_u8,
     stad_box_add_row_u16,
     stad_block_row,
     stad_slide_row,
     stad_path_row,
     stad_path_row_sat,
     stad_path_row_u8,
     stad_gather_row,
     stad_best_row,
     stad_best_row_3way,
     stad_median_row,
     stad_last_row,
     stad_refine_row,
     stad_select_row,
     stad_check_row},
#ifdef STAD_PORT_X86_H
    KERNEL_SET("sse41", 8, _sse41, stad_path_row_sat_c, stad_path_row_u8_c),
    KERNEL_SET("avx2", 16, _avx2, stad_path_row_sat_c, stad_path_row_u8_c),
    KERNEL_SET("avx512", 32, _avx512, stad_path_row_sat_c, stad_path_row_u8_c),
#endif
};
enum { SETS = sizeof sets / sizeof sets[0], WIDEST = 64, REACH = 3 * WIDEST };

static const kernel_set *set; /* the tier under test */

static int has_tier(int i)
{
#ifdef STAD_PORT_X86_H
    const int has[SETS] = {1, __builtin_cpu_supports("sse4.1"), __builtin_cpu_supports("avx2"),
                           __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw")};
    return has[i];
#else
    return i == 0;
#endif
}

void setUp(void)
{
}

void tearDown(void)
{
    rooms_release();
}

static uint32_t from_environment(const char *name, uint32_t otherwise)
{
    const char *value = getenv(name);
    return value ? (uint32_t)strtoul(value, NULL, 10) : otherwise;
}

/* The case at hand, for the message when a kernel touches a forbidden page. */
static struct {
    const kernel_case *k;
    const char *name;
    uint32_t seed, round;
} now;

static void on_fault(int signal_number)
{
    printf("FAIL: %s %s: STAD_SEED=%u size %d round %u: %s: read or wrote outside its buffers (signal %d)\n", set->name, now.name,
           now.seed, now.k->size, now.round, now.k->text, signal_number);
    fflush(stdout);
    _Exit(1);
}

static void run_case(const char *name, any_case *run, int32_t size, uint32_t seed, uint32_t round)
{
    kernel_case k = {set, size, {0, FILL_EVEN}, ""};
    char message[400];
    int same, intact;
    k.chance.state = (seed * 2654435761u ^ (uint32_t)size * 40503u ^ round * 2246822519u) | 1u;
    k.chance.fill = (enum fill)(round % FILL_COUNT);
    for (int i = 0; i < 4; i++)
        chance_draw(&k.chance);
    now.k = &k;
    now.name = name;
    now.seed = seed;
    now.round = round;
    same = run(&k);
    intact = rooms_intact();
    snprintf(message, sizeof message, "%s %s %s: STAD_SEED=%u size %d round %u: %s %s", set->name, name,
             same ? "writes outside" : "differs from C", seed, size, round, k.text, intact ? "" : room_last_fault());
    rooms_release();
    TEST_ASSERT_TRUE_MESSAGE(same && intact, message);
}

/* Sizes that are multiples of `unit` from there to `last`, then the larger ones of a list that ends with 0. */
static void sweep(const char *name, any_case *run, int is_c, int32_t unit, int32_t last, const int32_t *larger)
{
    const uint32_t seed = from_environment("STAD_SEED", 1), rounds = from_environment("STAD_ROUNDS", 24);
    if (is_c)
        TEST_IGNORE_MESSAGE("left to C");
    for (int32_t size = unit; size <= last; size += unit)
        for (uint32_t round = 0; round < rounds; round++)
            run_case(name, run, size, seed, round);
    for (; *larger; larger++)
        for (uint32_t round = 0; *larger % unit == 0 && round < rounds; round++)
            run_case(name, run, *larger, seed, round);
}

static const int32_t wide_rows[] = {255, 256, 257, 640, 1281, 0};
static const int32_t many_disparities[] = {120, 128, 136, 208, 224, 240, 248, 256, 264, 272, 288, 480, 512, 544, 0};

#define ROW_TEST(kernel, reference)                                                               \
    static void test_kernel_##kernel##_equals_c(void)                                             \
    {                                                                                             \
        sweep(#kernel, case_##kernel, (any)set->kernel == (any)(reference), 1, REACH, wide_rows); \
    }
#define DISPARITY_TEST(kernel, reference)                                                                             \
    static void test_kernel_##kernel##_equals_c(void)                                                                 \
    {                                                                                                                 \
        sweep(#kernel, case_##kernel, (any)set->kernel == (any)(reference), set->lanes, REACH / 2, many_disparities); \
    }
/* Costs are made in bytes: three vectors are twice as many disparities, and every multiple of 8 is allowed on all tiers. */
#define COST_TEST(kernel, reference)                                                                     \
    static void test_kernel_##kernel##_equals_c(void)                                                    \
    {                                                                                                    \
        sweep(#kernel, case_##kernel, (any)set->kernel == (any)(reference), 8, REACH, many_disparities); \
    }

ROW_TEST(prefilter, plain.prefilter)
ROW_TEST(range, plain.range)
ROW_TEST(box_add_u8, plain.box_add_u8)
ROW_TEST(box_add_u16, plain.box_add_u16)
DISPARITY_TEST(block, plain.block)
ROW_TEST(median, plain.median)
ROW_TEST(select, plain.select)
ROW_TEST(check, plain.check)
COST_TEST(cost_u8, plain.cost_u8)
COST_TEST(cost_u16, plain.cost_u16)
DISPARITY_TEST(slide, plain.slide)
DISPARITY_TEST(path, plain.path)
DISPARITY_TEST(path_sat, plain.path_sat)
DISPARITY_TEST(path_u8, plain.path_u8)
DISPARITY_TEST(gather, plain.gather)
DISPARITY_TEST(best, plain.best)
DISPARITY_TEST(best_3way, plain.best_3way)
DISPARITY_TEST(last, plain.last)
DISPARITY_TEST(refine, plain.refine)

static void run_all(void)
{
    RUN_TEST(test_kernel_prefilter_equals_c);
    RUN_TEST(test_kernel_range_equals_c);
    RUN_TEST(test_kernel_cost_u8_equals_c);
    RUN_TEST(test_kernel_cost_u16_equals_c);
    RUN_TEST(test_kernel_box_add_u8_equals_c);
    RUN_TEST(test_kernel_box_add_u16_equals_c);
    RUN_TEST(test_kernel_block_equals_c);
    RUN_TEST(test_kernel_slide_equals_c);
    RUN_TEST(test_kernel_path_equals_c);
    RUN_TEST(test_kernel_gather_equals_c);
    RUN_TEST(test_kernel_best_equals_c);
    RUN_TEST(test_kernel_best_3way_equals_c);
    RUN_TEST(test_kernel_last_equals_c);
    RUN_TEST(test_kernel_median_equals_c);
}

/* What only the bound set can have of its own. */
static void run_bound(void)
{
    RUN_TEST(test_kernel_path_sat_equals_c);
    RUN_TEST(test_kernel_path_u8_equals_c);
    RUN_TEST(test_kernel_refine_equals_c);
    RUN_TEST(test_kernel_select_equals_c);
    RUN_TEST(test_kernel_check_equals_c);
}

/* The tier in use, and the one that the environment asks for (the same one where it asks for none). */
static const char *tier_in_use(void)
{
#ifdef STAD_PORT_X86_H
    return stad_x86_tier_name();
#else
    return "c";
#endif
}

static const char *tier_wanted(void)
{
    const char *wanted = getenv("STAD_ISA");
    return wanted && *wanted ? wanted : tier_in_use();
}

static int say_tier(void)
{
    const int same = strcmp(tier_in_use(), tier_wanted()) == 0;
    printf("%s tier %s, in use: %s\n", same ? "available:" : "UNAVAILABLE:", tier_wanted(), tier_in_use());
    return same ? 0 : 77;
}

static void test_kernel_tier_is_available(void)
{
    char message[80];
    snprintf(message, sizeof message, "UNAVAILABLE: this processor has no %s", set->name);
    TEST_IGNORE_MESSAGE(message);
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "tier") == 0)
        return say_tier();
    signal(SIGSEGV, on_fault);
    signal(SIGBUS, on_fault);
    UNITY_BEGIN();
    printf("tier in use: %s\n", tier_in_use());
    for (int i = 0; i < SETS; i++) {
        set = &sets[i];
        printf("-- %s\n", set->name);
        if (has_tier(i))
            run_all();
        else
            RUN_TEST(test_kernel_tier_is_available);
    }
    set = &sets[0];
    run_bound();
    return UNITY_END();
}
