/* SPDX-License-Identifier: MIT
 * prefilter -> [RANGE] -> cost
 * kernel/range_row.c - a plane with the lowest and highest value each sample takes within half a pixel. */
#include "kernel/kernel.h"
#include "base/arith.h"

/* A sample between its neighbours, the ends beside themselves, to place `to` of the three runs of `out`. */
static inline void put(const uint8_t *at, int32_t before, int32_t after, uint8_t *value, uint8_t *low, uint8_t *high)
{
    const uint8_t here = at[0];
    const uint8_t left = (uint8_t)((here + at[before]) / 2), right = (uint8_t)((here + at[after]) / 2);
    *value = here;
    *low = min_u8(here, min_u8(left, right));
    *high = max_u8(here, max_u8(left, right));
}

static void inside(const uint8_t *restrict plane, int32_t width, uint8_t *restrict value, uint8_t *restrict low,
                   uint8_t *restrict high)
{
    /*@ loop invariant 1 <= x && (x < width || x == 1);
        loop assigns x, value[0 .. width - 1], low[0 .. width - 1], high[0 .. width - 1]; loop variant width - x; */
    for (int32_t x = 1; x < width - 1; x++)
        put(plane + x, -1, 1, value + x, low + x, high + x);
}

static void inside_reverse(const uint8_t *restrict plane, int32_t width, uint8_t *restrict value, uint8_t *restrict low,
                           uint8_t *restrict high)
{
    /*@ loop invariant 1 <= x && (x < width || x == 1);
        loop assigns x, value[0 .. width - 1], low[0 .. width - 1], high[0 .. width - 1]; loop variant width - x; */
    for (int32_t x = 1; x < width - 1; x++)
        put(plane + (width - 1 - x), -1, 1, value + x, low + x, high + x);
}

void stad_range_row_c(const uint8_t *plane, int32_t width, int reverse, uint8_t *out)
{
    uint8_t *value = out, *low = out + width, *high = out + 2 * (ptrdiff_t)width;
    const int32_t last = width - 1, first_to = reverse ? last : 0, last_to = last - first_to;
    if (reverse)
        inside_reverse(plane, width, value, low, high);
    else
        inside(plane, width, value, low, high);
    put(plane, 0, last > 0, value + first_to, low + first_to, high + first_to);
    put(plane + last, last > 0 ? -1 : 0, 0, value + last_to, low + last_to, high + last_to);
}
