/* SPDX-License-Identifier: MIT
 * cost -> [BOX] -> slide
 * port/isa/arm_dsp/box_add_row_dsp.c - a row of pixel costs added to the sums of a window or taken away, four a word. Rows that
 * count more than once, at the image's ends, are left to C. */
#include <stddef.h>

#include "kernel/kernel.h"
#include "pair_dsp.h"

PAIR_INLINE void add_four(int16_t *sum, const uint8_t *cost, int take_away)
{
    const pair bytes = pair_load(cost), even = even_bytes(bytes), odd = odd_bytes(bytes);
    const pair low = pack_low(even, odd), high = pack_high(even, odd);
    const quad before = quad_load(sum);
    if (take_away)
        quad_store(sum, __usub16(before.low, low), __usub16(before.high, high));
    else
        quad_store(sum, __uadd16(before.low, low), __uadd16(before.high, high));
}

PAIR_INLINE void add_row(int16_t *sum, const uint8_t *cost, int32_t n, int take_away)
{
    for (int16_t *end = sum + n; sum != end; sum += 8, cost += 8) {
        add_four(sum, cost, take_away);
        add_four(sum + 4, cost + 4, take_away);
    }
}

/* The sums are aligned to a word: they are the workspace's. */
void stad_box_add_row_u8_dsp(int16_t *sum, const uint8_t *cost, int32_t n, int32_t weight)
{
    const int32_t whole = weight == 1 || weight == -1 ? n / 8 * 8 : 0;
    if (weight < 0)
        add_row(sum, cost, whole, 1);
    else
        add_row(sum, cost, whole, 0);
    stad_box_add_row_u8_c(sum + whole, cost + whole, n - whole, weight);
}
