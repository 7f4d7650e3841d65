/* SPDX-License-Identifier: MIT
 * pixels -> [PREFILTER] -> range -> cost
 * kernel/prefilter_row.c - the clipped horizontal Sobel gradient and the intensity of one row. */
#include "kernel/kernel.h"
#include "base/arith.h"

static inline void gradient_row(const uint8_t *restrict above, const uint8_t *restrict row, const uint8_t *restrict below,
                                int32_t width, int32_t step, int32_t cap, uint8_t *restrict gradient)
{
    gradient[0] = gradient[width - 1] = (uint8_t)(cap & 0xFF);
    /*@ loop invariant 1 <= x && (x < width || x == 1);
        loop assigns x, gradient[0 .. width - 1]; loop variant width - x; */
    for (int32_t x = 1; x < width - 1; x++) {
        const int32_t left = (x - 1) * step, right = (x + 1) * step;
        const int32_t g = 2 * (row[right] - row[left]) + above[right] - above[left] + below[right] - below[left];
        gradient[x] = (uint8_t)((clamp_i32(g, -cap, cap) + cap) & 0xFF); /* |g| <= 1020; cap > 127 wraps: SPEC 2 */
    }
}

static void intensity_row(const uint8_t *restrict row, int32_t width, int32_t step, int32_t cap, uint8_t *restrict intensity)
{
    intensity[0] = intensity[width - 1] = (uint8_t)(cap & 0xFF); /* not the pixels: SPEC 2, a quirk that must be kept */
    /*@ loop invariant 1 <= x && (x < width || x == 1);
        loop assigns x, intensity[0 .. width - 1]; loop variant width - x; */
    for (int32_t x = 1; x < width - 1; x++)
        intensity[x] = row[x * step];
}

/* One channel alone, of samples that adjoin, is a loop of its own: that one vectorises. */
void stad_prefilter_row_c(const uint8_t *above, const uint8_t *row, const uint8_t *below, int32_t width, int32_t channels,
                          int32_t cap, uint8_t *planes)
{
    STAD_ASSERT(width > 0 && (channels == 1 || channels == 3) && cap > 0 && cap <= 32767);
    /*@ loop invariant 0 <= c <= channels; loop assigns c, planes[0 .. 2 * channels * width - 1]; loop variant channels - c; */
    for (int32_t c = 0; c < channels; c++) {
        uint8_t *gradient = planes + (ptrdiff_t)c * width;
        if (channels == 1)
            gradient_row(above, row, below, width, 1, cap, gradient);
        else
            gradient_row(above + c, row + c, below + c, width, channels, cap, gradient);
        intensity_row(row + c, width, channels, cap, gradient + (ptrdiff_t)channels * width);
    }
}
