/* SPDX-License-Identifier: MIT
 * box -> [SLIDE] -> path
 * port/isa/arm_dsp/slide_row_dsp.c - block costs slid along vertical sums. */
#include <stddef.h>

#include "kernel/kernel.h"
#include "pair_dsp.h"

/* Column x of the sums, and how far to the next one: columns outside repeat the border. */
static inline const int16_t *sum_column(const stad_slide_job *job, int32_t x)
{
    const int32_t last = job->columns - 1;
    return job->sum + (x < 0 ? 0 : x < last ? x : last) * job->disparities;
}

static inline int32_t to_next(const stad_slide_job *job, int32_t x)
{
    return x >= 0 && x < job->columns - 1 ? job->disparities : 0;
}

/* Eight disparities: the running sums stay in four registers. */
typedef struct eight {
    pair v[4];
} eight;

PAIR_INLINE void add_column(eight *run, const int16_t *in)
{
#pragma GCC unroll 2
    for (int k = 0; k < 4; k += 2) {
        const quad a = quad_load(in + 2 * k);
        run->v[k] = __uadd16(run->v[k], a.low);
        run->v[k + 1] = __uadd16(run->v[k + 1], a.high);
    }
}

PAIR_INLINE void put_column(const eight *run, int16_t *to)
{
    quad_store(to, run->v[0], run->v[1]);
    quad_store(to + 4, run->v[2], run->v[3]);
}

PAIR_INLINE void take_column(eight *run, const int16_t *out)
{
#pragma GCC unroll 2
    for (int k = 0; k < 4; k += 2) {
        const quad a = quad_load(out + 2 * k);
        run->v[k] = __usub16(run->v[k], a.low);
        run->v[k + 1] = __usub16(run->v[k + 1], a.high);
    }
}

PAIR_INLINE void slide_eight(const stad_slide_job *job, int32_t d, int inside, int16_t *to)
{
    const int32_t n = job->disparities, r = job->radius;
    const int16_t *in = sum_column(job, job->x - r) + d, *out = in;
    const pair p2 = pair_set(job->p2);
    eight run = {{p2, p2, p2, p2}};
    for (int32_t x = job->x - r; x <= job->x + r; x++) {
        add_column(&run, in);
        in += inside ? n : to_next(job, x);
    }
    put_column(&run, to);
    for (int32_t i = job->count - 1, x = job->x; i > 0; i--, x++) {
        to += n;
        add_column(&run, in);
        take_column(&run, out);
        put_column(&run, to);
        in += inside ? n : to_next(job, x + r + 1);
        out += inside ? n : to_next(job, x - r);
    }
}

void stad_slide_row_dsp(const stad_slide_job *job, int16_t *block)
{
    const int inside = job->x >= job->radius && job->x + job->count + job->radius <= job->columns;
    for (int32_t d = 0; d < job->disparities; d += 8) {
        if (inside)
            slide_eight(job, d, 1, block + d);
        else
            slide_eight(job, d, 0, block + d);
    }
}
