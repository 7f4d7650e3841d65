/* SPDX-License-Identifier: MIT
 * port/isa/x86/dispatch.c - chooses the widest tier that the CPU has, the environment allows and the size fits.
 *
 * The one file of the library's builds that reads the environment and keeps a static: the tier, found once and never
 * changed (two threads may both find it; they find the same). It is not part of a build for a microcontroller. */
#include <stdlib.h>
#include <string.h>

#include "kernel/last_row.h"

enum tier { TIER_C, TIER_SSE41, TIER_AVX2, TIER_AVX512, TIER_COUNT };

static const char *const tier_names[TIER_COUNT] = {"c", "sse41", "avx2", "avx512"};

static int find_tier(void)
{
    const char *mask = getenv("STAD_ISA");
    int tier = TIER_C;
    if (__builtin_cpu_supports("sse4.1"))
        tier = TIER_SSE41;
    if (__builtin_cpu_supports("avx2"))
        tier = TIER_AVX2;
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw"))
        tier = TIER_AVX512;
    for (int i = 0; mask && i < tier; i++)
        if (strcmp(mask, tier_names[i]) == 0)
            tier = i;
    return tier;
}

int stad_x86_tier(void)
{
    static int found = -1;
    int tier = __atomic_load_n(&found, __ATOMIC_RELAXED);
    if (tier < 0) {
        tier = find_tier();
        __atomic_store_n(&found, tier, __ATOMIC_RELAXED);
    }
    return tier;
}

const char *stad_x86_tier_name(void)
{
    return tier_names[stad_x86_tier()];
}

/* The widest tier whose 16-bit lanes divide n at least twice: a column of one vector alone waits for itself on the
 * horizontal path. 8 lanes always divide n (kernel.h). */
static int tier_for(int32_t n)
{
    const int fitting = n % 32 == 0 && n >= 64 ? TIER_AVX512 : n % 16 == 0 && n >= 32 ? TIER_AVX2 : TIER_SSE41;
    const int tier = stad_x86_tier();
    return tier < fitting ? tier : fitting;
}

/* Pixel costs are made in bytes: the widest tier one vector of which is filled. */
static int tier_for_bytes(int32_t n)
{
    const int tier = stad_x86_tier(), fitting = n >= 64 ? TIER_AVX512 : n >= 32 ? TIER_AVX2 : TIER_SSE41;
    return tier < fitting ? tier : fitting;
}

#define STAD_DISPATCH(tier, kernel, arguments) \
    do {                                       \
        if ((tier) == TIER_AVX512)             \
            kernel##_avx512 arguments;         \
        else if ((tier) == TIER_AVX2)          \
            kernel##_avx2 arguments;           \
        else if ((tier) == TIER_SSE41)         \
            kernel##_sse41 arguments;          \
        else                                   \
            kernel##_c arguments;              \
    } while (0)

void stad_prefilter_row_x86(const uint8_t *above, const uint8_t *row, const uint8_t *below, int32_t width, int32_t channels,
                            int32_t cap, uint8_t *planes)
{
    STAD_DISPATCH(stad_x86_tier(), stad_prefilter_row, (above, row, below, width, channels, cap, planes));
}

void stad_range_row_x86(const uint8_t *plane, int32_t width, int reverse, uint8_t *out)
{
    STAD_DISPATCH(stad_x86_tier(), stad_range_row, (plane, width, reverse, out));
}

void stad_cost_row_u8_x86(const stad_cost_job *job, uint8_t *cost)
{
    STAD_DISPATCH(tier_for_bytes(job->disparities), stad_cost_row_u8, (job, cost));
}

void stad_cost_row_u16_x86(const stad_cost_job *job, uint16_t *cost)
{
    STAD_DISPATCH(tier_for_bytes(job->disparities), stad_cost_row_u16, (job, cost));
}

void stad_box_add_row_u8_x86(int16_t *sum, const uint8_t *cost, int32_t n, int32_t weight)
{
    STAD_DISPATCH(stad_x86_tier(), stad_box_add_row_u8, (sum, cost, n, weight));
}

void stad_box_add_row_u16_x86(int16_t *sum, const uint16_t *cost, int32_t n, int32_t weight)
{
    STAD_DISPATCH(stad_x86_tier(), stad_box_add_row_u16, (sum, cost, n, weight));
}

void stad_block_row_x86(const stad_block_job *job, int16_t *block)
{
    STAD_DISPATCH(tier_for(job->disparities), stad_block_row, (job, block));
}

void stad_slide_row_x86(const stad_slide_job *job, int16_t *block)
{
    STAD_DISPATCH(tier_for(job->disparities), stad_slide_row, (job, block));
}

void stad_path_row_x86(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
{
    STAD_DISPATCH(tier_for(job->disparities), stad_path_row, (job, lanes, lane_count));
}

void stad_gather_row_x86(int16_t *total, const stad_lane *lane, int32_t slot, const stad_path_job *job)
{
    STAD_DISPATCH(tier_for(job->disparities), stad_gather_row, (total, lane, slot, job));
}

void stad_best_row_x86(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    STAD_DISPATCH(tier_for(disparities), stad_best_row, (total, count, disparities, best));
}

void stad_best_row_3way_x86(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    STAD_DISPATCH(tier_for(disparities), stad_best_row_3way, (total, count, disparities, best));
}

void stad_last_row_x86(const stad_path_job *job, stad_lane *lane, int three_way, stad_best *best)
{
    STAD_DISPATCH(tier_for(job->disparities), stad_last_row, (job, lane, three_way, best));
}

void stad_refine_row_x86(const int16_t *total, const stad_best *best, int32_t count, int32_t disparities, int16_t *fine)
{
    if (stad_x86_tier() == TIER_C)
        stad_refine_row_c(total, best, count, disparities, fine);
    else
        stad_refine_row_sse41(total, best, count, disparities, fine);
}

void stad_select_row_x86(stad_select_job *job)
{
    if (stad_x86_tier() == TIER_C)
        stad_select_row_c(job);
    else
        stad_select_row_sse41(job);
}

int32_t stad_check_row_x86(const stad_check_job *job)
{
    return stad_x86_tier() == TIER_C ? stad_check_row_c(job) : stad_check_row_sse41(job);
}

void stad_median_row_x86(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out)
{
    STAD_DISPATCH(stad_x86_tier(), stad_median_row, (above, row, below, width, out));
}
