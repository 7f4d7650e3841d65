/* SPDX-License-Identifier: MIT
 * cost -> [BLOCK] -> path
 * kernel/block_row.c - a whole row of block costs C moved by a row: C += hs(in) - hs(out), the horizontal sums slid along.
 *
 * Bound: C and each hs lie in 0..32767 wherever this is called (SPEC 10), so a difference of two hs fits int16 as well. */
#include <string.h>

#include "kernel/kernel.h"
#include "base/arith.h"

/* hs is hs(in) - hs(out) of a column; at: the cell where that column begins. */
static void gain_u8(int16_t *restrict hs, const stad_block_job *job, ptrdiff_t at, int32_t n)
{
    const uint8_t *in = (const uint8_t *)job->in + at, *out = (const uint8_t *)job->out + at;
    for (int32_t d = 0; d < n; d++)
        hs[d] = narrow_i16(hs[d] + in[d] - out[d]);
}

static void gain_u16(int16_t *restrict hs, const stad_block_job *job, ptrdiff_t at, int32_t n)
{
    const uint16_t *in = (const uint16_t *)job->in + at, *out = (const uint16_t *)job->out + at;
    for (int32_t d = 0; d < n; d++)
        hs[d] = narrow_i16(hs[d] + in[d] - out[d]);
}

/* hs one column on, where the column at `plus` comes in and that at `minus` leaves; block takes it. */
static void step_u8(int16_t *restrict block, int16_t *restrict hs, const stad_block_job *job, ptrdiff_t plus, ptrdiff_t minus,
                    int32_t n)
{
    const uint8_t *in = job->in, *out = job->out;
    for (int32_t d = 0; d < n; d++) {
        hs[d] = narrow_i16(hs[d] + (in[plus + d] - out[plus + d]) - (in[minus + d] - out[minus + d]));
        block[d] = narrow_i16(block[d] + hs[d]);
    }
}

static void step_u16(int16_t *restrict block, int16_t *restrict hs, const stad_block_job *job, ptrdiff_t plus, ptrdiff_t minus,
                     int32_t n)
{
    const uint16_t *in = job->in, *out = job->out;
    for (int32_t d = 0; d < n; d++) {
        hs[d] = narrow_i16(hs[d] + (in[plus + d] - out[plus + d]) - (in[minus + d] - out[minus + d]));
        block[d] = narrow_i16(block[d] + hs[d]);
    }
}

static ptrdiff_t column(const stad_block_job *job, int32_t x)
{
    return (ptrdiff_t)clamp_i32(x, 0, job->columns - 1) * job->disparities;
}

static void gain(const stad_block_job *job, ptrdiff_t at, int32_t n)
{
    if (job->wide)
        gain_u16(job->hs, job, at, n);
    else
        gain_u8(job->hs, job, at, n);
}

void stad_block_row_c(const stad_block_job *job, int16_t *block)
{
    const int32_t n = whole_8(job->disparities), r = job->radius;
    memset(job->hs, 0, 2 * (size_t)n);
    for (int32_t x = -r - 1; x < r; x++) /* the sum one column to the left of the first */
        gain(job, column(job, x), n);
    for (int32_t x = 0; x < job->columns; x++, block += n) {
        const ptrdiff_t plus = column(job, x + r), minus = column(job, x - r - 1);
        if (job->wide)
            step_u16(block, job->hs, job, plus, minus, n);
        else
            step_u8(block, job->hs, job, plus, minus, n);
    }
}
