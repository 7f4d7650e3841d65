/* SPDX-License-Identifier: MIT
 * common/raster.h - picture files as they are: samples of 8 or 16 bits, before anyone says what they mean. */
#ifndef TOOL_RASTER_H
#define TOOL_RASTER_H

#include <stddef.h>
#include <stdint.h>

#include "fail.h"

/* width * height * channels samples, rows packed; 16-bit samples high byte first. `bytes` is malloc'd. */
typedef struct raster {
    int width, height;
    int channels; /* 1 or 3 */
    int bits;     /* 8 or 16 */
    uint8_t *bytes;
} raster;

/* Bytes of the largest raster that is accepted: a file that claims more is malformed or of no use here. */
#define RASTER_BYTES_MAX ((size_t)1 << 30)

/* PNG, PGM (P5, P2) or PPM (P6, P3), told apart by content. On failure r->bytes is NULL. */
int raster_read(raster *r, const char *path, tool_fail *f);
int raster_read_png(raster *r, const uint8_t *file, size_t size, const char *path, tool_fail *f);
int raster_read_pnm(raster *r, const uint8_t *file, size_t size, const char *path, tool_fail *f);
int raster_write_png(const raster *r, const char *path, tool_fail *f);
int raster_png_bytes(const raster *r, char **bytes, size_t *size, tool_fail *f);

/* Sizes checked and memory taken, for the readers. */
int raster_alloc(raster *r, const char *path, tool_fail *f);

#endif
