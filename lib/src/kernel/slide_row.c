/* SPDX-License-Identifier: MIT
 * box -> [SLIDE] -> path
 * kernel/slide_row.c - the block cost of a run of columns, slid along the vertical sums.
 *
 * Bound: p2 + (2r+1)^2 * largest cost <= 32767 wherever this is called (SPEC 10), so C never leaves int16. */
#include "kernel/kernel.h"
#include "base/arith.h"

static inline const int16_t *column(const stad_slide_job *job, int32_t x)
{
    return job->sum + (ptrdiff_t)clamp_i32(x, 0, job->columns - 1) * job->disparities;
}

static void add_column(int16_t *restrict block, const int16_t *restrict sum, int32_t n)
{
    /*@ loop invariant 0 <= d <= n && \forall integer k; d <= k < n ==> block[k] == \at(block[k], LoopEntry);
        loop assigns d, block[0 .. n - 1]; loop variant n - d; */
    for (int32_t d = 0; d < n; d++)
        block[d] = narrow_i16(block[d] + sum[d]);
}

static void move_column(int16_t *restrict to, const int16_t *from, const int16_t *in, const int16_t *out, int32_t n)
{
    /*@ loop invariant 0 <= d <= n && \forall integer k; d <= k < n ==> to[k] == \at(to[k], LoopEntry);
        loop assigns d, to[0 .. n - 1]; loop variant n - d; */
    for (int32_t d = 0; d < n; d++)
        to[d] = narrow_i16(from[d] + (in[d] - out[d]));
}

void stad_slide_row_c(const stad_slide_job *job, int16_t *block)
{
    STAD_ASSERT(job->disparities % 8 == 0 && job->x >= 0 && job->x + job->count <= job->columns);
    const int32_t n = whole_8(job->disparities), r = job->radius;
    for (int32_t d = 0; d < n; d++)
        block[d] = narrow_i16(job->p2);
    for (int32_t j = -r; j <= r; j++)
        add_column(block, column(job, job->x + j), n);
    for (int32_t i = 1; i < job->count; i++, block += n)
        move_column(block + n, block, column(job, job->x + i + r), column(job, job->x + i - r - 1), n);
}
