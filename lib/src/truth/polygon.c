/* SPDX-License-Identifier: MIT
 * [truth/polygon.c] -> truth rows - convex polygons row by row, and the hull of a few points. */
#include "truth/polygon.h"

#include "base/arith.h"

int64_t stad_polygon_turn(stad_corner a, stad_corner b, stad_corner c)
{
    return (int64_t)(b.x_q8 - a.x_q8) * (c.y_q8 - a.y_q8) - (int64_t)(b.y_q8 - a.y_q8) * (c.x_q8 - a.x_q8);
}

int stad_polygon_cut(const stad_polygon *p, int32_t y, int32_t *low_q8, int32_t *high_q8)
{
    const int32_t y_q8 = y * 256;
    *low_q8 = INT32_MAX;
    *high_q8 = INT32_MIN;
    for (int32_t i = 0; i < p->count; i++) {
        const stad_corner a = p->p[i], b = p->p[(i + 1) % p->count];
        if (y_q8 < min_i32(a.y_q8, b.y_q8) || y_q8 > max_i32(a.y_q8, b.y_q8))
            continue;
        int32_t left = min_i32(a.x_q8, b.x_q8), right = max_i32(a.x_q8, b.x_q8);
        if (a.y_q8 != b.y_q8) { /* between both, so nothing is cut; it says so to the analysis */
            const int64_t along = (int64_t)(b.x_q8 - a.x_q8) * (y_q8 - a.y_q8) / (b.y_q8 - a.y_q8);
            left = right = clamp_i64(a.x_q8 + along, left, right);
        }
        *low_q8 = min_i32(*low_q8, left);
        *high_q8 = max_i32(*high_q8, right);
    }
    return *low_q8 <= *high_q8 ? 1 : 0;
}

/* v / 256 rounded up, or down, for positions above -2^21. */
static int32_t up(int32_t v_q8)
{
    return (v_q8 + (1 << 24) + 255) / 256 - (1 << 16);
}

static int32_t down(int32_t v_q8)
{
    return (v_q8 + (1 << 24)) / 256 - (1 << 16);
}

int stad_polygon_inner(const stad_polygon *p, int32_t y, int32_t margin, int32_t *first, int32_t *last)
{
    int32_t low, high;
    *first = INT32_MIN;
    *last = INT32_MAX;
    for (int32_t step = -margin; step <= margin; step += max_i32(margin, 1)) {
        if (!stad_polygon_cut(p, y + step, &low, &high))
            return 0;
        const int32_t inset = step == 0 ? margin : 0;
        *first = max_i32(*first, up(low) + inset);
        *last = min_i32(*last, down(high) - inset);
    }
    return *first <= *last ? 1 : 0;
}

int stad_polygon_outer(const stad_polygon *p, int32_t y, int32_t margin, int32_t *first, int32_t *last)
{
    int32_t low, high;
    *first = INT32_MAX;
    *last = INT32_MIN;
    for (int32_t step = -margin; step <= margin; step++)
        if (stad_polygon_cut(p, y + step, &low, &high)) {
            *first = min_i32(*first, down(low) - margin);
            *last = max_i32(*last, up(high) + margin);
        }
    return *first <= *last ? 1 : 0;
}

static void sort_points(stad_corner *p, int32_t count)
{
    for (int32_t i = 1; i < count; i++)
        for (int32_t k = i; k > 0; k--) {
            const stad_corner a = p[k - 1], b = p[k];
            if (a.x_q8 < b.x_q8 || (a.x_q8 == b.x_q8 && a.y_q8 <= b.y_q8))
                break;
            p[k - 1] = b;
            p[k] = a;
        }
}

/* Appends a point to a chain that may only turn right, dropping what it makes superfluous. 0 when the chain is full. */
static int append(stad_polygon *hull, int32_t base, stad_corner p)
{
    while (hull->count - base >= 2 && stad_polygon_turn(hull->p[hull->count - 2], hull->p[hull->count - 1], p) <= 0)
        hull->count--;
    if (hull->count >= STAD_POLYGON_MAX)
        return 0;
    hull->p[hull->count++] = p;
    return 1;
}

int stad_polygon_hull(stad_corner *points, int32_t count, stad_polygon *hull)
{
    sort_points(points, count);
    hull->count = 0;
    for (int32_t i = 0; i < count; i++)
        if (!append(hull, 0, points[i]))
            return 0;
    const int32_t upper = hull->count - 1;
    for (int32_t i = count - 2; i > 0; i--)
        if (!append(hull, upper, points[i]))
            return 0;
    /* Closing: the last point may lie on the way back to the first. */
    while (hull->count - upper >= 2 && stad_polygon_turn(hull->p[hull->count - 2], hull->p[hull->count - 1], hull->p[0]) <= 0)
        hull->count--;
    return hull->count >= 3;
}
