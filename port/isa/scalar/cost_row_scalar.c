/* SPDX-License-Identifier: MIT
 * range -> [COST] -> box
 * port/isa/scalar/cost_row_scalar.c - pixel costs without a branch, a plane at a time, for cores without SIMD.
 *
 * low <= value <= high, so of max(0, u - high) and max(0, low - u) one is zero: their maximum is their OR. */
#include <stddef.h>

#include "kernel/kernel.h"
#include "word.h"

/* A left sample and its range; the right row's three runs from disparity 0 on. */
typedef struct plane_pair {
    int32_t value, low, high;
    const uint8_t *right_value, *right_low, *right_high;
} plane_pair;

WORD_INLINE plane_pair pair_at(const stad_cost_job *job, int32_t plane, int32_t x)
{
    const ptrdiff_t width = job->width;
    const uint8_t *left = job->left + plane * 3 * width + x;
    const uint8_t *right = job->right + plane * 3 * width + (width - 1 - x + job->min_disparity);
    plane_pair p = {left[0], left[width], left[2 * width], right, right + width, right + 2 * width};
    return p;
}

WORD_INLINE int32_t distance(const plane_pair *p, int32_t d)
{
    const int32_t value = p->right_value[d];
    const int32_t to_right = floor_i32(p->value - p->right_high[d]) | floor_i32(p->right_low[d] - p->value);
    const int32_t to_left = floor_i32(value - p->high) | floor_i32(p->low - value);
    return least_i32(to_right, to_left);
}

static void put_gradient(const plane_pair *pair, uint8_t *cost, int32_t n)
{
    const plane_pair p = *pair;
    for (int32_t d = 0; d < n; d++)
        cost[d] = (uint8_t)distance(&p, d);
}

static void add_intensity(const plane_pair *pair, uint8_t *cost, int32_t n)
{
    const plane_pair p = *pair;
    for (int32_t d = 0; d < n; d++)
        cost[d] = (uint8_t)(cost[d] + (distance(&p, d) >> 2));
}

void stad_cost_row_u8_scalar(const stad_cost_job *job, uint8_t *cost)
{
    if (job->channels != 1) {
        stad_cost_row_u8_c(job, cost);
        return;
    }
    for (int32_t i = 0; i < job->count; i++, cost += job->disparities) {
        const plane_pair gradient = pair_at(job, 0, job->x + i), intensity = pair_at(job, 1, job->x + i);
        put_gradient(&gradient, cost, job->disparities);
        add_intensity(&intensity, cost, job->disparities);
    }
}
