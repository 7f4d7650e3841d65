/* SPDX-License-Identifier: MIT
 * common/picture.c - 8-bit pictures: memory, grey, and the choice of a reader by content. */
#include "picture.h"

#include <stdlib.h>
#include <string.h>

#include "raster.h"
#include "whole_file.h"

int picture_alloc(picture *p, int width, int height, int channels, tool_fail *f)
{
    p->width = width;
    p->height = height;
    p->channels = channels;
    p->pix = calloc((size_t)width * (size_t)height, (size_t)channels);
    if (!p->pix)
        return tool_fail_set(f, TOOL_FILE, "not enough memory for a picture of %d x %d", width, height);
    return TOOL_OK;
}

void picture_free(picture *p)
{
    free(p->pix);
    memset(p, 0, sizeof *p);
}

stad_image picture_view(const picture *p)
{
    return stad_image_packed(p->pix, p->width, p->height, p->channels);
}

static void to_grey(picture *p)
{
    size_t n = (size_t)p->width * (size_t)p->height;
    for (size_t i = 0; i < n; i++) {
        const uint8_t *rgb = p->pix + 3 * i;
        p->pix[i] = (uint8_t)((9798u * rgb[0] + 19235u * rgb[1] + 3735u * rgb[2] + 16384u) >> 15);
    }
    p->channels = 1;
}

static void swap_red_blue(picture *p)
{
    size_t n = (size_t)p->width * (size_t)p->height;
    for (uint8_t *q = p->pix; n > 0; n--, q += 3) {
        uint8_t red = q[0];
        q[0] = q[2];
        q[2] = red;
    }
}

static int triple(picture *p, tool_fail *f)
{
    picture wide;
    int status = picture_alloc(&wide, p->width, p->height, 3, f);
    if (status)
        return status;
    size_t n = (size_t)p->width * (size_t)p->height;
    for (size_t i = 0; i < n; i++)
        memset(wide.pix + 3 * i, p->pix[i], 3);
    picture_free(p);
    *p = wide;
    return TOOL_OK;
}

static int shape_as(picture *p, enum picture_want want, tool_fail *f)
{
    if (want == PICTURE_GREY && p->channels == 3)
        to_grey(p);
    if (want == PICTURE_BGR && p->channels == 3)
        swap_red_blue(p);
    if (want == PICTURE_BGR && p->channels == 1)
        return triple(p, f);
    return TOOL_OK;
}

static int from_raster(picture *p, raster *r, const char *path, tool_fail *f)
{
    if (r->bits == 16)
        return tool_fail_set(f, TOOL_FILE, "%s: 16 bits a sample; an image to match must have 8", path);
    p->width = r->width;
    p->height = r->height;
    p->channels = r->channels;
    p->pix = r->bytes;
    r->bytes = NULL;
    return TOOL_OK;
}

int picture_read(picture *p, const char *path, enum picture_want want, tool_fail *f)
{
    raster r;
    memset(p, 0, sizeof *p);
    int status = raster_read(&r, path, f);
    if (status == TOOL_OK)
        status = from_raster(p, &r, path, f);
    free(r.bytes);
    if (status == TOOL_OK)
        status = shape_as(p, want, f);
    if (status)
        picture_free(p);
    return status;
}

int picture_write_png(const picture *p, const char *path, tool_fail *f)
{
    raster r = {p->width, p->height, p->channels, 8, p->pix};
    return raster_write_png(&r, path, f);
}

int picture_write_pgm(const picture *p, const char *path, tool_fail *f)
{
    tool_out out;
    int status = tool_out_open(&out, path, f);
    if (status)
        return status;
    fprintf(out.stream, "P5\n%d %d\n255\n", p->width, p->height);
    fwrite(p->pix, 1, (size_t)p->width * (size_t)p->height, out.stream);
    return tool_out_close(&out, 1, f);
}

int picture_png_bytes(const picture *p, char **bytes, size_t *size, tool_fail *f)
{
    raster r = {p->width, p->height, p->channels, 8, p->pix};
    return raster_png_bytes(&r, bytes, size, f);
}

int plane16_read(uint16_t **pix, int *width, int *height, int *bits, const char *path, tool_fail *f)
{
    raster r;
    *pix = NULL;
    int status = raster_read(&r, path, f);
    if (status == TOOL_OK && r.channels != 1)
        status = tool_fail_set(f, TOOL_FILE, "%s: a colour picture where one of a single channel is needed", path);
    if (status) {
        free(r.bytes);
        return status;
    }
    size_t n = (size_t)r.width * (size_t)r.height;
    *width = r.width;
    *height = r.height;
    *bits = r.bits;
    *pix = malloc(n * sizeof **pix);
    for (size_t i = 0; *pix && i < n; i++)
        (*pix)[i] = (uint16_t)(r.bits == 8 ? r.bytes[i] : r.bytes[2 * i] << 8 | r.bytes[2 * i + 1]);
    free(r.bytes);
    return *pix ? TOOL_OK : tool_fail_set(f, TOOL_FILE, "%s: not enough memory", path);
}

int plane16_write_png(const uint16_t *pix, int width, int height, const char *path, tool_fail *f)
{
    size_t n = (size_t)width * (size_t)height;
    uint8_t *bytes = malloc(n * 2);
    if (!bytes)
        return tool_fail_set(f, TOOL_FILE, "%s: not enough memory", path);
    for (size_t i = 0; i < n; i++) {
        bytes[2 * i] = (uint8_t)(pix[i] >> 8);
        bytes[2 * i + 1] = (uint8_t)(pix[i] & 255);
    }
    raster r = {width, height, 1, 16, bytes};
    int status = raster_write_png(&r, path, f);
    free(bytes);
    return status;
}
