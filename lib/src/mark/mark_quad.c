/* SPDX-License-Identifier: MIT
 * contour -> [mark/mark_quad.c] -> cells - four corners and four straight sides, or no quadrilateral.
 *
 * Corners: the point farthest from the centroid, the point farthest from that, and the extremes on both sides of this
 * diagonal. They only divide the contour; where the lines along its four parts meet are the corners of the quadrilateral. */
#include "mark/mark_work.h"

#include "base/arith.h"

enum { MIN_SIDE_POINTS = 6 };

/* Index of the contour point farthest from a point given in contour units. */
static int32_t farthest(const mark_work *w, int32_t x, int32_t y)
{
    int32_t best = 0, best_distance = -1;
    for (int32_t i = 0; i < w->contour_count; i++) {
        const int32_t dx = w->contour[i].x - x, dy = w->contour[i].y - y;
        const int32_t distance = dx * dx + dy * dy; /* < 2^23 */
        if (distance > best_distance) {
            best_distance = distance;
            best = i;
        }
    }
    return best;
}

/* The points farthest to the left and to the right of the way from point i to point k. */
static void extremes(const mark_work *w, int32_t i, int32_t k, int32_t *left, int32_t *right)
{
    const mark_point a = w->contour[i];
    const int32_t dx = w->contour[k].x - a.x, dy = w->contour[k].y - a.y;
    int32_t low = 0, high = 0;
    *left = *right = i;
    for (int32_t n = 0; n < w->contour_count; n++) {
        const int32_t side = dx * (w->contour[n].y - a.y) - dy * (w->contour[n].x - a.x);
        if (side < low) {
            low = side;
            *left = n;
        }
        if (side > high) {
            high = side;
            *right = n;
        }
    }
}

static void sort4(int32_t *v)
{
    for (int i = 1; i < 4; i++)
        for (int k = i; k > 0 && v[k] < v[k - 1]; k--) {
            const int32_t swap = v[k];
            v[k] = v[k - 1];
            v[k - 1] = swap;
        }
}

static int find_corners(const mark_work *w, int32_t *corner)
{
    int32_t x = 0, y = 0;
    for (int32_t i = 0; i < w->contour_count; i++) {
        x += w->contour[i].x; /* < 12288 * 2048 < 2^25 */
        y += w->contour[i].y;
    }
    corner[0] = farthest(w, x / w->contour_count, y / w->contour_count);
    corner[1] = farthest(w, w->contour[corner[0]].x, w->contour[corner[0]].y);
    extremes(w, corner[0], corner[1], &corner[2], &corner[3]);
    sort4(corner);
    for (int i = 0; i < 4; i++) {
        const int32_t next = i < 3 ? corner[i + 1] : corner[0] + w->contour_count;
        if (next - corner[i] < MIN_SIDE_POINTS)
            return 0;
    }
    return 1;
}

/* Twice the area of the quadrilateral, px; positive when it is clockwise on the screen. */
static int32_t quad_area2(const mark_quad *quad)
{
    const stad_corner *p = quad->p;
    const int64_t ax = p[2].x_q8 - p[0].x_q8, ay = p[2].y_q8 - p[0].y_q8;
    const int64_t bx = p[3].x_q8 - p[1].x_q8, by = p[3].y_q8 - p[1].y_q8;
    return (int32_t)((ax * by - ay * bx) / 65536);
}

int stad_mark_quad(const mark_work *w, int32_t area2, mark_quad *quad)
{
    int32_t corner[5];
    mark_line side[4];
    if (!find_corners(w, corner))
        return 0;
    corner[4] = corner[0] + w->contour_count;
    for (int i = 0; i < 4; i++)
        if (!stad_mark_side(w, corner[i], corner[i + 1], &side[i]))
            return 0;
    for (int i = 0; i < 4; i++) {
        stad_corner p;
        if (!stad_mark_line_meet(&side[(i + 3) % 4], &side[i], STAD_MARK_MAX_SIZE * 16, &p))
            return 0;
        /* Contour units to pixel centres: 16 steps a pixel, half a pixel off. */
        quad->p[i].x_q8 = p.x_q8 * 16 - 128;
        quad->p[i].y_q8 = p.y_q8 * 16 - 128;
    }
    const int32_t difference = quad_area2(quad) - area2;
    return abs_i32(difference) <= area2 / 8;
}
