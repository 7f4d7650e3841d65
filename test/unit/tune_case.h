/* SPDX-License-Identifier: MIT
 * unit/tune_case.h - costs that need no images, and a search run to its end with every rule of the interface checked. */
#ifndef STAD_TUNE_CASE_H
#define STAD_TUNE_CASE_H

#include <string.h>

#include "base/log.h"
#include "stad/tune.h"
#include "unity.h"

static const stad_point sample_start = {{72, 288, 3, 10, 63, 1}};

static int64_t square_q16(int64_t d_q16)
{
    return d_q16 * d_q16 / 65536;
}

/* A bowl like those of stereo: curved differently in each variable, P1 and P2 coupled, a best block of 5, ridges of the
 * lattice, and a jagged floor of up to 64 that stands for counting noise. */
static int32_t bowl(const stad_point *x)
{
    const int64_t area = 3 * (int64_t)stad_log2_q16((uint32_t)x->v[2]) / 2;
    const int64_t a = stad_log2_q16((uint32_t)x->v[0]) - area - 3 * 65536 / 2;
    const int64_t b = stad_log2_q16((uint32_t)x->v[1]) - area - 7 * 65536 / 2;
    const int64_t u = ((int64_t)x->v[3] - 21) * 65536 / 8;
    const int64_t c = stad_log2_q16((uint32_t)x->v[4]) - stad_log2_q16(31);
    const int64_t block = (x->v[2] - 5) / 2;
    const int64_t d = stad_log2_q16((uint32_t)x->v[5]) / 65536 - 1;
    const int64_t bends = 3 * square_q16(a) + 2 * square_q16(b) + square_q16(a - b) + square_q16(u) + square_q16(c) / 2;
    uint32_t jag = 2166136261u;
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        jag = (jag ^ (uint16_t)x->v[i]) * 16777619u;
    return (int32_t)(40000 + bends / 20 + 4000 * block * block + 900 * (d < 0 ? -d : d) + (jag >> 26));
}

/* FNV-1a over everything asked and told. */
static inline uint32_t hash_of(const stad_tune *t)
{
    uint32_t h = 2166136261u;
    stad_point x;
    int32_t cost;
    for (int i = 0; stad_tune_trace(t, i, &x, &cost) == STAD_OK; i++) {
        for (int k = 0; k < STAD_TUNE_DIMS; k++)
            h = (h ^ (uint32_t)(uint16_t)x.v[k]) * 16777619u;
        h = (h ^ (uint32_t)cost) * 16777619u;
    }
    return h;
}

typedef int32_t (*cost_function)(const stad_point *x);

static void check_point(const stad_tune *t, const stad_tune_config *c, const stad_point *x)
{
    stad_point old;
    int32_t cost;
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        if (!((c->free_mask >> i) & 1))
            continue;
        TEST_ASSERT_GREATER_OR_EQUAL_INT(c->axis[i].lo, x->v[i]);
        TEST_ASSERT_LESS_OR_EQUAL_INT(c->axis[i].hi, x->v[i]);
        if (c->axis[i].scale == STAD_TUNE_LOG2 || c->axis[i].scale == STAD_TUNE_AREA)
            TEST_ASSERT_EQUAL_INT(0, (x->v[i] - c->axis[i].lo) % c->axis[i].unit);
    }
    for (int i = 0; stad_tune_trace(t, i, &old, &cost) == STAD_OK; i++)
        TEST_ASSERT_TRUE_MESSAGE(memcmp(&old, x, sizeof old) != 0, "a point was asked for twice");
}

/* Runs a search to its end. Returns the number of distinct evaluations. */
static int run_search(stad_tune *t, const stad_tune_config *c, const stad_point *start, cost_function cost)
{
    stad_point x, again;
    int n = 0;
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_init(t, c, start));
    while (stad_tune_ask(t, &x) == 1) {
        TEST_ASSERT_EQUAL_INT(1, stad_tune_ask(t, &again));
        TEST_ASSERT_EQUAL_MEMORY(&x, &again, sizeof x);
        check_point(t, c, &x);
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_tune_tell(t, cost(&x)));
        TEST_ASSERT_LESS_OR_EQUAL_INT_MESSAGE(c->budget, ++n, "more evaluations than the budget");
    }
    TEST_ASSERT_EQUAL_INT(n, stad_tune_counts_of(t).evaluations);
    TEST_ASSERT_EQUAL_INT(STAD_E_STATE, stad_tune_tell(t, 1));
    return n;
}

#endif
