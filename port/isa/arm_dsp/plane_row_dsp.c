/* SPDX-License-Identifier: MIT
 * prefilter -> [RANGE] -> cost; check -> [MEDIAN] -> disparity
 * port/isa/arm_dsp/plane_row_dsp.c - prefilter and half-sample ranges by four bytes, the 3x3 median by two disparities.
 *
 * Inner columns go by whole registers, the last of which overlaps the one before; borders and narrow rows are left to C. */
#include <stddef.h>

#include "kernel/kernel.h"
#include "pair_dsp.h"
#include "../common/edge.h"

/* Where the group of `lanes` columns that begins at x really begins, so that it ends before the last column. */
static inline int32_t inner_at(int32_t x, int32_t width, int32_t lanes)
{
    return x < width - 1 - lanes ? x : width - 1 - lanes;
}

/* x-Sobel of columns 0 and 2 (or, with the rows shifted by a byte, 1 and 3) of four: within +-1020. */
PAIR_INLINE pair sobel(pair above, pair above_2, pair row, pair row_2, pair below, pair below_2)
{
    const pair mid = __usub16(row_2, row);
    const pair rim = __uadd16(__usub16(above_2, above), __usub16(below_2, below));
    return __uadd16(__uadd16(mid, mid), rim);
}

PAIR_INLINE pair clipped(pair g, pair top, pair bottom)
{
    return __uadd16(pair_min_i16(pair_max_i16(g, bottom), top), top);
}

PAIR_INLINE pair gradient_at(const uint8_t *above, const uint8_t *row, const uint8_t *below, pair top, pair bottom)
{
    const pair a = pair_load(above - 1), a2 = pair_load(above + 1), r = pair_load(row - 1), r2 = pair_load(row + 1);
    const pair b = pair_load(below - 1), b2 = pair_load(below + 1);
    const pair even = sobel(even_bytes(a), even_bytes(a2), even_bytes(r), even_bytes(r2), even_bytes(b), even_bytes(b2));
    const pair odd = sobel(odd_bytes(a), odd_bytes(a2), odd_bytes(r), odd_bytes(r2), odd_bytes(b), odd_bytes(b2));
    return even_bytes(clipped(even, top, bottom)) | even_bytes(clipped(odd, top, bottom)) << 8; /* modulo 256, as specified */
}

void stad_prefilter_row_dsp(const uint8_t *above, const uint8_t *row, const uint8_t *below, int32_t width, int32_t channels,
                            int32_t cap, uint8_t *planes)
{
    const pair top = pair_set(cap), bottom = pair_set(-cap);
    uint8_t *gradient = planes, *intensity = planes + width;
    if (channels != 1 || width < 4 + 2) {
        stad_prefilter_row_c(above, row, below, width, channels, cap, planes);
        return;
    }
    for (int32_t x = 1; x < width - 1; x += 4) {
        const int32_t at = inner_at(x, width, 4);
        pair_store(gradient + at, gradient_at(above + at, row + at, below + at, top, bottom));
        pair_store(intensity + at, pair_load(row + at));
    }
    gradient[0] = gradient[width - 1] = intensity[0] = intensity[width - 1] = (uint8_t)(cap & 0xFF);
}

PAIR_INLINE pair turned(pair v, int reverse)
{
    return reverse ? __builtin_bswap32(v) : v;
}

PAIR_INLINE void ranges(const uint8_t *plane, int32_t width, int reverse, uint8_t *out)
{
    for (int32_t x = 1; x < width - 1; x += 4) {
        const int32_t at = inner_at(x, width, 4);
        uint8_t *to = out + (reverse ? width - at - 4 : at);
        const pair here = pair_load(plane + at);
        const pair before = __uhadd8(here, pair_load(plane + at - 1)), after = __uhadd8(here, pair_load(plane + at + 1));
        pair_store(to, turned(here, reverse));
        pair_store(to + width, turned(bytes_min(here, bytes_min(before, after)), reverse));
        pair_store(to + 2 * width, turned(bytes_max(here, bytes_max(before, after)), reverse));
    }
}

void stad_range_row_dsp(const uint8_t *plane, int32_t width, int reverse, uint8_t *out)
{
    if (width < 4 + 2) {
        stad_range_row_c(plane, width, reverse, out);
        return;
    }
    if (reverse)
        ranges(plane, width, 1, out);
    else
        ranges(plane, width, 0, out);
    range_edge(plane, 1, width, out + (reverse ? width - 1 : 0));
    range_edge(plane + width - 1, -1, width, out + (reverse ? 0 : width - 1));
}

typedef struct triple {
    pair low, mid, high;
} triple;

PAIR_INLINE triple sorted_at(const int16_t *above, const int16_t *row, const int16_t *below, int32_t x)
{
    const pair a = pair_load(above + x), b = pair_load(row + x), c = pair_load(below + x);
    const pair low = pair_min_i16(a, b), high = pair_max_i16(a, b);
    triple t = {pair_min_i16(low, c), pair_max_i16(low, pair_min_i16(high, c)), pair_max_i16(high, c)};
    return t;
}

PAIR_INLINE pair median_of(pair a, pair b, pair c)
{
    return pair_max_i16(pair_min_i16(a, b), pair_min_i16(pair_max_i16(a, b), c));
}

void stad_median_row_dsp(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out)
{
    if (width < 2 + 2) {
        stad_median_row_c(above, row, below, width, out);
        return;
    }
    for (int32_t x = 1; x < width - 1; x += 2) {
        const int32_t at = inner_at(x, width, 2);
        const triple l = sorted_at(above, row, below, at - 1), m = sorted_at(above, row, below, at);
        const triple r = sorted_at(above, row, below, at + 1);
        const pair low = pair_max_i16(l.low, pair_max_i16(m.low, r.low));
        const pair high = pair_min_i16(l.high, pair_min_i16(m.high, r.high));
        pair_store(out + at, median_of(low, median_of(l.mid, m.mid, r.mid), high));
    }
    out[0] = median_edge(above, row, below, 0, 1);
    out[width - 1] = median_edge(above, row, below, width - 1, -1);
}
