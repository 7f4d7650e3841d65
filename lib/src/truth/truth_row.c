/* SPDX-License-Identifier: MIT
 * layers -> [truth/truth_row.c] -> score - one row of truth and labels.
 *
 * Layers are drawn in order; a plane covers what is farther, a mask covers all. Then every covered pixel is carried into the
 * right view: there a layer hides it when the same right position sees a point of that layer that is nearer. On plane j the
 * left position u of right position xr satisfies u - d_j(u) = xr, and that point is nearer when u > x: no division is needed,
 * only (1 - a_j) u = xr + b_j y + c_j compared with (1 - a_j) x. */
#include "stad/truth.h"

#include "base/arith.h"
#include "stad/score.h"
#include "truth/polygon.h"

/* Nearer by less than this hides nothing: planes that touch. */
enum { HIDING_STEP_Q16 = 1 << 15 };

/* A plane cut by one row: d = a x + c, and the right positions it covers. All Q16. */
typedef struct cut {
    int32_t a, c, right_first, right_last;
    int32_t seen;
} cut;

static int32_t line_at(const stad_truth_layer *layer, int32_t y)
{
    return layer->plane.c_q16 + layer->plane.b_q16 * y;
}

static void draw_mask(const stad_truth *t, const stad_truth_layer *layer, int32_t y, int32_t *truth, uint8_t *label)
{
    int32_t first, last;
    if (!stad_polygon_outer(&layer->where, y, t->margin, &first, &last))
        return;
    for (int32_t x = max_i32(first, 0); x <= min_i32(last, t->width - 1); x++) {
        truth[x] = STAD_TRUTH_NONE;
        label[x] = STAD_LABEL_IGNORED;
    }
}

/* The rim of a plane hides what is farther, but is not scored itself. */
static void draw_plane(const stad_truth *t, const stad_truth_layer *layer, int32_t y, int32_t *truth, uint8_t *label)
{
    int32_t first, last, inner_first, inner_last;
    if (!stad_polygon_outer(&layer->where, y, t->margin, &first, &last))
        return;
    if (!stad_polygon_inner(&layer->where, y, t->margin, &inner_first, &inner_last))
        inner_first = inner_last = -1;
    const int32_t c = line_at(layer, y);
    for (int32_t x = max_i32(first, 0); x <= min_i32(last, t->width - 1); x++) {
        const int32_t d = c + layer->plane.a_q16 * x;
        if (d < truth[x])
            continue;
        truth[x] = d;
        label[x] = x >= inner_first && x <= inner_last ? STAD_LABEL_VISIBLE : STAD_LABEL_IGNORED;
    }
}

static cut cut_plane(const stad_truth_layer *layer, int32_t y)
{
    cut k = {layer->plane.a_q16, line_at(layer, y), 0, 0, 0};
    int32_t low_q8, high_q8;
    if (layer->is_mask || !stad_polygon_cut(&layer->where, y, &low_q8, &high_q8))
        return k;
    /* |x| < 2^21 in Q8, |a| < 2^16: the products are below 2^37. */
    const int64_t low = (int64_t)(65536 - k.a) * low_q8 / 256 - k.c, high = (int64_t)(65536 - k.a) * high_q8 / 256 - k.c;
    k.right_first = (int32_t)low;
    k.right_last = (int32_t)high;
    k.seen = 1;
    return k;
}

/* Labels the pixels that one plane hides from the right camera. |a x|, |d| < 2^27, right positions < 2^29. */
static void hide_behind(const stad_truth *t, const cut *k, const int32_t *truth, uint8_t *label)
{
    for (int32_t x = 0; x < t->width; x++) {
        if (label[x] != STAD_LABEL_VISIBLE)
            continue;
        const int32_t right = x * 65536 - truth[x];
        if (right < k->right_first || right > k->right_last)
            continue;
        if (right > (65536 - k->a) * x + HIDING_STEP_Q16 - k->c)
            label[x] = STAD_LABEL_OCCLUDED;
    }
}

/* Outside the searched columns nothing is scored; outside the right image nothing is seen. */
static void clip(const stad_truth *t, const int32_t *truth, uint8_t *label)
{
    const int32_t first = max_i32(t->min_disparity + t->num_disparities, 0);
    const int32_t last = t->width - 1 + min_i32(t->min_disparity, 0);
    for (int32_t x = 0; x < t->width; x++) {
        if (x < first || x > last)
            label[x] = STAD_LABEL_IGNORED;
        if (label[x] != STAD_LABEL_VISIBLE)
            continue;
        const int32_t right = x * 65536 - truth[x];
        if (right < 0 || right > (t->width - 1) * 65536)
            label[x] = STAD_LABEL_OCCLUDED;
    }
}

int stad_truth_row(const stad_truth *t, int y, int width, int32_t *truth_q16_row, uint8_t *label_row)
{
    STAD_ASSERT(t && truth_q16_row && label_row && t->count <= STAD_TRUTH_LAYERS);
    if (width != t->width || y < 0 || y >= t->height)
        return STAD_E_SIZE;
    for (int32_t x = 0; x < width; x++) {
        truth_q16_row[x] = STAD_TRUTH_NONE;
        label_row[x] = STAD_LABEL_IGNORED;
    }
    for (int32_t i = 0; i < t->count; i++) {
        const stad_truth_layer *layer = &t->layer[i];
        if (layer->is_mask)
            draw_mask(t, layer, y, truth_q16_row, label_row);
        else
            draw_plane(t, layer, y, truth_q16_row, label_row);
    }
    clip(t, truth_q16_row, label_row);
    for (int32_t i = 0; i < t->count; i++) {
        const cut k = cut_plane(&t->layer[i], y);
        if (k.seen)
            hide_behind(t, &k, truth_q16_row, label_row);
    }
    return STAD_OK;
}
