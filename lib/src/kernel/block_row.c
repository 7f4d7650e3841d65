/* SPDX-License-Identifier: MIT
 * cost -> [BLOCK] -> path
 * kernel/block_row.c - a whole row of block costs C moved by a row: C += hs(in) - hs(out), the horizontal sums slid along.
 *
 * Bound: C and each hs lie in 0..32767 wherever this is called (SPEC 10), so a difference of two hs fits int16 as well. */
#include <string.h>

#include "kernel/kernel.h"
#include "base/arith.h"

/* A column of both rows. hs is hs(in) - hs(out) of one. */
typedef struct column {
    const void *in, *out;
} column;

static column column_at(const stad_block_job *job, int32_t x)
{
    const ptrdiff_t cell = (ptrdiff_t)clamp_i32(x, 0, job->columns - 1) * job->disparities, at = job->wide ? 2 * cell : cell;
    const column c = {(const uint8_t *)job->in + at, (const uint8_t *)job->out + at};
    return c;
}

static void gain_u8(int16_t *restrict hs, column plus, int32_t n)
{
    const uint8_t *a = plus.in, *b = plus.out;
    for (int32_t d = 0; d < n; d++)
        hs[d] = narrow_i16(hs[d] + a[d] - b[d]);
}

static void gain_u16(int16_t *restrict hs, column plus, int32_t n)
{
    const uint16_t *a = plus.in, *b = plus.out;
    for (int32_t d = 0; d < n; d++)
        hs[d] = narrow_i16(hs[d] + a[d] - b[d]);
}

/* hs one column on, where `plus` comes in and `minus` leaves; block takes it. */
static void step_u8(int16_t *restrict block, int16_t *restrict hs, column plus, column minus, int32_t n)
{
    const uint8_t *a = plus.in, *b = plus.out, *c = minus.in, *e = minus.out;
    for (int32_t d = 0; d < n; d++) {
        hs[d] = narrow_i16(hs[d] + (a[d] - b[d]) - (c[d] - e[d]));
        block[d] = narrow_i16(block[d] + hs[d]);
    }
}

static void step_u16(int16_t *restrict block, int16_t *restrict hs, column plus, column minus, int32_t n)
{
    const uint16_t *a = plus.in, *b = plus.out, *c = minus.in, *e = minus.out;
    for (int32_t d = 0; d < n; d++) {
        hs[d] = narrow_i16(hs[d] + (a[d] - b[d]) - (c[d] - e[d]));
        block[d] = narrow_i16(block[d] + hs[d]);
    }
}

void stad_block_row_c(const stad_block_job *job, int16_t *block)
{
    const int32_t n = whole_8(job->disparities), r = job->radius;
    memset(job->hs, 0, 2 * (size_t)n);
    for (int32_t x = -r - 1; x < r; x++) { /* the sum one column to the left of the first */
        const column plus = column_at(job, x);
        if (job->wide)
            gain_u16(job->hs, plus, n);
        else
            gain_u8(job->hs, plus, n);
    }
    for (int32_t x = 0; x < job->columns; x++, block += n) {
        const column plus = column_at(job, x + r), minus = column_at(job, x - r - 1);
        if (job->wide)
            step_u16(block, job->hs, plus, minus, n);
        else
            step_u8(block, job->hs, plus, minus, n);
    }
}
