/* SPDX-License-Identifier: MIT
 * range -> [COST] -> box
 * kernel/cost_row.c - Birchfield-Tomasi cost of a run of columns, all disparities of a column at once.
 *
 * Bound: a plane gives at most 255, an intensity plane 255 >> 2 = 63; the u8 form is called only where the sum over all
 * planes stays within 255 (SPEC 3), so the additions below never wrap. */
#include "kernel/kernel.h"
#include "base/arith.h"

/* One plane of the left pixel, and the right row from the column that disparity 0 of the run meets. */
typedef struct plane_pair {
    uint8_t value, low, high;
    const uint8_t *right_value, *right_low, *right_high;
} plane_pair;

static inline plane_pair pair_at(const stad_cost_job *job, int32_t plane, int32_t x)
{
    const ptrdiff_t width = job->width;
    const uint8_t *left = job->left + plane * 3 * width + x;
    const uint8_t *right = job->right + plane * 3 * width + (width - 1 - x + job->min_disparity);
    plane_pair pair = {left[0], left[width], left[2 * width], right, right + width, right + 2 * width};
    return pair;
}

/* min over both directions of the distance between a sample and the other's half-sample range. */
static inline uint8_t distance(const plane_pair *p, int32_t d)
{
    const uint8_t to_right = max_u8(sub_floor_u8(p->value, p->right_high[d]), sub_floor_u8(p->right_low[d], p->value));
    const uint8_t to_left = max_u8(sub_floor_u8(p->right_value[d], p->high), sub_floor_u8(p->low, p->right_value[d]));
    return min_u8(to_right, to_left);
}

static inline void column_u8(const stad_cost_job *job, int32_t x, int32_t channel, int add, uint8_t *restrict cost)
{
    const plane_pair gradient = pair_at(job, channel, x), intensity = pair_at(job, job->channels + channel, x);
    const int32_t n = whole_8(job->disparities);
    for (int32_t d = 0; d < n; d++) {
        const uint8_t here = (uint8_t)(distance(&gradient, d) + (distance(&intensity, d) >> 2));
        cost[d] = (uint8_t)(add ? cost[d] + here : here);
    }
}

static inline void column_u16(const stad_cost_job *job, int32_t x, int32_t channel, int add, uint16_t *restrict cost)
{
    const plane_pair gradient = pair_at(job, channel, x), intensity = pair_at(job, job->channels + channel, x);
    const int32_t n = whole_8(job->disparities);
    for (int32_t d = 0; d < n; d++) {
        const uint16_t here = (uint16_t)(distance(&gradient, d) + (distance(&intensity, d) >> 2));
        cost[d] = (uint16_t)(add ? cost[d] + here : here);
    }
}

void stad_cost_row_u8_c(const stad_cost_job *job, uint8_t *cost)
{
    STAD_ASSERT(job->disparities % 8 == 0 && job->x >= 0 && job->x + job->count <= job->width);
    for (int32_t i = 0; i < job->count; i++, cost += job->disparities) {
        column_u8(job, job->x + i, 0, 0, cost);
        for (int32_t c = 1; c < job->channels; c++)
            column_u8(job, job->x + i, c, 1, cost);
    }
}

void stad_cost_row_u16_c(const stad_cost_job *job, uint16_t *cost)
{
    STAD_ASSERT(job->disparities % 8 == 0 && job->x >= 0 && job->x + job->count <= job->width);
    for (int32_t i = 0; i < job->count; i++, cost += job->disparities) {
        column_u16(job, job->x + i, 0, 0, cost);
        for (int32_t c = 1; c < job->channels; c++)
            column_u16(job, job->x + i, c, 1, cost);
    }
}
