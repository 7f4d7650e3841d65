/* SPDX-License-Identifier: MIT
 * frames -> [mark/mark_find.c] -> pair - carves the workspace and drives the detector, four rows at a time. */
#include "mark/mark_work.h"

#include "base/arith.h"
#include "stad/config.h"

enum { MIN_SIDE = 10 };

void stad_mark_config_default(stad_mark_config *c)
{
    c->ids = 0xFFFFFFFFu;
    c->max_hamming = 2;
    c->min_contrast = 20;
}

size_t stad_mark_bytes(int32_t width, int32_t height)
{
    if (width < 16 || width > STAD_MARK_MAX_SIZE || height < 16 || height > STAD_MARK_MAX_SIZE)
        return 0;
    return STAD_MARK_BYTES(width, height);
}

/* Takes the next part of the workspace; the sizes are those of STAD_MARK_BYTES, in its order. */
static void *carve(uint8_t **next, size_t bytes)
{
    void *part = *next;
    *next += STAD_MARK_PAD(bytes);
    return part;
}

static void set_up(mark_work *w, const stad_image *img, const stad_mark_config *config, uint8_t *next)
{
    const size_t width = (size_t)img->width, height = (size_t)img->height;
    w->pix = img->pix + (img->channels == 3 ? 1 : 0);
    w->row_stride = img->row_stride;
    w->pixel_stride = img->pixel_stride;
    w->width = img->width;
    w->height = img->height;
    w->config = config;
    w->dark_stride = (img->width + 7) / 8;
    w->tile_columns = (img->width + 3) / 4;
    w->contour_max = 3 * (img->width + img->height);
    w->dark = carve(&next, (width + 7) / 8 * height);
    w->tiles = carve(&next, (width + 3) / 4 * 8);
    w->runs[0] = carve(&next, 12 * (width / 2 + 2));
    w->runs[1] = w->runs[0] + width / 2 + 2;
    w->components = carve(&next, 24 * (width + 8));
    w->free_slots = carve(&next, 2 * (width + 8));
    w->contour = carve(&next, 12 * (width + height));
    w->cells = carve(&next, 160);
    w->found = 0;
}

static int config_ok(const stad_mark_config *c)
{
    return c->max_hamming <= 2 && c->min_contrast >= 8 && c->min_contrast <= 128;
}

void stad_mark_examine(mark_work *w, const mark_component *c)
{
    const int32_t box_w = c->right - c->left + 1, box_h = c->bottom - c->top + 1;
    if (w->found == w->max || box_w < MIN_SIDE || box_h < MIN_SIDE || 2 * c->area < 3 * (box_w + box_h))
        return;
    if (c->left == 0 || c->top == 0 || c->right == w->width - 1) /* what reaches the last row never ends */
        return;
    int32_t area2;
    int first;
    mark_quad quad;
    stad_mark mark;
    if (!stad_mark_contour(w, c, &area2) || !stad_mark_quad(w, area2, &quad))
        return;
    if (!stad_mark_decode(w, &quad, &mark, &first) || !stad_mark_refine(w, &quad))
        return;
    for (int i = 0; i < 4; i++)
        mark.corner[i] = quad.p[(first + i) % 4];
    w->out[w->found++] = mark;
}

int stad_mark_find(const stad_image *img, const stad_mark_config *config, stad_mark *out, int max, void *work, size_t work_bytes)
{
    STAD_ASSERT(img && (out || max <= 0));
    stad_mark_config standard;
    mark_work w;
    stad_mark_config_default(&standard);
    if (config && !config_ok(config))
        return STAD_E_PARAM;
    if ((img->channels != 1 && img->channels != 3) || max < 0)
        return STAD_E_PARAM;
    const size_t need = stad_mark_bytes(img->width, img->height);
    if (need == 0 || !work || work_bytes < need || (uintptr_t)work % STAD_ALIGN)
        return STAD_E_SIZE;
    set_up(&w, img, config ? config : &standard, work);
    w.out = out;
    w.max = max;
    stad_mark_tiles_first(&w);
    stad_mark_runs_first(&w);
    for (int32_t tile_y = 0; tile_y * 4 < w.height; tile_y++) {
        stad_mark_tiles_row(&w, tile_y);
        for (int32_t y = tile_y * 4; y < min_i32(tile_y * 4 + 4, w.height); y++)
            stad_mark_runs_row(&w, y);
    }
    return w.found;
}
