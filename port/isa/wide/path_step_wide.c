/* SPDX-License-Identifier: MIT
 * port/isa/wide/path_step_wide.c - the recurrence of kernel/path_row.c with one saturating difference, said as a maximum:
 *     L = C - floor(delta - reach),   reach = min(p[d], p[d-1] + p1, p[d+1] + p1),   floor(v) = max(v, 0)
 * Bounds: cells are at most 32767 and so is p1, so every sum below fits 16 unsigned bits. */
#include "kernel/kernel.h"
#include "path_step_wide.h"
#include "wide.h"

/* L at p[0], between p[-1] and p[1]. */
static inline uint16_t path_cost(const uint16_t *p, uint16_t block, uint16_t delta, uint16_t p1)
{
    const uint16_t reach = min_u16((uint16_t)(min_u16(p[-1], p[1]) + p1), p[0]);
    return (uint16_t)(block - (uint16_t)(max_u16(delta, reach) - reach));
}

static inline uint16_t sum(uint16_t a, uint16_t b)
{
    return min_u16((uint16_t)(a + b), STAD_COST_MAX);
}

uint16_t stad_path_one_wide(wide_pixel *restrict pixel, uint16_t delta)
{
    const wide_pixel p = *pixel;
    const int32_t n = whole_16(p.disparities);
    uint16_t least = STAD_COST_MAX;
    for (int32_t d = 0; d < n; d++) {
        const uint16_t a = path_cost(p.a.from + d, p.block[d], delta, p.p1);
        p.a.to[d] = a;
        least = min_u16(least, a);
        p.total[d] = sum(p.total[d], a);
    }
    return least;
}

uint16_t stad_path_two_wide(wide_pixel *restrict pixel, uint16_t delta)
{
    const wide_pixel p = *pixel;
    const int32_t n = whole_16(p.disparities);
    uint16_t least_a = STAD_COST_MAX, least_b = STAD_COST_MAX;
    for (int32_t d = 0; d < n; d++) {
        const uint16_t a = path_cost(p.a.from + d, p.block[d], delta, p.p1);
        const uint16_t b = path_cost(p.b.from + d, p.block[d], p.b.delta, p.p1);
        p.a.to[d] = a;
        p.b.to[d] = b;
        least_a = min_u16(least_a, a);
        least_b = min_u16(least_b, b);
        p.total[d] = sum(p.total[d], sum(a, b));
    }
    pixel->b.least = least_b;
    return least_a;
}

uint16_t stad_path_four_wide(wide_pixel *restrict pixel, uint16_t delta)
{
    const wide_pixel p = *pixel;
    const int32_t n = whole_16(p.disparities);
    uint16_t least_a = STAD_COST_MAX, least_b = STAD_COST_MAX, least_c = STAD_COST_MAX, least_d = STAD_COST_MAX;
    for (int32_t i = 0; i < n; i++) {
        const uint16_t a = path_cost(p.a.from + i, p.block[i], delta, p.p1);
        const uint16_t b = path_cost(p.b.from + i, p.block[i], p.b.delta, p.p1);
        const uint16_t c = path_cost(p.c.from + i, p.block[i], p.c.delta, p.p1);
        const uint16_t d = path_cost(p.d.from + i, p.block[i], p.d.delta, p.p1);
        p.a.to[i] = a;
        p.b.to[i] = b;
        p.c.to[i] = c;
        p.d.to[i] = d;
        least_a = min_u16(least_a, a);
        least_b = min_u16(least_b, b);
        least_c = min_u16(least_c, c);
        least_d = min_u16(least_d, d);
        p.total[i] = sum(p.total[i], sum(sum(a, b), sum(c, d)));
    }
    pixel->b.least = least_b;
    pixel->c.least = least_c;
    pixel->d.least = least_d;
    return least_a;
}
