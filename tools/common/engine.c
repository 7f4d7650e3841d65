/* SPDX-License-Identifier: MIT
 * common/engine.c - a matcher with memory of its own, for tools that have a heap. */
#include "engine.h"

#include <stdlib.h>
#include <string.h>

stad_geometry engine_geometry(const stad_params *p, int mode, int memory, int width, int height, int channels)
{
    stad_geometry g = {(int16_t)width, (int16_t)height,   (int16_t)channels, p->num_disparities, p->block_size,
                       p->p2,          p->pre_filter_cap, (uint8_t)mode,     (uint8_t)memory};
    return g;
}

static void *aligned(size_t bytes)
{
    void *p = NULL;
    size_t most = bytes ? bytes : 1;
    return posix_memalign(&p, STAD_ALIGN < sizeof(void *) ? sizeof(void *) : STAD_ALIGN, most) ? NULL : p;
}

int engine_open(engine *e, const stad_geometry *g, tool_fail *f)
{
    const char *culprit = NULL;
    memset(e, 0, sizeof *e);
    if (stad_geometry_check(g, &culprit) != STAD_OK)
        return tool_fail_set(f, TOOL_USAGE, "%s is outside what a matcher can be built for", culprit ? culprit : "the geometry");
    e->geometry = *g;
    e->work_bytes = stad_match_bytes(g);
    e->speckle_bytes = STAD_SPECKLE_BYTES(g->width, g->height);
    e->work = aligned(e->work_bytes);
    e->speckle = aligned(e->speckle_bytes);
    if (!e->work || !e->speckle) {
        engine_close(e);
        return tool_fail_set(f, TOOL_FILE, "not enough memory: the matcher needs %zu bytes", stad_match_bytes(g));
    }
    int status = stad_match_init(&e->match, g, e->work, e->work_bytes);
    if (status == STAD_OK)
        return TOOL_OK;
    engine_close(e);
    return tool_fail_set(f, TOOL_USAGE, "the matcher cannot be built: %s", stad_status_name(status));
}

int engine_keep(engine *e, int count, tool_fail *f)
{
    engine_share_close(&e->share);
    return engine_share_open(&e->share, &e->geometry, count, f);
}

void engine_close(engine *e)
{
    engine_share_close(&e->share);
    free(e->work);
    free(e->speckle);
    e->work = e->speckle = NULL;
}

static int take_extras(engine *e, const engine_extras *x, int min_disparity, tool_fail *f)
{
    int status = TOOL_OK;
    int w = e->geometry.width, h = e->geometry.height;
    stad_match_options(&e->match, x && x->confidence ? STAD_MATCH_CONFIDENCE : 0);
    if (x && x->confidence)
        status = picture_alloc(x->confidence, w, h, 1, f);
    if (status == TOOL_OK && x && x->right)
        status = disparity_alloc(x->right, w, h, min_disparity, f);
    return status;
}

/* Without pictures the frame is one of winners, and all its rows are there. Rows are pulled into the last row's place and moved
 * to their own, because only the pull says which row it was. */
static int pump(engine *e, const picture *left, const picture *right, disparity *d, const engine_extras *x)
{
    size_t w = (size_t)d->width, in = left ? w * (size_t)left->channels : 0;
    int16_t *row = malloc(w * sizeof *row), *row_right = malloc(w * sizeof *row_right);
    uint8_t *sure = malloc(w);
    int status = row && row_right && sure ? STAD_OK : STAD_E_SIZE;
    for (size_t y = 0; y < (size_t)d->height && status >= 0; y++) {
        int at;
        if (left)
            status = stad_match_push(&e->match, left->pix + y * in, right->pix + y * in);
        while (status >= 0 && (at = stad_match_pull_all(&e->match, row, sure, row_right)) >= 0) {
            memcpy(d->q4 + (size_t)at * w, row, w * sizeof *row);
            if (x && x->confidence)
                memcpy(x->confidence->pix + (size_t)at * w, sure, w);
            if (x && x->right)
                memcpy(x->right->q4 + (size_t)at * w, row_right, w * sizeof *row);
        }
    }
    free(row);
    free(row_right);
    free(sure);
    return status;
}

/* A step above the range of int16 joins everything. */
static int32_t speckle_diff(const stad_params *p)
{
    return p->speckle_range > 4095 ? 65535 : p->speckle_range * 16;
}

int engine_run(engine *e, const stad_params *p, const picture *left, const picture *right, disparity *d,
               const engine_extras *extras, tool_fail *f)
{
    int status = take_extras(e, extras, p->min_disparity, f);
    if (status == TOOL_OK && !d->q4)
        status = disparity_alloc(d, e->geometry.width, e->geometry.height, p->min_disparity, f);
    if (status)
        return status;
    d->none_q4 = (int16_t)((p->min_disparity - 1) * 16);
    const stad_winners *known = engine_share_find(&e->share, p);
    if (!known)
        stad_match_keep(&e->match, engine_share_next(&e->share));
    int code = known ? stad_match_again(&e->match, p, known) : stad_match_begin(&e->match, p);
    if (code != STAD_OK) {
        const char *culprit = stad_match_culprit(&e->match);
        return tool_fail_set(f, TOOL_USAGE, "the matcher refuses %s: %s", culprit ? culprit : "the parameters",
                             stad_status_name(code));
    }
    code = pump(e, known ? NULL : left, known ? NULL : right, d, extras);
    if (code >= 0 && p->speckle_window_size > 0)
        code = stad_speckle_filter(d->q4, d->width, d->width, d->height, d->none_q4, p->speckle_window_size, speckle_diff(p),
                                   e->speckle, e->speckle_bytes);
    if (code < 0)
        return tool_fail_set(f, TOOL_FILE, "the matcher stopped: %s", stad_status_name(code));
    return TOOL_OK;
}

int engine_read_pair(picture *left, picture *right, const char *left_path, const char *right_path, int color, tool_fail *f)
{
    enum picture_want want = color ? PICTURE_BGR : PICTURE_GREY;
    memset(right, 0, sizeof *right);
    int status = picture_read(left, left_path, want, f);
    if (status == TOOL_OK)
        status = picture_read(right, right_path, want, f);
    if (status == TOOL_OK && (left->width != right->width || left->height != right->height))
        status = tool_fail_set(f, TOOL_FILE, "the images differ in size: %s is %d x %d, %s is %d x %d", left_path, left->width,
                               left->height, right_path, right->width, right->height);
    if (status) {
        picture_free(left);
        picture_free(right);
    }
    return status;
}
