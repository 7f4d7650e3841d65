/* SPDX-License-Identifier: MIT
 * planes, masks -> [truth/truth.c] -> truth rows - the list of layers: filling, checking, cropping it. */
#include "stad/truth.h"

#include <stddef.h>

#include "base/arith.h"
#include "truth/polygon.h"

enum { MAX_OUTSIDE_PX = 4096, MAX_MARGIN = 16, MAX_DISPARITY_PX = 2048 };

int stad_truth_init(stad_truth *t, int width, int height, int min_disparity, int num_disparities, int margin)
{
    if (width < 16 || width > STAD_MARK_MAX_SIZE || height < 16 || height > STAD_MARK_MAX_SIZE)
        return STAD_E_PARAM;
    if (min_disparity < -2048 || min_disparity > 2048 || num_disparities < 1 || num_disparities > 2048 || margin < 0 ||
        margin > MAX_MARGIN)
        return STAD_E_PARAM;
    t->width = (int16_t)width;
    t->height = (int16_t)height;
    t->min_disparity = (int16_t)min_disparity;
    t->num_disparities = (int16_t)num_disparities;
    t->margin = (int16_t)margin;
    t->count = 0;
    return STAD_OK;
}

static int corner_ok(const stad_truth *t, const stad_corner *p)
{
    const int32_t limit = MAX_OUTSIDE_PX * 256;
    return p->x_q8 >= -limit && p->x_q8 <= limit + t->width * 256 && p->y_q8 >= -limit && p->y_q8 <= limit + t->height * 256;
}

/* Corners in range, all of them before any two are subtracted, and turning one way only. */
static int polygon_ok(const stad_truth *t, const stad_polygon *where)
{
    const int32_t n = where->count;
    int left = 0, right = 0;
    if (n < 3 || n > STAD_POLYGON_MAX)
        return 0;
    for (int32_t i = 0; i < n; i++)
        if (!corner_ok(t, &where->p[i]))
            return 0;
    for (int32_t i = 0; i < n; i++) {
        const int64_t turn = stad_polygon_turn(where->p[i], where->p[(i + 1) % n], where->p[(i + 2) % n]);
        left |= turn < 0;
        right |= turn > 0;
    }
    return left != right;
}

/* The plane's disparity at the polygon's corners is in range; so it is within. */
static int plane_ok(const stad_plane *plane, const stad_polygon *where)
{
    if (plane->a_q16 <= -65536 || plane->a_q16 >= 65536 || plane->b_q16 <= -65536 || plane->b_q16 >= 65536)
        return 0;
    for (int32_t i = 0; i < where->count; i++) {
        const int64_t slope = (int64_t)plane->a_q16 * where->p[i].x_q8 + (int64_t)plane->b_q16 * where->p[i].y_q8;
        const int64_t d_q16 = slope / 256 + plane->c_q16;
        if (d_q16 >= (int64_t)MAX_DISPARITY_PX << 16 || d_q16 <= -((int64_t)MAX_DISPARITY_PX << 16))
            return 0;
    }
    return 1;
}

/* The next layer, not yet counted; NULL when it is refused, and *status says why. */
static stad_truth_layer *next_layer(stad_truth *t, const stad_polygon *where, int *status)
{
    const stad_plane none = {0, 0, 0};
    *status = !polygon_ok(t, where) ? STAD_E_PARAM : t->count >= STAD_TRUTH_LAYERS ? STAD_E_LIMIT : STAD_OK;
    if (*status != STAD_OK)
        return NULL;
    stad_truth_layer *layer = &t->layer[t->count];
    layer->where = *where;
    layer->plane = none;
    return layer;
}

int stad_truth_add_plane(stad_truth *t, const stad_plane *plane, const stad_polygon *where)
{
    int status;
    stad_truth_layer *layer = next_layer(t, where, &status);
    if (!layer)
        return status;
    if (!plane_ok(plane, where))
        return STAD_E_PARAM;
    layer->plane = *plane;
    layer->is_mask = 0;
    t->count++;
    return STAD_OK;
}

int stad_truth_add_mask(stad_truth *t, const stad_polygon *where)
{
    int status;
    stad_truth_layer *layer = next_layer(t, where, &status);
    if (!layer)
        return status;
    layer->is_mask = 1;
    t->count++;
    return STAD_OK;
}

/* Columns in which the matcher searches its whole range: first .. last. */
static void scored_columns(const stad_truth *t, int32_t *first, int32_t *last)
{
    *first = max_i32(t->min_disparity + t->num_disparities, 0);
    *last = t->width - 1 + min_i32(t->min_disparity, 0);
}

/* Joins the box of a layer within the frame to low..high. */
static void extend(const stad_truth *t, const stad_polygon *where, stad_corner *low, stad_corner *high)
{
    for (int32_t i = 0; i < where->count; i++) {
        const int32_t x = clamp_i32(where->p[i].x_q8, 0, (t->width - 1) * 256);
        const int32_t y = clamp_i32(where->p[i].y_q8, 0, (t->height - 1) * 256);
        low->x_q8 = min_i32(low->x_q8, x);
        low->y_q8 = min_i32(low->y_q8, y);
        high->x_q8 = max_i32(high->x_q8, x);
        high->y_q8 = max_i32(high->y_q8, y);
    }
}

stad_box stad_truth_box(const stad_truth *t)
{
    stad_corner low = {INT32_MAX, INT32_MAX}, high = {-1, -1};
    stad_box box = {0, 0, 0, 0};
    int32_t first, last;
    for (int32_t i = 0; i < t->count; i++)
        if (!t->layer[i].is_mask)
            extend(t, &t->layer[i].where, &low, &high);
    scored_columns(t, &first, &last);
    const int32_t x0 = max_i32(low.x_q8 / 256, first), x1 = min_i32((high.x_q8 + 255) / 256, last);
    if (high.x_q8 < 0 || x1 < x0)
        return box;
    const int32_t y0 = low.y_q8 / 256, y1 = min_i32((high.y_q8 + 255) / 256, t->height - 1);
    box.x = (int16_t)(x0 - first);
    box.y = (int16_t)y0;
    box.width = (int16_t)(x1 - min_i32(t->min_disparity, 0) - box.x + 1);
    box.height = (int16_t)(y1 - y0 + 1);
    return box;
}

int stad_truth_crop(stad_truth *t, const stad_box *box)
{
    if (box->x < 0 || box->y < 0 || box->width < 1 || box->height < 1 || box->x + box->width > t->width ||
        box->y + box->height > t->height)
        return STAD_E_PARAM;
    for (int32_t i = 0; i < t->count; i++) {
        stad_truth_layer *layer = &t->layer[i];
        /* The disparity at the new origin: in range of int32 as the origin is in the frame, |a|, |b| < 1, |c| < 2^30. */
        layer->plane.c_q16 += layer->plane.a_q16 * box->x + layer->plane.b_q16 * box->y;
        for (int32_t k = 0; k < layer->where.count; k++) {
            layer->where.p[k].x_q8 -= box->x * 256;
            layer->where.p[k].y_q8 -= box->y * 256;
        }
    }
    t->width = box->width;
    t->height = box->height;
    return STAD_OK;
}

int32_t stad_truth_pixels(const stad_truth *t)
{
    int32_t total = 0, first, last;
    scored_columns(t, &first, &last);
    for (int32_t y = 0; y < t->height; y++) {
        int32_t from = t->width, to = -1, x0, x1;
        for (int32_t i = 0; i < t->count; i++) {
            if (t->layer[i].is_mask || !stad_polygon_inner(&t->layer[i].where, y, t->margin, &x0, &x1))
                continue;
            from = min_i32(from, x0);
            to = max_i32(to, x1);
        }
        total += max_i32(min_i32(to, last) - max_i32(from, first) + 1, 0);
    }
    return total;
}
