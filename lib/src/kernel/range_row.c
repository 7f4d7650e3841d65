/* SPDX-License-Identifier: MIT
 * prefilter -> [RANGE] -> cost
 * kernel/range_row.c - a plane with the lowest and highest value each sample takes within half a pixel. */
#include "kernel/kernel.h"
#include "base/arith.h"

void stad_range_row_c(const uint8_t *plane, int32_t width, int reverse, uint8_t *out)
{
    uint8_t *value = out, *low = out + width, *high = out + 2 * (ptrdiff_t)width;
    const int32_t first = reverse ? width - 1 : 0, step = reverse ? -1 : 1;
    for (int32_t x = 0; x < width; x++) {
        const int32_t here = plane[x];
        const int32_t before = (here + plane[x > 0 ? x - 1 : x]) / 2;
        const int32_t after = (here + plane[x < width - 1 ? x + 1 : x]) / 2;
        const int32_t to = first + step * x;
        value[to] = (uint8_t)here;
        low[to] = (uint8_t)min_i32(here, min_i32(before, after));
        high[to] = (uint8_t)max_i32(here, max_i32(before, after));
    }
}
