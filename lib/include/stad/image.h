/* SPDX-License-Identifier: MIT
 * stad/image.h - a borrowed view of 8-bit pixels.
 *
 * The library never owns, copies or keeps an image beyond the call it is given to. Sample c of pixel x in row y is
 * pix[y * row_stride + x * pixel_stride + c]: the luma of YUYV (pixel_stride 2), a crop, one channel of three, or a picture
 * stored bottom up (row_stride negative) need no copy. */
#ifndef STAD_IMAGE_H
#define STAD_IMAGE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The view. Make one by hand or with stad_image_packed(). */
typedef struct stad_image {
    const uint8_t *pix;   /* first sample of row 0; borrowed */
    int32_t width;        /* pixels */
    int32_t height;       /* rows */
    int32_t channels;     /* samples used of each pixel: 1 or 3 */
    int32_t pixel_stride; /* bytes from one pixel to the next, at least `channels` */
    ptrdiff_t row_stride; /* bytes from one row to the next; may be negative */
} stad_image;

/* A tightly packed image of `channels` interleaved samples. */
static inline stad_image stad_image_packed(const uint8_t *pix, int32_t width, int32_t height, int32_t channels)
{
    stad_image image = {pix, width, height, channels, channels, (ptrdiff_t)width * channels};
    return image;
}

#ifdef __cplusplus
}
#endif

#endif
