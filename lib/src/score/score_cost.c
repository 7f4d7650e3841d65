/* SPDX-License-Identifier: MIT
 * counts -> [COST] -> tune         score/score_cost.c - one Q20 number from the exact counts. */
#include "stad/score.h"

#include "base/arith.h"
#include "base/divide.h"
#include "base/log.h"

/* part / whole in Q20, rounded. Both shed bits beyond what Q20 leaves room for: sums over millions of pixels. */
static int32_t ratio_q20(int64_t part, int64_t whole)
{
    if (whole <= 0)
        return STAD_COST_FAILED;
    part = part < 0 ? 0 : part; /* of no counts that rows can make */
    while (part >= (int64_t)1 << 42 && whole > 1) {
        part /= 2;
        whole /= 2;
    }
    if (part >= (int64_t)1 << 42)
        return STAD_COST_FAILED - 1;
    const int64_t q = stad_div_i64(part * STAD_COST_ONE + whole / 2, whole);
    return q < STAD_COST_FAILED ? (int32_t)q : STAD_COST_FAILED - 1;
}

static int32_t with_disparity(const stad_score_counts *n)
{
    return n->visible - n->missing_visible;
}

int32_t stad_score_rmse_q16(const stad_score *s)
{
    const int32_t n = with_disparity(&s->counts);
    if (n <= 0)
        return 0;
    const int64_t mean_q16 = stad_div_i64(s->counts.square_sum_q16 + n / 2, n);
    return sat_i32(stad_isqrt((uint64_t)mean_q16 << 16)); /* mean_q16 <= 2^42: errors are below 2^21 / 256 px */
}

int32_t stad_score_mae_q16(const stad_score *s)
{
    const int32_t n = with_disparity(&s->counts);
    return n <= 0 ? 0 : sat_i32(stad_div_i64(s->counts.abs_sum_q16 + n / 2, n));
}

/* An error in px * 65536 against the disparity range, at most 1. No disparity at all is as bad as can be. */
static int32_t against_range(const stad_score *s, int32_t error_q16)
{
    if (s->counts.visible <= 0)
        return STAD_COST_FAILED;
    if (with_disparity(&s->counts) <= 0)
        return STAD_COST_ONE;
    const int32_t q20 = ratio_q20(error_q16, (int64_t)s->config.num_disparities * 65536);
    return q20 < STAD_COST_ONE ? q20 : STAD_COST_ONE;
}

/* Entropy in bits of the disparity histogram, over the 5 bits of a flat one. */
static int32_t entropy(const stad_score *s)
{
    const int64_t n = s->counts.matched;
    int64_t bits_q16 = 0;
    if (s->counts.considered <= 0)
        return STAD_COST_FAILED;
    if (n <= 0)
        return 0;
    for (int i = 0; i < 32; i++) {
        const int32_t k = s->histogram[i];
        if (k > 0)
            bits_q16 += (int64_t)k * (stad_log2_q16((uint32_t)n) - stad_log2_q16((uint32_t)k));
    }
    return ratio_q20(bits_q16, 5 * n * 65536);
}

static int32_t photo(const stad_score *s)
{
    return ratio_q20(s->counts.photo_sum, (int64_t)s->counts.considered * 80 * s->config.photo_limit);
}

static int32_t blind(const stad_score *s)
{
    const stad_score_counts *n = &s->counts;
    const int32_t gaps = ratio_q20(n->considered - n->matched + 2 * (int64_t)n->speckle, n->considered);
    const int32_t rest = photo(s);        /* at most 3 + 1, unless the caller counted speckles twice */
    return sat_i32((int64_t)gaps + rest); /* STAD_COST_FAILED is the largest int32_t */
}

int32_t stad_score_cost_of(const stad_score *s, int cost)
{
    const stad_score_counts *n = &s->counts;
    switch (cost) {
    case STAD_SCORE_BAD:
        return ratio_q20((int64_t)n->wrong_visible + n->missing_visible, n->visible);
    case STAD_SCORE_CHOW:
        return ratio_q20(2 * ((int64_t)n->wrong_visible + n->wrong_occluded) + n->missing_visible,
                         2 * ((int64_t)n->visible + n->occluded));
    case STAD_SCORE_D1:
        return ratio_q20((int64_t)n->d1_visible + n->missing_visible, n->visible);
    case STAD_SCORE_RMSE:
        return against_range(s, stad_score_rmse_q16(s));
    case STAD_SCORE_MAE:
        return against_range(s, stad_score_mae_q16(s));
    case STAD_SCORE_MISSING:
        return ratio_q20(n->missing_visible, n->visible);
    case STAD_SCORE_BLIND:
        return blind(s);
    case STAD_SCORE_PHOTO:
        return photo(s);
    case STAD_SCORE_SPECKLE:
        return ratio_q20(n->speckle, n->considered);
    case STAD_SCORE_LR:
        return ratio_q20(n->inconsistent, n->considered);
    case STAD_SCORE_ENTROPY:
        return entropy(s);
    default:
        return STAD_COST_FAILED;
    }
}

static int32_t weighted(const stad_score *s)
{
    int64_t sum_q28 = 0;
    for (int i = 0; i < STAD_SCORE_TERMS; i++) {
        const int32_t weight = s->config.weight_q8[i];
        if (weight == 0)
            continue;
        const int32_t term = stad_score_cost_of(s, i);
        if (term == STAD_COST_FAILED)
            return STAD_COST_FAILED;
        sum_q28 += (int64_t)weight * term;
    }
    const int64_t q20 = (sum_q28 + 128) >> 8;
    return q20 < STAD_COST_FAILED ? (int32_t)q20 : STAD_COST_FAILED - 1;
}

int32_t stad_score_end(const stad_score *s)
{
    return s->config.cost == STAD_SCORE_WEIGHTED ? weighted(s) : stad_score_cost_of(s, s->config.cost);
}
