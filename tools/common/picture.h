/* SPDX-License-Identifier: MIT
 * common/picture.h - 8-bit pictures: PNG, PGM and PPM in, PNG out. */
#ifndef TOOL_PICTURE_H
#define TOOL_PICTURE_H

#include <stddef.h>
#include <stdint.h>

#include "fail.h"
#include "stad/image.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Largest side of a picture: what the library's geometry can say. */
#define PICTURE_SIDE_MAX 32767

/* Owns its pixels: width * height * channels bytes, rows packed; channels 1 (grey) or 3 in the order R, G, B. */
typedef struct picture {
    int width, height, channels;
    uint8_t *pix;
} picture;

/* What the caller wants of a file, whatever it holds. */
enum picture_want {
    PICTURE_AS_IS, /* 1 or 3 channels */
    PICTURE_GREY,  /* colour becomes (9798 R + 19235 G + 3735 B + 16384) >> 15, as cv::cvtColor has it */
    PICTURE_BGR    /* 3 channels in the order B, G, R; grey is tripled */
};

int picture_alloc(picture *p, int width, int height, int channels, tool_fail *f);
void picture_free(picture *p);
stad_image picture_view(const picture *p);

/* Reads an 8-bit PNG (any colour type; alpha is dropped), PGM or PPM, told apart by content. 16-bit files are refused: what
 * a matcher should make of them is for the user to say. */
int picture_read(picture *p, const char *path, enum picture_want want, tool_fail *f);

/* Writes an 8-bit PNG of 1 or 3 channels (R, G, B). */
int picture_write_png(const picture *p, const char *path, tool_fail *f);

/* Writes grey as PGM, for those who have no libpng. */
int picture_write_pgm(const picture *p, const char *path, tool_fail *f);

/* A PNG in memory: *bytes is malloc'd. */
int picture_png_bytes(const picture *p, char **bytes, size_t *size, tool_fail *f);

/* A 16-bit grey plane as PNG, both ways; `pix` is malloc'd by the reader. The reader takes 8-bit grey files too (PNG or PGM)
 * and says which in *bits. */
int plane16_read(uint16_t **pix, int *width, int *height, int *bits, const char *path, tool_fail *f);
int plane16_write_png(const uint16_t *pix, int width, int height, const char *path, tool_fail *f);

#ifdef __cplusplus
}
#endif

#endif
