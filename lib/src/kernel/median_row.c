/* SPDX-License-Identifier: MIT
 * check -> [MEDIAN] -> disparity
 * kernel/median_row.c - 3x3 median: sort each column of three, then combine (max of lows, median of mids, min of highs). */
#include "kernel/kernel.h"
#include "base/arith.h"

typedef struct triple {
    int16_t low, mid, high;
} triple;

static inline int16_t median_of(int16_t a, int16_t b, int16_t c)
{
    return max_i16(min_i16(a, b), min_i16(max_i16(a, b), c));
}

static inline triple sorted(int16_t a, int16_t b, int16_t c)
{
    const int16_t low = min_i16(a, b), high = max_i16(a, b);
    triple t = {min_i16(low, c), max_i16(low, min_i16(high, c)), max_i16(high, c)};
    return t;
}

void stad_median_row_c(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out)
{
    STAD_ASSERT(width > 0);
    triple before = sorted(above[0], row[0], below[0]), here = before;
    /*@ loop invariant 0 <= x <= width; loop assigns x, before, here, out[0 .. width - 1]; loop variant width - x; */
    for (int32_t x = 0; x < width; x++) {
        const int32_t next = min_i32(x + 1, width - 1);
        const triple after = sorted(above[next], row[next], below[next]);
        const int16_t low = max_i16(before.low, max_i16(here.low, after.low));
        const int16_t high = min_i16(before.high, min_i16(here.high, after.high));
        out[x] = median_of(low, median_of(before.mid, here.mid, after.mid), high);
        before = here;
        here = after;
    }
}
