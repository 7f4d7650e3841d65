/* SPDX-License-Identifier: MIT
 * base/divide.c - 64-bit division, bit by bit. */
#include "base/divide.h"

static uint64_t magnitude(int64_t v)
{
    return v < 0 ? 0 - (uint64_t)v : (uint64_t)v;
}

int64_t stad_div_i64(int64_t a, int64_t b)
{
    uint64_t rest = magnitude(a), divisor = magnitude(b), quotient = 0, bit = 1;
    while (divisor <= rest / 2) {
        divisor *= 2;
        bit *= 2;
    }
    for (; bit > 0; bit /= 2, divisor /= 2) {
        if (rest < divisor)
            continue;
        rest -= divisor;
        quotient += bit;
    }
    const int64_t size = (int64_t)(quotient & INT64_MAX); /* |a| < 2^63 */
    return (a < 0) != (b < 0) ? -size : size;
}
