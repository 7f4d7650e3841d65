/* SPDX-License-Identifier: MIT
 * slide -> [PATH] -> best
 * port/isa/arm_dsp/path_row_dsp.c - path costs, two disparities an instruction, a lane at a time.
 *
 * With all lanes unsigned and m the previous pixel's least cost, the recurrence of kernel/path_row.c is
 *     L = C - floor(delta - min(p[d], min(p[d-1], p[d+1]) + p1)),   delta = m + p2,   floor(v) = max(v, 0)
 * Bounds: costs, fences and p1 are at most 32767, so no unsigned sum wraps. The pair (p[d+1], p[d+2]) of one step is the pair
 * (p[d-1], p[d]) of the next: each is loaded once. */
#include <stddef.h>

#include "kernel/kernel.h"
#include "pair_dsp.h"

enum total_use { TOTAL_NONE, TOTAL_FRESH, TOTAL_ADD };

/* What a pixel of a lane needs, and its least cost so far. */
typedef struct state {
    pair p1, delta, least, behind;
} state;

PAIR_INLINE pair two(state *s, const int16_t *from, int16_t *to, pair block)
{
    const pair ahead = pair_load(from + 1);
    const pair side = __uadd16(pair_min_u16(s->behind, ahead), s->p1);
    const pair path = __usub16(block, __uqsub16(s->delta, pair_min_u16(pair_load(from), side)));
    s->behind = ahead;
    pair_store(to, path);
    s->least = pair_min_u16(s->least, path);
    return path;
}

/* Four disparities. block and total are aligned to a word, as D is a multiple of 8; lanes may not be. */
PAIR_INLINE void four(state *s, const int16_t *from, int16_t *to, const int16_t *block, int16_t *total, enum total_use use)
{
    const quad cost = quad_load(block);
    const pair low = two(s, from, to, cost.low), high = two(s, from + 2, to + 2, cost.high);
    if (use == TOTAL_ADD) {
        const quad sum = quad_load(total);
        quad_store(total, pair_add_sat_i16(sum.low, low), pair_add_sat_i16(sum.high, high));
    }
    if (use == TOTAL_FRESH)
        quad_store(total, low, high);
}

PAIR_INLINE int32_t pixel(state *s, const int16_t *from, int16_t *to, const int16_t *block, int16_t *total, int32_t n,
                          enum total_use use)
{
    const int16_t *end = from + n;
    s->least = pair_set(STAD_COST_MAX);
    s->behind = pair_load(from - 1);
    do {
        four(s, from, to, block, total, use);
        four(s, from + 4, to + 4, block + 4, total + 4, use);
        from += 8;
        to += 8;
        block += 8;
        if (use != TOTAL_NONE)
            total += 8;
    } while (from != end);
    return pair_low(pair_min_u16(s->least, s->least >> 16));
}

/* One lane over the whole run: lanes do not meet but in S, whose order does not matter here. */
PAIR_INLINE void run_of(const stad_path_job *job, stad_lane *lane, enum total_use use)
{
    const int32_t n = job->disparities, to_next = job->step * n, stride = job->stride, slots = lane->slots;
    const int16_t *block = job->block;
    int16_t *total = job->total, *to = lane->cost + lane->write * stride;
    int32_t slot = lane->write; /* to be written */
    state s = {pair_set(job->p1), 0, 0, 0};
    for (int32_t i = job->count; i > 0; i--, block += to_next) {
        const int wraps = slot + 1 == slots;
        int16_t *from = wraps ? lane->cost : to + stride;
        int16_t *least = lane->least + slot;
        slot = wraps ? 0 : slot + 1;
        s.delta = pair_set(lane->least[slot] + job->p2);
        *least = (int16_t)pixel(&s, from, to, block, total, n, use);
        to = from;
        if (use != TOTAL_NONE)
            total += to_next;
    }
    lane->write = slot;
}

void stad_path_row_dsp(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
{
    for (int32_t k = 0; k < lane_count; k++) {
        if (!job->total)
            run_of(job, &lanes[k], TOTAL_NONE);
        else if (job->fresh && k == 0)
            run_of(job, &lanes[k], TOTAL_FRESH);
        else
            run_of(job, &lanes[k], TOTAL_ADD);
    }
}

void stad_gather_row_dsp(int16_t *total, const stad_lane *lane, int32_t slot, const stad_path_job *job)
{
    const int32_t n = job->disparities;
    for (int32_t i = 0; i < job->count; i++, total += n) {
        const int16_t *path = lane->cost + slot * job->stride;
        for (int32_t d = 0; d < n; d += 4) {
            const quad sum = quad_load(total + d);
            quad_store(total + d, pair_add_sat_i16(sum.low, pair_load(path + d)),
                       pair_add_sat_i16(sum.high, pair_load(path + d + 2)));
        }
        slot = slot + 1 == lane->slots ? 0 : slot + 1;
    }
}
