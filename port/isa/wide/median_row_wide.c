/* SPDX-License-Identifier: MIT
 * check -> [MEDIAN] -> disparity
 * port/isa/wide/median_row_wide.c - 3x3 median of every pixel by itself: nothing carried from column to column. */
#include "../common/edge.h"
#include "kernel/kernel.h"

typedef struct triple {
    int16_t low, mid, high;
} triple;

static inline triple sorted(int16_t a, int16_t b, int16_t c)
{
    const int16_t low = min_i16(a, b), high = max_i16(a, b);
    const triple t = {min_i16(low, c), max_i16(low, min_i16(high, c)), max_i16(high, c)};
    return t;
}

static inline int16_t median_of_columns(triple a, triple b, triple c)
{
    const int16_t low = max_i16(a.low, max_i16(b.low, c.low)), high = min_i16(a.high, min_i16(b.high, c.high));
    return median_of_three(low, median_of_three(a.mid, b.mid, c.mid), high);
}

void stad_median_row_wide(const int16_t *restrict above, const int16_t *restrict row, const int16_t *restrict below,
                          int32_t width, int16_t *restrict out)
{
    const int32_t last = width - 1;
    out[0] = median_edge(above, row, below, 0, last > 0);
    for (int32_t x = 1; x < last; x++)
        out[x] = median_of_columns(sorted(above[x - 1], row[x - 1], below[x - 1]), sorted(above[x], row[x], below[x]),
                                   sorted(above[x + 1], row[x + 1], below[x + 1]));
    out[last] = median_edge(above, row, below, last, -(last > 0));
}
