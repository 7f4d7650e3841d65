/* SPDX-License-Identifier: MIT
 * image -> [mark/mark_edge.c] -> decode, refine - the grey image between pixels, and an edge across a normal.
 *
 * The image is sampled every half pixel along the normal; the edge is where the gradient from dark inside to light outside has
 * its centre, weighted by its square. */
#include "mark/mark_work.h"

#include "base/arith.h"

int32_t stad_mark_sample_q8(const mark_work *w, int32_t x_q8, int32_t y_q8)
{
    const int32_t x = clamp_i32(x_q8, 0, (w->width - 1) * 256), y = clamp_i32(y_q8, 0, (w->height - 1) * 256);
    const int32_t x0 = x / 256, y0 = y / 256, fx = x % 256, fy = y % 256;
    const uint8_t *p = w->pix + y0 * w->row_stride + x0 * w->pixel_stride;
    const ptrdiff_t right = x0 + 1 < w->width ? w->pixel_stride : 0, below = y0 + 1 < w->height ? w->row_stride : 0;
    const int32_t top = p[0] * (256 - fx) + p[right] * fx, bottom = p[below] * (256 - fx) + p[below + right] * fx;
    return (top * (256 - fy) + bottom * fy) / 256;
}

int stad_mark_edge_q8(const mark_work *w, stad_corner p, int32_t nx_q14, int32_t ny_q14, int32_t reach, int32_t *offset)
{
    int32_t sample[2 * MARK_REACH + 3];
    for (int32_t i = 0; i <= 2 * reach + 2; i++) {
        const int32_t t_q8 = (i - reach - 1) * 128;
        sample[i] = stad_mark_sample_q8(w, p.x_q8 + nx_q14 * t_q8 / 16384, p.y_q8 + ny_q14 * t_q8 / 16384) / 16;
    }
    int64_t weight = 0, sum = 0; /* gradients are Q4, below 2^12; 11 squares below 2^28 */
    for (int32_t i = 1; i <= 2 * reach + 1; i++) {
        const int32_t gradient = max_i32(sample[i + 1] - sample[i - 1], 0);
        weight += gradient * gradient;
        sum += (int64_t)gradient * gradient * (i - reach - 1) * 128;
    }
    if (weight < 16 * 16 * 16)
        return 0;
    *offset = (int32_t)(sum / weight);
    return 1;
}
