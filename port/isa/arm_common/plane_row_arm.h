/* SPDX-License-Identifier: MIT
 * port/isa/arm_common/plane_row_arm.h - template: prefilter, half-sample ranges and median.
 *
 * Inner columns go by whole vectors, the last of which overlaps the one before; borders and narrow rows are left to C. */

#include "../common/edge.h"

/* Where the vector of `lanes` columns that begins at x really begins, so that it ends before the last column. */
static inline int32_t inner_at(int32_t x, int32_t width, int32_t lanes)
{
    return x < width - 1 - lanes ? x : width - 1 - lanes;
}

/* x-Sobel of 8 pixels: lanes stay within +-1020. */
static inline vec gradient_at(const uint8_t *above, const uint8_t *row, const uint8_t *below)
{
    const vec mid = vec_sub_widened(row + 1, row - 1);
    const vec rim = vec_add(vec_sub_widened(above + 1, above - 1), vec_sub_widened(below + 1, below - 1));
    return vec_add(vec_add(mid, mid), rim);
}

void STAD_TIER(stad_prefilter_row)(const uint8_t *above, const uint8_t *row, const uint8_t *below, int32_t width,
                                   int32_t channels, int32_t cap, uint8_t *planes)
{
    const vec top = vec_set(cap), bottom = vec_set(-cap);
    uint8_t *gradient = planes, *intensity = planes + width;
    if (channels != 1 || width < 16 + 2) {
        stad_prefilter_row_c(above, row, below, width, channels, cap, planes);
        return;
    }
    for (int32_t x = 1; x < width - 1; x += 8) {
        const int32_t at = inner_at(x, width, 8);
        const vec bound = vec_min(vec_max(gradient_at(above + at, row + at, below + at), bottom), top);
        vec_store_low_u8(gradient + at, vec_add_scalar(bound, cap)); /* modulo 256, as the specification has it */
    }
    for (int32_t x = 1; x < width - 1; x += 16) {
        const int32_t at = inner_at(x, width, 16);
        vec_store_u8(intensity + at, vec_load_u8(row + at));
    }
    gradient[0] = gradient[width - 1] = intensity[0] = intensity[width - 1] = (uint8_t)(cap & 0xFF);
}

static inline void put_range(uint8_t *out, vec v, int reverse)
{
    if (reverse)
        vec_store_reversed_u8(out, v);
    else
        vec_store_u8(out, v);
}

void STAD_TIER(stad_range_row)(const uint8_t *plane, int32_t width, int reverse, uint8_t *out)
{
    if (width < 16 + 2) {
        stad_range_row_c(plane, width, reverse, out);
        return;
    }
    for (int32_t x = 1; x < width - 1; x += 16) {
        const int32_t at = inner_at(x, width, 16), to = reverse ? width - at - 16 : at;
        const vec here = vec_load_u8(plane + at);
        const vec before = vec_mean_u8(here, vec_load_u8(plane + at - 1)), after = vec_mean_u8(here, vec_load_u8(plane + at + 1));
        put_range(out + to, here, reverse);
        put_range(out + width + to, vec_min_u8(here, vec_min_u8(before, after)), reverse);
        put_range(out + 2 * width + to, vec_max_u8(here, vec_max_u8(before, after)), reverse);
    }
    range_edge(plane, 1, width, out + (reverse ? width - 1 : 0));
    range_edge(plane + width - 1, -1, width, out + (reverse ? 0 : width - 1));
}

typedef struct triple {
    vec low, mid, high;
} triple;

static inline triple sorted_at(const int16_t *above, const int16_t *row, const int16_t *below, int32_t x)
{
    const vec a = vec_load(above + x), b = vec_load(row + x), c = vec_load(below + x);
    const vec low = vec_min(a, b), high = vec_max(a, b);
    triple t = {vec_min(low, c), vec_max(low, vec_min(high, c)), vec_max(high, c)};
    return t;
}

static inline vec median_of(vec a, vec b, vec c)
{
    return vec_max(vec_min(a, b), vec_min(vec_max(a, b), c));
}

void STAD_TIER(stad_median_row)(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out)
{
    if (width < 8 + 2) {
        stad_median_row_c(above, row, below, width, out);
        return;
    }
    for (int32_t x = 1; x < width - 1; x += 8) {
        const int32_t at = inner_at(x, width, 8);
        const triple l = sorted_at(above, row, below, at - 1), m = sorted_at(above, row, below, at);
        const triple r = sorted_at(above, row, below, at + 1);
        const vec low = vec_max(l.low, vec_max(m.low, r.low)), high = vec_min(l.high, vec_min(m.high, r.high));
        vec_store(out + at, median_of(low, median_of(l.mid, m.mid, r.mid), high));
    }
    out[0] = median_edge(above, row, below, 0, 1);
    out[width - 1] = median_edge(above, row, below, width - 1, -1);
}
