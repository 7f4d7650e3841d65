/* SPDX-License-Identifier: MIT
 * range -> [COST] -> box
 * port/isa/arm_dsp/cost_row_dsp.c - pixel costs, four disparities an instruction, a plane at a time.
 *
 * low <= value <= high, so of max(0, u - high) and max(0, low - u) one is zero: their maximum is their OR. Columns of the
 * cost row are aligned to a word, as D is a multiple of 8 and the row is. */
#include <stddef.h>

#include "kernel/kernel.h"
#include "pair_dsp.h"

/* A left sample and its range in all four bytes; the right row's three runs from disparity 0 on. */
typedef struct plane_pair {
    pair value, low, high;
    const uint8_t *right;
    ptrdiff_t width;
} plane_pair;

PAIR_INLINE plane_pair pair_at(const stad_cost_job *job, int32_t plane, int32_t x)
{
    const ptrdiff_t width = job->width;
    const uint8_t *left = job->left + plane * 3 * width + x;
    plane_pair p = {bytes_set(left[0]), bytes_set(left[width]), bytes_set(left[2 * width]),
                    job->right + plane * 3 * width + (width - 1 - x + job->min_disparity), width};
    return p;
}

PAIR_INLINE pair distance(const plane_pair *p, const uint8_t *right)
{
    const pair value = pair_load(right), low = pair_load(right + p->width), high = pair_load(right + 2 * p->width);
    const pair to_right = __uqsub8(p->value, high) | __uqsub8(low, p->value);
    const pair to_left = __uqsub8(value, p->high) | __uqsub8(p->low, value);
    return bytes_min(to_right, to_left);
}

static void put_gradient(const plane_pair *p, uint8_t *cost, int32_t n)
{
    const uint8_t *right = p->right, *end = right + n;
    const plane_pair here = *p;
    for (; right != end; right += 8, cost += 8) {
        const pair low = distance(&here, right);
        quad_store(cost, low, distance(&here, right + 4));
    }
}

PAIR_INLINE pair quarter(pair v)
{
    return (v & 0xFCFCFCFCu) >> 2;
}

static void add_intensity(const plane_pair *p, uint8_t *cost, int32_t n)
{
    const uint8_t *right = p->right, *end = right + n;
    const plane_pair here = *p;
    for (; right != end; right += 8, cost += 8) {
        const quad sum = quad_load(cost);
        const pair low = __uadd8(sum.low, quarter(distance(&here, right)));
        quad_store(cost, low, __uadd8(sum.high, quarter(distance(&here, right + 4))));
    }
}

void stad_cost_row_u8_dsp(const stad_cost_job *job, uint8_t *cost)
{
    if (job->channels != 1 || ((uintptr_t)cost & 3) != 0) {
        stad_cost_row_u8_c(job, cost);
        return;
    }
    for (int32_t i = 0; i < job->count; i++, cost += job->disparities) {
        const plane_pair gradient = pair_at(job, 0, job->x + i), intensity = pair_at(job, 1, job->x + i);
        put_gradient(&gradient, cost, job->disparities);
        add_intensity(&intensity, cost, job->disparities);
    }
}
