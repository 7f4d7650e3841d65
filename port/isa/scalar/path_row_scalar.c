/* SPDX-License-Identifier: MIT
 * slide -> [PATH] -> best
 * port/isa/scalar/path_row_scalar.c - path costs, sum and least value in one loop, for cores without SIMD.
 *
 * The recurrence of kernel/path_row.c as a gain: with delta = m + p2 and ceiling = delta - p1 >= 0,
 *     L = C - max(floor(delta - p[d]), ceiling - min(p[d-1], p[d+1])),   floor(v) = max(v, 0)
 * Bounds: all costs are within 0..32767, so S + L stays below 65536 and a lane that passes 32767 shows it in its top bit. */
#include <stddef.h>

#include "kernel/kernel.h"
#include "word.h"

enum total_use { TOTAL_NONE, TOTAL_FRESH, TOTAL_ADD };

/* What a pixel of a lane needs, its least cost so far, and the costs at d - 1 and d. */
typedef struct state {
    int32_t delta, ceiling, least, before, here;
} state;

WORD_INLINE int32_t one(state *s, int32_t after, int32_t block)
{
    const int32_t side = s->ceiling - least_i32(s->before, after), gain = floor_i32(s->delta - s->here);
    const int32_t path = block - (gain + floor_i32(side - gain));
    s->before = s->here;
    s->here = after;
    s->least = least_i32(s->least, path);
    return path;
}

/* Two disparities; block and total are aligned to a word, as D is a multiple of 8. */
WORD_INLINE void two(state *s, const int16_t *from, int16_t *to, const word *block, word *total, enum total_use use)
{
    const word cost = *block;
    const int32_t low = one(s, from[1], (int32_t)(cost & 0xFFFFu)), high = one(s, from[2], (int32_t)(cost >> 16));
    const word path = (word)low | (word)high << 16;
    to[0] = (int16_t)low;
    to[1] = (int16_t)high;
    if (use == TOTAL_FRESH)
        *total = path;
    if (use == TOTAL_ADD) {
        const word sum = *total + path, over = sum & 0x80008000u;
        *total = (sum | (over - (over >> 15))) & ~over;
    }
}

WORD_INLINE int32_t pixel(state *s, const int16_t *from, int16_t *to, const word *block, word *total, int32_t n,
                          enum total_use use)
{
    const int16_t *end = from + n;
    s->least = STAD_COST_MAX;
    s->before = from[-1];
    s->here = from[0];
    do {
        two(s, from, to, block, total, use);
        two(s, from + 2, to + 2, block + 1, total + 1, use);
        two(s, from + 4, to + 4, block + 2, total + 2, use);
        two(s, from + 6, to + 6, block + 3, total + 3, use);
        from += 8;
        to += 8;
        block += 4;
        if (use != TOTAL_NONE)
            total += 4;
    } while (from != end);
    return s->least;
}

/* One lane over the whole run: lanes do not meet but in S, whose order does not matter here. */
WORD_INLINE void run_of(const stad_path_job *job, stad_lane *lane, enum total_use use)
{
    const int32_t n = job->disparities, to_next = job->step * n / 2, stride = job->stride, slots = lane->slots;
    const word *block = (const word *)(const void *)job->block;
    word *total = (word *)(void *)job->total;
    int16_t *to = lane->cost + lane->write * stride;
    int32_t slot = lane->write; /* to be written */
    state s = {0, 0, 0, 0, 0};
    for (int32_t i = job->count; i > 0; i--, block += to_next) {
        const int wraps = slot + 1 == slots;
        int16_t *from = wraps ? lane->cost : to + stride, *least = lane->least + slot;
        slot = wraps ? 0 : slot + 1;
        s.delta = lane->least[slot] + job->p2;
        s.ceiling = s.delta - job->p1;
        *least = (int16_t)pixel(&s, from, to, block, total, n, use);
        to = from;
        if (use != TOTAL_NONE)
            total += to_next;
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
