/* SPDX-License-Identifier: MIT
 * slide -> [PATH] -> best
 * port/isa/scalar/path_row_scalar.c - path costs, sum and least value in one loop, for cores without SIMD.
 *
 * The recurrence of kernel/path_row.c as a gain: with delta = m + p2 and g[d] = delta - p[d],
 *     L = C - max(0, g[d], max(g[d-1], g[d+1]) - p1)
 * Bounds: all costs are within 0..32767, so S + L stays below 65536; sums above 32767 leave their top bit in `over`, and
 * the rare pixel that has one is clipped afterwards. */
#include <stddef.h>

#include "kernel/kernel.h"
#include "word.h"

enum total_use { TOTAL_NONE, TOTAL_FRESH, TOTAL_ADD };

/* What a pixel of a lane needs, its least cost so far, g at d - 1 and d, and the OR of its sums. */
typedef struct state {
    int32_t delta, p1, least, before, here;
    word over;
} state;

WORD_INLINE int32_t one(state *s, int32_t after, int32_t block)
{
    const int32_t next = s->delta - after, side = (s->before > next ? s->before : next) - s->p1;
    const int32_t path = block - floor_i32(side > s->here ? side : s->here);
    s->before = s->here;
    s->here = next;
    s->least = path < s->least ? path : s->least;
    return path;
}

/* Two disparities; total is aligned to a word, as D is a multiple of 8. */
WORD_INLINE void two(state *s, const int16_t *from, int16_t *to, const int16_t *block, word *total, enum total_use use)
{
    const int32_t low = one(s, from[1], block[0]), high = one(s, from[2], block[1]);
    const word path = (word)low | (word)high << 16;
    to[0] = (int16_t)low;
    to[1] = (int16_t)high;
    if (use == TOTAL_FRESH)
        *total = path;
    if (use == TOTAL_ADD) {
        *total += path;
        s->over |= *total;
    }
}

/* Sums above 32767 to 32767. */
static void clip(word *total, int32_t n)
{
    for (int32_t i = 0; i < n / 2; i++) {
        const word over = total[i] & WORD_TOPS;
        total[i] = (total[i] | (over - (over >> 15))) & ~over;
    }
}

WORD_INLINE int32_t pixel(state *s, const int16_t *from, int16_t *to, const int16_t *block, word *total, int32_t n,
                          enum total_use use)
{
    const int16_t *end = block + n;
    s->least = STAD_COST_MAX;
    s->before = s->delta - from[-1];
    s->here = s->delta - from[0];
    s->over = 0;
    do {
        two(s, from, to, block, total, use);
        two(s, from + 2, to + 2, block + 2, total + 1, use);
        two(s, from + 4, to + 4, block + 4, total + 2, use);
        two(s, from + 6, to + 6, block + 6, total + 3, use);
        from += 8;
        to += 8;
        block += 8;
        if (use != TOTAL_NONE)
            total += 4;
    } while (block != end);
    if (s->over & WORD_TOPS)
        clip(total - n / 2, n);
    return s->least;
}

/* One lane over the whole run: lanes do not meet but in S, whose order does not matter here. */
WORD_INLINE void run_of(const stad_path_job *job, stad_lane *lane, enum total_use use)
{
    const int32_t n = job->disparities, to_next = job->step * n, stride = job->stride, slots = lane->slots;
    const int16_t *block = job->block;
    word *total = (word *)(void *)job->total;
    int16_t *to = lane->cost + lane->write * stride;
    int32_t slot = lane->write; /* to be written */
    state s = {0, job->p1, 0, 0, 0, 0};
    for (int32_t i = job->count; i > 0; i--, block += to_next) {
        const int wraps = slot + 1 == slots;
        int16_t *from = wraps ? lane->cost : to + stride, *least = lane->least + slot;
        slot = wraps ? 0 : slot + 1;
        s.delta = lane->least[slot] + job->p2;
        *least = (int16_t)pixel(&s, from, to, block, total, n, use);
        to = from;
        if (use != TOTAL_NONE)
            total += to_next / 2;
    }
    lane->write = slot;
}

void stad_path_row_scalar(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
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
