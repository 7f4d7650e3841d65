/* SPDX-License-Identifier: MIT
 * request -> match -> score -> [EVALUATE] -> cost        calib/evaluate.c - one evaluation: the crop of a held pair,
 * row by row
 *
 * Optional: a firmware with a matcher of its own, on another core or in hardware, needs only the two calls at the
 * top. */
#include "calib/calib_parts.h"

#include <string.h>
#include "base/arith.h"

int stad_calib_truth_row(const stad_calib *c, const stad_request *r, int y, int32_t *truth_q16_row, uint8_t *label_row)
{
    const stad_calib_pose *pose = &c->pose[r->hold & 1];
    return stad_truth_row(&pose->truth, y, pose->box.width, truth_q16_row, label_row);
}

void stad_calib_score_config(const stad_calib *c, const stad_request *r, stad_score_config *s)
{
    stad_score_config_init(s, c->config.cost, r->params.min_disparity, r->params.num_disparities);
    s->threshold_q16 = c->config.threshold_q16;
}

size_t stad_calib_evaluate_bytes(const stad_geometry *geometry)
{
    size_t match = stad_match_bytes(geometry);
    return match > 0 ? match + STAD_CALIB_ROWS_BYTES(geometry->width, geometry->channels) : 0;
}

typedef struct rows {
    int32_t *truth_q16;
    int16_t *disp_q4;
    uint8_t *left, *right, *label;
} rows;

/* Widest elements first, so that each array is aligned whatever the width. */
static rows carve(const stad_geometry *g, uint8_t *work)
{
    rows r;
    const size_t width = (size_t)g->width, channels = (size_t)g->channels, row_bytes = channels * width;
    r.truth_q16 = (int32_t *)(void *)work;
    r.disp_q4 = (int16_t *)(void *)(work + 4 * width);
    r.left = work + 6 * width;
    r.right = r.left + row_bytes;
    r.label = r.right + row_bytes;
    return r;
}

static void pack_row(const stad_image *image, int y, uint8_t *out)
{
    const uint8_t *p = image->pix + y * image->row_stride;
    for (int32_t x = 0; x < image->width; x++, p += image->pixel_stride)
        for (int32_t k = 0; k < image->channels; k++)
            *out++ = p[k];
}

static int begin(const stad_calib *c, const stad_request *r, stad_evaluator *e, void *work, size_t bytes)
{
    stad_score_config config;
    stad_geometry g = c->config.geometry;
    g.width = r->box.width;
    g.height = r->box.height;
    stad_calib_score_config(c, r, &config);
    return stad_match_init(&e->match, &g, work, bytes) == STAD_OK && stad_match_begin(&e->match, &r->params) == STAD_OK &&
           stad_score_begin(&e->score, &config) == STAD_OK;
}

static int drain(const stad_calib *c, const stad_request *r, stad_evaluator *e, const rows *row)
{
    int y;
    while ((y = stad_match_pull(&e->match, row->disp_q4)) >= 0) {
        if (stad_calib_truth_row(c, r, y, row->truth_q16, row->label) != STAD_OK)
            return STAD_E_SIZE;
        stad_score_row(&e->score, y, row->disp_q4, row->truth_q16, row->label, r->box.width);
    }
    return y;
}

static int corrects(const stad_rig *r)
{
    return r->a_q16 != 0 || r->b_q24 != 0 || r->c_q24 != 0;
}

static int feed(const stad_request *r, stad_evaluator *e, const rows *row, const stad_image *left, const stad_image *right, int y)
{
    ptrdiff_t skip = (ptrdiff_t)r->box.x * left->channels;
    pack_row(left, r->box.y + y, row->left);
    if (!corrects(&r->rig))
        pack_row(right, r->box.y + y, row->right);
    else if (stad_rig_row(&r->rig, right, r->box.y + y, row->right) != STAD_OK)
        return STAD_E_SIZE;
    return stad_match_push(&e->match, row->left + skip, row->right + skip);
}

int32_t stad_calib_evaluate(const stad_calib *c, const stad_request *r, stad_evaluator *e, const stad_image *left,
                            const stad_image *right, void *work, size_t work_bytes)
{
    STAD_ASSERT(c && r && e && left && right);
    const stad_geometry *g = &c->config.geometry;
    size_t rows_bytes = STAD_CALIB_ROWS_BYTES(g->width, g->channels);
    if (r->want != STAD_WANT_MATCH || !stad_calib_size_fits(c, left) || !stad_calib_size_fits(c, right))
        return STAD_COST_FAILED;
    if (!work || work_bytes < rows_bytes || (uintptr_t)work % STAD_ALIGN != 0)
        return STAD_COST_FAILED;
    rows row = carve(g, (uint8_t *)work);
    if (!begin(c, r, e, (uint8_t *)work + rows_bytes, work_bytes - rows_bytes))
        return STAD_COST_FAILED;
    int status = STAD_AGAIN;
    for (int y = 0; y < r->box.height && status == STAD_AGAIN; y++) {
        if (feed(r, e, &row, left, right, y) != STAD_OK)
            return STAD_COST_FAILED;
        status = drain(c, r, e, &row);
    }
    return status == STAD_E_STATE ? stad_score_end(&e->score) : STAD_COST_FAILED;
}
