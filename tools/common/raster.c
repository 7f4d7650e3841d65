/* SPDX-License-Identifier: MIT
 * common/raster.c - picture files as they are: which reader, and how much memory. */
#include "raster.h"

#include <stdlib.h>
#include <string.h>

#include "picture.h"
#include "whole_file.h"

int raster_alloc(raster *r, const char *path, tool_fail *f)
{
    if (r->width < 1 || r->height < 1 || r->width > PICTURE_SIDE_MAX || r->height > PICTURE_SIDE_MAX)
        return tool_fail_set(f, TOOL_FILE, "%s: %d x %d pixels; each side must lie in 1..%d", path, r->width, r->height,
                             PICTURE_SIDE_MAX);
    size_t need = (size_t)r->width * (size_t)r->height * (size_t)r->channels * (size_t)(r->bits / 8);
    if (need > RASTER_BYTES_MAX)
        return tool_fail_set(f, TOOL_FILE, "%s: %d x %d pixels are more than this tool reads", path, r->width, r->height);
    r->bytes = malloc(need);
    if (!r->bytes)
        return tool_fail_set(f, TOOL_FILE, "%s: not enough memory", path);
    return TOOL_OK;
}

int raster_read(raster *r, const char *path, tool_fail *f)
{
    static const uint8_t png[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    uint8_t *file;
    size_t size;
    memset(r, 0, sizeof *r);
    int status = tool_read_whole(path, RASTER_BYTES_MAX, &file, &size, f);
    if (status)
        return status;
    if (size >= sizeof png && memcmp(file, png, sizeof png) == 0)
        status = raster_read_png(r, file, size, path, f);
    else if (size >= 3 && file[0] == 'P' && (file[1] == '2' || file[1] == '3' || file[1] == '5' || file[1] == '6'))
        status = raster_read_pnm(r, file, size, path, f);
    else
        status = tool_fail_set(f, TOOL_FILE, "%s: %s; PNG, PGM and PPM are read", path,
                               size ? "not a picture of a kind known here" : "empty file");
    free(file);
    if (status) {
        free(r->bytes);
        r->bytes = NULL;
    }
    return status;
}
