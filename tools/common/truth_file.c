/* SPDX-License-Identifier: MIT
 * common/truth_file.c - ground truth as files, and which of its pixels the right camera sees. */
#include "truth_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "grid.h"
#include "picture.h"
#include "stad/score.h"
#include "whole_file.h"

/* The score takes |truth| < 4096 px: far above any disparity of a picture that is read here at all. */
#define TRUTH_PX_MAX 4096.0

void truth_free(truth_map *t)
{
    free(t->q16);
    free(t->label);
    memset(t, 0, sizeof *t);
}

static int truth_alloc(truth_map *t, int width, int height, const char *path, tool_fail *f)
{
    size_t n = (size_t)width * (size_t)height;
    t->width = width;
    t->height = height;
    t->q16 = malloc(n * sizeof *t->q16);
    t->label = malloc(n);
    if (!t->q16 || !t->label)
        return tool_fail_set(f, TOOL_FILE, "%s: not enough memory", path);
    return TOOL_OK;
}

/* Sets pixel i; zero when the value is no disparity. */
static int set_px(truth_map *t, size_t i, double px)
{
    t->q16[i] = STAD_TRUTH_NONE;
    if (!isfinite(px))
        return 1;
    if (!(fabs(px) < TRUTH_PX_MAX))
        return 0;
    t->q16[i] = (int32_t)floor(px * 65536.0 + 0.5);
    return 1;
}

static int from_grid(truth_map *t, const grid *g, int min_disparity, const char *path, tool_fail *f)
{
    size_t n = (size_t)g->width * (size_t)g->height;
    for (size_t i = 0; i < n; i++) {
        double v = g->v[i];
        if (g->integer)
            v = v <= (min_disparity - 1) * 16 ? (double)NAN : v / 16.0;
        if (!set_px(t, i, v))
            return tool_fail_set(f, TOOL_FILE, "%s: a truth of %g px at x %d, y %d is no disparity", path, v,
                                 (int)(i % (size_t)g->width), (int)(i / (size_t)g->width));
    }
    return TOOL_OK;
}

static int read_grid(truth_map *t, const char *path, int min_disparity, tool_fail *f)
{
    grid g;
    int pfm = tool_has_suffix(path, ".pfm");
    int status = pfm ? grid_read_pfm(&g, path, f) : grid_read_npy(&g, path, f);
    if (status)
        return status;
    status = truth_alloc(t, g.width, g.height, path, f);
    if (status == TOOL_OK)
        status = from_grid(t, &g, min_disparity, path, f);
    grid_free(&g);
    return status;
}

static int read_plane(truth_map *t, const char *path, double scale, tool_fail *f)
{
    uint16_t *v;
    int width, height, bits;
    int status = plane16_read(&v, &width, &height, &bits, path, f);
    if (status)
        return status;
    if (bits == 8 && !(scale > 0))
        status = tool_fail_set(f, TOOL_USAGE, "%s: truth of 8 bits; say with --truth-scale how many steps make a pixel", path);
    else
        status = truth_alloc(t, width, height, path, f);
    double per_px = scale > 0 ? scale : 256.0;
    size_t n = (size_t)width * (size_t)height;
    for (size_t i = 0; status == TOOL_OK && i < n; i++)
        if (!set_px(t, i, v[i] ? v[i] / per_px : (double)NAN))
            status =
                tool_fail_set(f, TOOL_FILE, "%s: a truth of %g px is no disparity; is --truth-scale right?", path, v[i] / per_px);
    free(v);
    return status;
}

static int label_all(truth_map *t, const char *path, tool_fail *f)
{
    int32_t *work = malloc((size_t)t->width * sizeof *work);
    if (!work)
        return tool_fail_set(f, TOOL_FILE, "%s: not enough memory", path);
    for (int y = 0; y < t->height; y++) {
        size_t row = (size_t)y * (size_t)t->width;
        stad_score_label_row(t->q16 + row, t->width, t->label + row, work);
    }
    free(work);
    return TOOL_OK;
}

int truth_has_scale(const char *path)
{
    return !tool_has_suffix(path, ".npy") && !tool_has_suffix(path, ".npz") && !tool_has_suffix(path, ".pfm");
}

int truth_read(truth_map *t, const char *path, double scale, int min_disparity, tool_fail *f)
{
    int status;
    memset(t, 0, sizeof *t);
    if (truth_has_scale(path))
        status = read_plane(t, path, scale, f);
    else
        status = read_grid(t, path, min_disparity, f);
    if (status == TOOL_OK)
        status = label_all(t, path, f);
    if (status)
        truth_free(t);
    return status;
}

int truth_mask(truth_map *t, const char *path, tool_fail *f)
{
    picture mask;
    int status = picture_read(&mask, path, PICTURE_GREY, f);
    if (status)
        return status;
    size_t n = (size_t)t->width * (size_t)t->height;
    if (mask.width != t->width || mask.height != t->height)
        status = tool_fail_set(f, TOOL_FILE, "%s: the mask is %d x %d, the truth %d x %d", path, mask.width, mask.height,
                               t->width, t->height);
    for (size_t i = 0; status == TOOL_OK && i < n; i++) {
        int hidden = mask.pix[i] == 0 || mask.pix[i] == 128;
        if (t->q16[i] == STAD_TRUTH_NONE)
            t->label[i] = STAD_LABEL_IGNORED;
        else
            t->label[i] = hidden ? STAD_LABEL_OCCLUDED : STAD_LABEL_VISIBLE;
    }
    picture_free(&mask);
    return status;
}
