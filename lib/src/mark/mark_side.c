/* SPDX-License-Identifier: MIT
 * contour -> [mark/mark_side.c] -> quad - one side of a quadrilateral.
 *
 * A line through the middles of the cracks, in Q4, without the outer eighths, where the corner is rounded. Crooked is a mean
 * distance above 1 px + length / 128. */
#include "mark/mark_work.h"

#include "base/arith.h"

/* The middle of crack i, Q4. */
static stad_corner crack_q4(const mark_work *w, int32_t i)
{
    const mark_point a = w->contour[i % w->contour_count], b = w->contour[(i + 1) % w->contour_count];
    const stad_corner middle = {(a.x + b.x) * 8, (a.y + b.y) * 8};
    return middle;
}

int stad_mark_side(const mark_work *w, int32_t i, int32_t k, mark_line *line)
{
    const int32_t skip = (k - i) / 8, first = i + skip, last = k - skip;
    mark_moments m;
    stad_mark_moments_first(&m, crack_q4(w, first));
    for (int32_t n = first; n < last; n++) {
        const stad_corner p = crack_q4(w, n);
        stad_mark_moments_add(&m, p.x_q8, p.y_q8);
    }
    if (!stad_mark_line_fit(&m, line))
        return 0;
    int32_t sum_q4 = 0; /* < 2^13 points * 2^15 */
    for (int32_t n = first; n < last; n++) {
        const stad_corner p = crack_q4(w, n);
        sum_q4 += abs_i32(stad_mark_line_distance_q8(line, p.x_q8, p.y_q8));
    }
    return sum_q4 <= (last - first) * (16 + (k - i) / 8);
}
