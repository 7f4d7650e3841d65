/* SPDX-License-Identifier: MIT
 * cost -> [BOX] -> slide
 * kernel/box_row.c - vertical sums of cost rows.
 *
 * Bound: called only where (2r+1)^2 * largest cost <= 32767, so every sum of 2r+1 costs and one more fits. */
#include "kernel/kernel.h"
#include "base/arith.h"

void stad_box_add_row_u8_c(int16_t *restrict sum, const uint8_t *restrict cost, int32_t n, int32_t weight)
{
    /*@ loop invariant 0 <= i <= n && \forall integer k; i <= k < n ==> sum[k] == \at(sum[k], LoopEntry);
        loop assigns i, sum[0 .. n - 1]; loop variant n - i; */
    for (int32_t i = 0; i < n; i++)
        sum[i] = narrow_i16(sum[i] + weight * cost[i]);
}

void stad_box_add_row_u16_c(int16_t *restrict sum, const uint16_t *restrict cost, int32_t n, int32_t weight)
{
    /*@ loop invariant 0 <= i <= n && \forall integer k; i <= k < n ==> sum[k] == \at(sum[k], LoopEntry);
        loop assigns i, sum[0 .. n - 1]; loop variant n - i; */
    for (int32_t i = 0; i < n; i++)
        sum[i] = narrow_i16(sum[i] + weight * cost[i]);
}
