/* SPDX-License-Identifier: MIT
 * box -> [SLIDE] -> path
 * port/isa/scalar/slide_row_scalar.c - block costs slid along vertical sums, two disparities a word.
 *
 * Bounds: every sum, and a sum before a column is taken away, lies in 0..65535 (STAD_COST_SAFE), so no lane carries. */
#include <stddef.h>

#include "kernel/kernel.h"
#include "word.h"

/* Column x of the sums, and how far to the next one, in words: columns outside repeat the border. */
static inline const word *sum_column(const stad_slide_job *job, int32_t x)
{
    const int32_t last = job->columns - 1;
    return (const word *)(const void *)(job->sum + (x < 0 ? 0 : x < last ? x : last) * job->disparities);
}

static inline int32_t to_next(const stad_slide_job *job, int32_t x)
{
    return x >= 0 && x < job->columns - 1 ? job->disparities / 2 : 0;
}

/* Eight disparities of the whole run: the running sums stay in four registers. */
WORD_INLINE void slide_eight(const stad_slide_job *job, int32_t at, int inside, word *to)
{
    const int32_t n = job->disparities / 2, r = job->radius;
    const word *in = sum_column(job, job->x - r) + at, *out = in;
    word a = word_set(job->p2), b = a, c = a, d = a;
    for (int32_t x = job->x - r; x <= job->x + r; x++) {
        a += in[0];
        b += in[1];
        c += in[2];
        d += in[3];
        in += inside ? n : to_next(job, x);
    }
    for (int32_t i = job->count, x = job->x; i > 0; i--, x++, to += n) {
        to[0] = a;
        to[1] = b;
        to[2] = c;
        to[3] = d;
        if (i == 1)
            break;
        a += in[0] - out[0];
        b += in[1] - out[1];
        c += in[2] - out[2];
        d += in[3] - out[3];
        in += inside ? n : to_next(job, x + r + 1);
        out += inside ? n : to_next(job, x - r);
    }
}

void stad_slide_row_scalar(const stad_slide_job *job, int16_t *block)
{
    const int inside = job->x >= job->radius && job->x + job->count + job->radius <= job->columns;
    word *to = (word *)(void *)block;
    for (int32_t at = 0; at < job->disparities / 2; at += 4) {
        if (inside)
            slide_eight(job, at, 1, to + at);
        else
            slide_eight(job, at, 0, to + at);
    }
}
