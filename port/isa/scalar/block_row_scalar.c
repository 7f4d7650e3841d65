/* SPDX-License-Identifier: MIT
 * cost -> [BLOCK] -> path
 * port/isa/scalar/block_row_scalar.c - a row of block costs moved by a row, two disparities a word.
 *
 * A word of hs(in) - hs(out) is low + 65536 high with lanes of either sign; added to a word of C, whose lanes stay in 0..32767
 * before and after, whatever the low lane borrowed it gives back. */
#include <stddef.h>

#include "kernel/kernel.h"
#include "../common/block_zone.h"
#include "word.h"

WORD_INLINE word change_two(const uint8_t *in, const uint8_t *out)
{
    return (word)in[0] - out[0] + (((word)in[1] - out[1]) << 16);
}

WORD_INLINE word step_two(const uint8_t *in, const uint8_t *out, const uint8_t *in_left, const uint8_t *out_left)
{
    const word low = (word)in[0] - out[0] - in_left[0] + out_left[0];
    const word high = (word)in[1] - out[1] - in_left[1] + out_left[1];
    return low + (high << 16);
}

/* The whole row of four disparities from the d-th on. */
static void block_four(const stad_block_job *job, int32_t d, word *to)
{
    const uint8_t *in = (const uint8_t *)job->in + d, *out = (const uint8_t *)job->out + d;
    const uint8_t *in_left = in, *out_left = out;
    const int32_t n = job->disparities / 2, r = job->radius;
    word a = 0, b = 0;
    for (int32_t x = -r - 1; x < r; x++) {
        const ptrdiff_t at = block_column(job, x);
        a += change_two(in + at, out + at);
        b += change_two(in + at + 2, out + at + 2);
    }
    in += block_column(job, r);
    out += block_column(job, r);
    for (int32_t x = 0; x < job->columns;) {
        const block_zone zone = block_zone_at(job, x);
        for (word *end = to + (zone.end - x) * n; to != end; to += n) {
            a += step_two(in, out, in_left, out_left);
            b += step_two(in + 2, out + 2, in_left + 2, out_left + 2);
            to[0] += a;
            to[1] += b;
            in += zone.plus;
            out += zone.plus;
            in_left += zone.minus;
            out_left += zone.minus;
        }
        x = zone.end;
    }
}

/* The row of block costs is aligned to a word: it is the workspace's. */
void stad_block_row_scalar(const stad_block_job *job, int16_t *block)
{
    if (job->wide)
        stad_block_row_c(job, block);
    for (int32_t d = 0; !job->wide && d < job->disparities; d += 4)
        block_four(job, d, (word *)(void *)(block + d));
}
