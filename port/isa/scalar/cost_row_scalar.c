/* SPDX-License-Identifier: MIT
 * range -> [COST] -> box
 * port/isa/scalar/cost_row_scalar.c - pixel costs for cores without SIMD: most cells are settled by one comparison.
 *
 * With u, ulow, uhigh the left sample and its range and v, low, high the right one's: where v > uhigh, u <= uhigh < v <= high, so
 * only low can be on the far side of u, and the cost is floor(min(v - uhigh, low - u)); where v < ulow likewise
 * floor(min(ulow - v, u - high)); between them it is 0. */
#include <stddef.h>

#include "kernel/kernel.h"
#include "word.h"

/* A left sample and its range; the right row's values from disparity 0 on, its lows and highs a width further each. */
typedef struct plane_pair {
    int32_t value, low, high;
    const uint8_t *right;
} plane_pair;

WORD_INLINE plane_pair pair_at(const stad_cost_job *job, int32_t plane, int32_t x)
{
    const ptrdiff_t width = job->width;
    const uint8_t *left = job->left + plane * 3 * width + x;
    plane_pair p = {left[0], left[width], left[2 * width], job->right + plane * 3 * width + (width - 1 - x + job->min_disparity)};
    return p;
}

/* floor(min(a, b)) where a > 0. */
WORD_INLINE int32_t lesser(int32_t a, int32_t b)
{
    if (b <= 0)
        return 0;
    return a < b ? a : b;
}

WORD_INLINE int32_t distance(const plane_pair *p, const uint8_t *right, ptrdiff_t width)
{
    const int32_t value = right[0];
    if (value > p->high)
        return lesser(value - p->high, right[width] - p->value);
    if (value < p->low)
        return lesser(p->low - value, p->value - right[2 * width]);
    return 0;
}

static void put_gradient(const plane_pair *pair, ptrdiff_t width, uint8_t *cost, int32_t n)
{
    const plane_pair p = *pair;
    const uint8_t *right = p.right;
    for (const uint8_t *end = cost + n; cost != end; cost += 4, right += 4) {
        cost[0] = (uint8_t)distance(&p, right, width);
        cost[1] = (uint8_t)distance(&p, right + 1, width);
        cost[2] = (uint8_t)distance(&p, right + 2, width);
        cost[3] = (uint8_t)distance(&p, right + 3, width);
    }
}

static void add_intensity(const plane_pair *pair, ptrdiff_t width, uint8_t *cost, int32_t n)
{
    const plane_pair p = *pair;
    const uint8_t *right = p.right;
    for (const uint8_t *end = cost + n; cost != end; cost += 4, right += 4) {
        cost[0] = (uint8_t)(cost[0] + (distance(&p, right, width) >> 2));
        cost[1] = (uint8_t)(cost[1] + (distance(&p, right + 1, width) >> 2));
        cost[2] = (uint8_t)(cost[2] + (distance(&p, right + 2, width) >> 2));
        cost[3] = (uint8_t)(cost[3] + (distance(&p, right + 3, width) >> 2));
    }
}

void stad_cost_row_u8_scalar(const stad_cost_job *job, uint8_t *cost)
{
    if (job->channels != 1) {
        stad_cost_row_u8_c(job, cost);
        return;
    }
    for (int32_t i = 0; i < job->count; i++, cost += job->disparities) {
        const plane_pair gradient = pair_at(job, 0, job->x + i), intensity = pair_at(job, 1, job->x + i);
        put_gradient(&gradient, job->width, cost, job->disparities);
        add_intensity(&intensity, job->width, cost, job->disparities);
    }
}
