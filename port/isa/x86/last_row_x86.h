/* SPDX-License-Identifier: MIT
 * port/isa/x86/last_row_x86.h - template: the last path along a row and the winners of its pixels, by turns.
 *
 * The path waits for itself at every pixel, and the winner of the pixel before is found meanwhile. Where a column is a few vectors,
 * whose number the compiler knows, the path's costs stay in registers. */

#include "kernel/last_row.h"

/* One pixel; returns the least S. */
static inline __attribute__((always_inline)) int last_pixel(course *c, const int16_t *block, int16_t *total, stad_lane *lane,
                                                            vec *cost, int vectors)
{
    const vec fence = vec_set(STAD_COST_MAX);
    walker w = walk(c, lane, 1);
    reader r = {fence, cost[0], vec_join(fence, cost[0])};
    vec least = fence;
#pragma GCC unroll 8
    for (int v = 0; v < vectors; v++) {
        const int32_t d = v * VEC_LANES;
        cost[v] = step_shifted(c, &w, &r, d, vec_load(block + d), v + 1 < vectors ? cost[v + 1] : fence);
        const vec sum = vec_add_sat(cost[v], vec_load(total + d));
        vec_store(total + d, sum);
        least = vec_min(least, sum);
    }
    c->across_least = vec_spread_least(w.least);
    *w.least_to = (int16_t)vec_least(w.least);
    return vec_least(least);
}

static inline __attribute__((always_inline)) void last_run(const stad_path_job *job, stad_lane *lane, int vectors, int three_way,
                                                           stad_best *best)
{
    const int16_t *block = job->block, *from = lane->cost + (ptrdiff_t)(1 - lane->write) * job->stride;
    course c = {vec_set(job->p1), vec_set(job->p2), vec_set(lane->least[1 - lane->write]), job->disparities, job->stride};
    int16_t *total = job->total;
    vec cost[8];
#pragma GCC unroll 8
    for (int v = 0; v < vectors; v++)
        cost[v] = vec_load(from + v * VEC_LANES);
    for (int32_t i = 0; i < job->count; i++, block -= job->disparities, total -= job->disparities, best--) {
        const int least = last_pixel(&c, block, total, lane, cost, vectors);
        *best = best_of(total, vectors * VEC_LANES, least, three_way);
    }
}

static inline __attribute__((always_inline)) void last_row(const stad_path_job *job, stad_lane *lane, int three_way,
                                                           stad_best *best)
{
    stad_best *first = best + job->count - 1;
    switch (lane && lane->slots == 2 ? job->disparities / VEC_LANES : 0) {
    case 2:
        last_run(job, lane, 2, three_way, first);
        break;
    case 3:
        last_run(job, lane, 3, three_way, first);
        break;
    case 4:
        last_run(job, lane, 4, three_way, first);
        break;
    case 6:
        last_run(job, lane, 6, three_way, first);
        break;
    case 8:
        last_run(job, lane, 8, three_way, first);
        break;
    default:
        stad_last_row_c(job, lane, three_way, best);
        break;
    }
}

void STAD_TIER(stad_last_row)(const stad_path_job *job, stad_lane *lane, int three_way, stad_best *best)
{
    if (three_way)
        last_row(job, lane, 1, best);
    else
        last_row(job, lane, 0, best);
}
