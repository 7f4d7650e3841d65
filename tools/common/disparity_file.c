/* SPDX-License-Identifier: MIT
 * common/disparity_file.c - disparity maps as files: .npy, .pfm, .png. */
#include "disparity_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "grid.h"
#include "picture.h"
#include "whole_file.h"

int disparity_alloc(disparity *d, int width, int height, int min_disparity, tool_fail *f)
{
    d->width = width;
    d->height = height;
    d->none_q4 = (int16_t)((min_disparity - 1) * 16);
    d->q4 = malloc((size_t)width * (size_t)height * sizeof *d->q4);
    if (!d->q4)
        return tool_fail_set(f, TOOL_FILE, "not enough memory for a disparity map of %d x %d", width, height);
    return TOOL_OK;
}

void disparity_free(disparity *d)
{
    free(d->q4);
    memset(d, 0, sizeof *d);
}

static size_t count(const disparity *d)
{
    return (size_t)d->width * (size_t)d->height;
}

int disparity_check_path(const char *path, int min_disparity, int num_disparities, tool_fail *f)
{
    int png = tool_has_suffix(path, ".png");
    if (!png && !tool_has_suffix(path, ".npy") && !tool_has_suffix(path, ".pfm"))
        return tool_fail_set(f, TOOL_USAGE, "%s: a disparity map is written as .npy, .pfm or .png", path);
    if (png && (min_disparity < 0 || min_disparity + num_disparities > 256))
        return tool_fail_set(f, TOOL_USAGE,
                             "%s: a .png holds disparities of 0..255 px only, %d..%d were asked for; write .npy or .pfm", path,
                             min_disparity, min_disparity + num_disparities - 1);
    return tool_out_check(path, f);
}

static int write_pfm(const disparity *d, const char *path, tool_fail *f)
{
    float *px = malloc(count(d) * sizeof *px);
    if (!px)
        return tool_fail_set(f, TOOL_FILE, "%s: not enough memory", path);
    for (size_t i = 0; i < count(d); i++)
        px[i] = d->q4[i] <= d->none_q4 ? INFINITY : (float)d->q4[i] / 16.0f;
    int status = pfm_write(px, d->width, d->height, path, f);
    free(px);
    return status;
}

static int write_png(const disparity *d, const char *path, tool_fail *f)
{
    uint16_t *q8 = malloc(count(d) * sizeof *q8);
    if (!q8)
        return tool_fail_set(f, TOOL_FILE, "%s: not enough memory", path);
    int status = TOOL_OK;
    for (size_t i = 0; i < count(d) && status == TOOL_OK; i++) {
        int v = d->q4[i] <= d->none_q4 ? 0 : d->q4[i] ? d->q4[i] * 16 : 1;
        if (v < 0 || v > 65535)
            status = tool_fail_set(f, TOOL_USAGE, "%s: a .png cannot hold a disparity of %g px; write .npy or .pfm", path,
                                   d->q4[i] / 16.0);
        q8[i] = (uint16_t)v;
    }
    if (status == TOOL_OK)
        status = plane16_write_png(q8, d->width, d->height, path, f);
    free(q8);
    return status;
}

int disparity_write(const disparity *d, const char *path, tool_fail *f)
{
    if (tool_has_suffix(path, ".npy"))
        return npy_write_i16(d->q4, d->width, d->height, path, f);
    if (tool_has_suffix(path, ".pfm"))
        return write_pfm(d, path, f);
    if (tool_has_suffix(path, ".png"))
        return write_png(d, path, f);
    return tool_fail_set(f, TOOL_USAGE, "%s: a disparity map is written as .npy, .pfm or .png", path);
}

static int16_t q4_of(float px, int16_t none_q4)
{
    double v = floor((double)px * 16.0 + 0.5);
    if (!isfinite(px) || v < -32768.0 || v > 32767.0)
        return none_q4;
    return (int16_t)v;
}

static int read_grid(disparity *d, const char *path, int min_disparity, tool_fail *f)
{
    grid g;
    int pfm = tool_has_suffix(path, ".pfm");
    int status = pfm ? grid_read_pfm(&g, path, f) : grid_read_npy(&g, path, f);
    if (status)
        return status;
    status = disparity_alloc(d, g.width, g.height, min_disparity, f);
    for (size_t i = 0; status == TOOL_OK && i < count(d); i++)
        d->q4[i] = g.integer ? (int16_t)g.v[i] : q4_of(g.v[i], d->none_q4);
    grid_free(&g);
    return status;
}

static int read_png(disparity *d, const char *path, int min_disparity, tool_fail *f)
{
    uint16_t *q8;
    int width, height, bits;
    int status = plane16_read(&q8, &width, &height, &bits, path, f);
    if (status)
        return status;
    if (bits != 16)
        status = tool_fail_set(f, TOOL_FILE, "%s: a disparity map as .png has 16 bits, this has %d", path, bits);
    else
        status = disparity_alloc(d, width, height, min_disparity, f);
    for (size_t i = 0; status == TOOL_OK && i < count(d); i++)
        d->q4[i] = (int16_t)(q8[i] ? (q8[i] + 8) / 16 : d->none_q4);
    free(q8);
    return status;
}

int disparity_read(disparity *d, const char *path, int min_disparity, tool_fail *f)
{
    memset(d, 0, sizeof *d);
    if (tool_has_suffix(path, ".png"))
        return read_png(d, path, min_disparity, f);
    if (tool_has_suffix(path, ".npy") || tool_has_suffix(path, ".pfm"))
        return read_grid(d, path, min_disparity, f);
    return tool_fail_set(f, TOOL_USAGE, "%s: a disparity map is read from .npy, .pfm or .png", path);
}
