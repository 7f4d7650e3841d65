/* SPDX-License-Identifier: MIT
 * cost -> [BLOCK] -> path
 * port/isa/arm_dsp/block_row_dsp.c - a row of block costs moved by a row, four disparities a word of costs. */
#include <stddef.h>

#include "kernel/kernel.h"
#include "../common/block_zone.h"
#include "pair_dsp.h"

/* hs(in) - hs(out) of four disparities. */
typedef struct four {
    pair even, odd;
} four;

PAIR_INLINE void gain_four(four *hs, pair in, pair out)
{
    hs->even = __uadd16(hs->even, __usub16(even_bytes(in), even_bytes(out)));
    hs->odd = __uadd16(hs->odd, __usub16(odd_bytes(in), odd_bytes(out)));
}

PAIR_INLINE void take_four(const four *hs, int16_t *block)
{
    const quad before = quad_load(block);
    quad_store(block, __uadd16(before.low, pack_low(hs->even, hs->odd)), __uadd16(before.high, pack_high(hs->even, hs->odd)));
}

/* The whole row of eight disparities from the d-th on; the sums stay in four registers. */
static void block_eight(const stad_block_job *job, int32_t d, int16_t *to)
{
    const uint8_t *in = (const uint8_t *)job->in + d, *out = (const uint8_t *)job->out + d;
    const uint8_t *in_left = in, *out_left = out;
    const int32_t n = job->disparities, r = job->radius;
    four a = {0, 0}, b = {0, 0};
    for (int32_t x = -r - 1; x < r; x++) {
        const ptrdiff_t at = block_column(job, x);
        gain_four(&a, pair_load(in + at), pair_load(out + at));
        gain_four(&b, pair_load(in + at + 4), pair_load(out + at + 4));
    }
    in += block_column(job, r);
    out += block_column(job, r);
    for (int32_t x = 0; x < job->columns;) {
        const block_zone zone = block_zone_at(job, x);
        for (int16_t *end = to + (zone.end - x) * n; to != end; to += n) {
            gain_four(&a, pair_load(in), pair_load(out));
            gain_four(&a, pair_load(out_left), pair_load(in_left));
            take_four(&a, to);
            gain_four(&b, pair_load(in + 4), pair_load(out + 4));
            gain_four(&b, pair_load(out_left + 4), pair_load(in_left + 4));
            take_four(&b, to + 4);
            in += zone.plus;
            out += zone.plus;
            in_left += zone.minus;
            out_left += zone.minus;
        }
        x = zone.end;
    }
}

/* The row of block costs is aligned to a word: it is the workspace's. */
void stad_block_row_dsp(const stad_block_job *job, int16_t *block)
{
    if (job->wide)
        stad_block_row_c(job, block);
    for (int32_t d = 0; !job->wide && d < job->disparities; d += 8)
        block_eight(job, d, block + d);
}
