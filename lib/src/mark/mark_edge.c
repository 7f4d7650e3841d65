/* SPDX-License-Identifier: MIT
 * image -> [mark/mark_edge.c] -> decode, refine - the grey image between pixels, and a straight edge in it.
 *
 * Along the side at most 64 normals, the ends left out. On each the image is sampled every half pixel; the edge is where the
 * gradient from dark inside to light outside has its centre, weighted by its square. */
#include "mark/mark_work.h"

#include "base/arith.h"

enum { NORMALS = 64 };

int32_t stad_mark_sample_q8(const mark_work *w, int32_t x_q8, int32_t y_q8)
{
    const int32_t x = clamp_i32(x_q8, 0, (w->width - 1) * 256), y = clamp_i32(y_q8, 0, (w->height - 1) * 256);
    const int32_t x0 = x / 256, y0 = y / 256, fx = x % 256, fy = y % 256;
    const uint8_t *p = w->pix + y0 * w->row_stride + x0 * w->pixel_stride;
    const ptrdiff_t right = x0 + 1 < w->width ? w->pixel_stride : 0, below = y0 + 1 < w->height ? w->row_stride : 0;
    const int32_t top = p[0] * (256 - fx) + p[right] * fx, bottom = p[below] * (256 - fx) + p[below + right] * fx;
    return (top * (256 - fy) + bottom * fy) / 256;
}

/* Where on the normal (nx, ny) through a point the edge is, Q8 px outwards. 1, or 0 when there is none. */
static int edge_offset_q8(const mark_work *w, stad_corner p, int32_t nx_q14, int32_t ny_q14, int32_t reach, int32_t *offset)
{
    int64_t weight = 0, sum = 0; /* gradients are Q4, below 2^12; 11 squares below 2^28 */
    int32_t last = 0, last_but_one = 0;
    for (int32_t i = 0; i <= 2 * reach + 2; i++) {
        const int32_t t_q8 = (i - reach - 1) * 128;
        const int32_t x_q8 = p.x_q8 + nx_q14 * t_q8 / 16384, y_q8 = p.y_q8 + ny_q14 * t_q8 / 16384;
        const int32_t sample = stad_mark_sample_q8(w, x_q8, y_q8) / 16;
        const int32_t gradient = i < 2 ? 0 : max_i32(sample - last_but_one, 0); /* about the sample before this one */
        weight += gradient * gradient;
        sum += (int64_t)gradient * gradient * (t_q8 - 128);
        last_but_one = last;
        last = sample;
    }
    if (weight < 16 * 16 * 16)
        return 0;
    const int32_t most = 128 * (MARK_MAX_REACH + 2); /* a mean of t_q8 - 128: nothing is cut */
    *offset = clamp_i64(sum / weight, -most, most);
    return 1;
}

int stad_mark_edge_line(const mark_work *w, stad_corner a, stad_corner b, int32_t reach, mark_line *line)
{
    int32_t ux_q14, uy_q14;
    const int32_t dx = b.x_q8 - a.x_q8, dy = b.y_q8 - a.y_q8;
    const int32_t length_q8 = stad_mark_unit_q14(dx, dy, &ux_q14, &uy_q14);
    const int32_t count = clamp_i32(length_q8 / 256, 8, NORMALS);
    const int32_t skip = max_i32(1, count / 16);
    mark_moments m;
    stad_mark_moments_first(&m, a);
    for (int32_t i = skip; i < count - skip; i++) {
        /* Less than 2^20 * 2^7 = 2^27. */
        const stad_corner p = {a.x_q8 + dx * (2 * i + 1) / (2 * count), a.y_q8 + dy * (2 * i + 1) / (2 * count)};
        int32_t offset_q8 = 0;
        if (edge_offset_q8(w, p, uy_q14, -ux_q14, reach, &offset_q8))
            stad_mark_moments_add(&m, p.x_q8 + uy_q14 * offset_q8 / 16384, p.y_q8 - ux_q14 * offset_q8 / 16384);
    }
    return m.n * 2 >= count - 2 * skip && stad_mark_line_fit(&m, line);
}
