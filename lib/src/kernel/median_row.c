/* SPDX-License-Identifier: MIT
 * check -> [MEDIAN] -> disparity
 * kernel/median_row.c - 3x3 median: each column of three sorted, then the median of the largest low, the middle mid and
 * the smallest high. Every pixel sorts its three columns anew, so that pixels depend on none of their kind. */
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

static inline int16_t median_of_columns(triple a, triple b, triple c)
{
    const int16_t low = max_i16(a.low, max_i16(b.low, c.low)), high = min_i16(a.high, min_i16(b.high, c.high));
    return median_of(low, median_of(a.mid, b.mid, c.mid), high);
}

static void median_inside(const int16_t *restrict above, const int16_t *restrict row, const int16_t *restrict below,
                          int32_t width, int16_t *restrict out)
{
    for (int32_t x = 1; x < width - 1; x++) {
        const triple before = sorted(above[x - 1], row[x - 1], below[x - 1]), here = sorted(above[x], row[x], below[x]);
        const triple after = sorted(above[x + 1], row[x + 1], below[x + 1]);
        out[x] = median_of_columns(before, here, after);
    }
}

static int16_t median_at(const int16_t *above, const int16_t *row, const int16_t *below, int32_t x, int32_t beside)
{
    const triple here = sorted(above[x], row[x], below[x]), other = sorted(above[beside], row[beside], below[beside]);
    return median_of_columns(here, here, other);
}

void stad_median_row_c(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out)
{
    const int32_t last = width - 1;
    median_inside(above, row, below, width, out);
    out[0] = median_at(above, row, below, 0, min_i32(1, last));
    out[last] = median_at(above, row, below, last, max_i32(last - 1, 0));
}
