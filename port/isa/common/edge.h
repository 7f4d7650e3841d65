/* SPDX-License-Identifier: MIT
 * port/isa/common/edge.h - border columns of kernel/range_row.c and kernel/median_row.c, where a column stands for its missing
 * neighbour. */
#ifndef STAD_EDGE_H
#define STAD_EDGE_H

#include <stddef.h>

#include "base/arith.h"

/* plane: the column; beside: from it to its neighbour; out: where its value goes, low and high a width further each. */
static inline void range_edge(const uint8_t *plane, int32_t beside, ptrdiff_t width, uint8_t *out)
{
    const uint8_t here = plane[0], half = (uint8_t)((here + plane[beside]) / 2);
    out[0] = here;
    out[width] = min_u8(here, half);
    out[2 * width] = max_u8(here, half);
}

static inline int16_t median_of_three(int16_t a, int16_t b, int16_t c)
{
    return max_i16(min_i16(a, b), min_i16(max_i16(a, b), c));
}

/* Column x of three rows; beside: from it to its neighbour. Its sorted column counts twice: the middle one is the middle of three. */
static inline int16_t median_edge(const int16_t *above, const int16_t *row, const int16_t *below, int32_t x, int32_t beside)
{
    const int16_t a = above[x], b = row[x], c = below[x], d = above[x + beside], e = row[x + beside], f = below[x + beside];
    const int16_t low = max_i16(min_i16(a, min_i16(b, c)), min_i16(d, min_i16(e, f)));
    const int16_t high = min_i16(max_i16(a, max_i16(b, c)), max_i16(d, max_i16(e, f)));
    return median_of_three(low, median_of_three(a, b, c), high);
}

#endif
