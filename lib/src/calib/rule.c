/* SPDX-License-Identifier: MIT
 * cost -> [RULE] -> adopt or keep        calib/rule.c - when a lower cost is believed
 *
 * The target is one small, odd part of what the camera will see. Two brakes keep it from leading far astray: while
 * tuning, a cost grows with the distance from the start; and what comes out must be better on a frame of another pose
 * by more than chance. */
#include "base/log.h"
#include "calib/calib_parts.h"

/* Octaves between two values of a coordinate, Q16: at most 2^21 either way. */
static int32_t octaves(const stad_point *a, const stad_point *b, int i)
{
    return stad_log2_q16((uint32_t)a->v[i]) - stad_log2_q16((uint32_t)b->v[i]);
}

static int64_t square(int32_t x)
{
    return (int64_t)x * x;
}

/* Squared distance in the tuner's own steps: octaves of P1 and P2 over the block's area, octaves of the cap, eights
 * of uniqueness. Each term of points that can be matched is at most (32 * 2^16)^2 = 2^42. */
static int64_t squared_steps_q32(const stad_point *a, const stad_point *b)
{
    int32_t block = 2 * octaves(a, b, STAD_TUNE_BLOCK_SIZE);
    int32_t margin = (a->v[STAD_TUNE_UNIQUENESS_RATIO] - b->v[STAD_TUNE_UNIQUENESS_RATIO]) * (65536 / 8);
    return square(octaves(a, b, STAD_TUNE_P1) - block) + square(octaves(a, b, STAD_TUNE_P2) - block) +
           square(octaves(a, b, STAD_TUNE_PRE_FILTER_CAP)) + square(margin);
}

/* (cost + 1 point) (1 + by) - 1 point: `by` 0 leaves the cost as it is, and a cost of nothing is raised too. */
int32_t stad_calib_raised(int32_t cost_q20, int64_t by_q16)
{
    const int64_t point = STAD_COST_ONE / 100;
    if (cost_q20 == STAD_COST_FAILED)
        return STAD_COST_FAILED;
    int64_t cost = cost_q20 + (cost_q20 + point) * by_q16 / 65536; /* < 2^31 * 2^28 before the division */
    return cost < STAD_COST_FAILED ? (int32_t)cost : STAD_COST_FAILED - 1;
}

int32_t stad_calib_penalised(const stad_point *start, const stad_point *x, int32_t cost_q20, int32_t lambda_q16)
{
    int64_t square_q16 = squared_steps_q32(start, x) / 65536;            /* < 2^28 */
    return stad_calib_raised(cost_q20, square_q16 * lambda_q16 / 65536); /* lambda <= 1 */
}

/* max(least, 3 sqrt(p (1 - p) / n)), n = pixels / 100: neighbouring pixels fail together, so a hundred count as one. */
int32_t stad_calib_margin(int32_t cost_q20, int32_t pixels, int32_t least_q20)
{
    int64_t p = cost_q20 < STAD_COST_ONE ? cost_q20 : STAD_COST_ONE;
    int64_t n = pixels > 0 ? pixels : 1;
    int64_t variance_q40 = p * (STAD_COST_ONE - p) * 100 / n; /* < 2^38 * 100 */
    int64_t margin = 3 * (int64_t)stad_isqrt((uint64_t)variance_q40);
    if (margin < least_q20)
        return least_q20;
    return margin < STAD_COST_ONE ? (int32_t)margin : STAD_COST_ONE;
}

int stad_calib_is_better(int32_t now_q20, int32_t was_q20, int32_t margin_q20)
{
    return (int64_t)now_q20 + margin_q20 <= was_q20;
}
