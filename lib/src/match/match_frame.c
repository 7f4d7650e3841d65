/* SPDX-License-Identifier: MIT
 * image -> [FRAME] -> disparity
 * match/match_frame.c - a whole frame through the row pump, then the speckle filter. */
#include <string.h>

#include "match/frame.h"
#include "base/arith.h"

static int image_fits(const stad_frame *f, const stad_image *image)
{
    return image->pix && image->width == f->g.width && image->height == f->g.height && image->channels == f->g.channels &&
           image->pixel_stride >= image->channels;
}

static int speckle_fits(const stad_frame *f, const void *work, size_t work_bytes)
{
    return work && (uintptr_t)work % sizeof(int32_t) == 0 && work_bytes >= STAD_SPECKLE_BYTES(f->g.width, f->g.height);
}

/* Row y with its samples packed: the image's own memory if they are, else gathered into `packed`. */
static const uint8_t *packed_row(const stad_image *image, int32_t y, uint8_t *packed)
{
    const uint8_t *row = image->pix + y * image->row_stride;
    if (image->pixel_stride == image->channels)
        return row;
    for (int32_t x = 0; x < image->width; x++)
        for (int32_t c = 0; c < image->channels; c++)
            packed[x * image->channels + c] = row[(ptrdiff_t)x * image->pixel_stride + c];
    return packed;
}

/* Pushes the next row unless the matcher wants to be pulled first. The feature rows are free between pulls: samples that
 * are not packed are gathered there. */
static int push_next(stad_match *m, const stad_image *left, const stad_image *right)
{
    stad_frame *f = frame_of(m);
    uint8_t *spare = f->features;
    const int32_t y = f->pushed;
    if (y == f->g.height)
        return STAD_OK;
    return stad_match_push(m, packed_row(left, y, spare), packed_row(right, y, spare + f->g.width * f->g.channels));
}

static int filter_speckles(stad_frame *f, int16_t *disp_q4, ptrdiff_t disp_stride, void *work, size_t work_bytes)
{
    if (f->p.speckle_window_size == 0)
        return STAD_OK;
    const int32_t removed = stad_speckle_filter(disp_q4, disp_stride, f->g.width, f->g.height, none_q4(f),
                                                f->p.speckle_window_size, 16 * f->p.speckle_range, work, work_bytes);
    f->counts.rejected_speckle = max_i32(removed, 0);
    return min_i32(removed, STAD_OK);
}

/* The next row out, in the frame's order, to its place. Whether there was one. */
static int pull_next(stad_match *m, int16_t *disp_q4, ptrdiff_t disp_stride)
{
    const stad_frame *f = frame_of(m);
    const int two_pass = f->g.mode == STAD_MODE_HH || f->g.mode == STAD_MODE_HH4;
    const int32_t row = two_pass ? f->g.height - 1 - f->pulled : f->pulled;
    return stad_match_pull(m, disp_q4 + row * disp_stride) >= 0;
}

int stad_match_frame(stad_match *m, const stad_params *p, const stad_image *left, const stad_image *right, int16_t *disp_q4,
                     ptrdiff_t disp_stride, void *speckle_work, size_t speckle_bytes)
{
    STAD_ASSERT(m && p && left && right);
    stad_frame *f = frame_of(m);
    int status = stad_match_begin(m, p);
    if (status != STAD_OK)
        return status;
    if (!image_fits(f, left) || !image_fits(f, right) || !disp_q4)
        return STAD_E_SIZE;
    if (p->speckle_window_size > 0 && !speckle_fits(f, speckle_work, speckle_bytes))
        return STAD_E_SIZE;
    for (int32_t left_over = f->g.height; left_over > 0;) {
        status = push_next(m, left, right);
        if (status != STAD_OK && status != STAD_AGAIN)
            return status;
        left_over -= pull_next(m, disp_q4, disp_stride);
    }
    return filter_speckles(f, disp_q4, disp_stride, speckle_work, speckle_bytes);
}

int stad_match_frame_again(stad_match *m, const stad_params *p, const stad_winners *w, int16_t *disp_q4, ptrdiff_t disp_stride,
                           void *speckle_work, size_t speckle_bytes)
{
    STAD_ASSERT(m && p && w);
    stad_frame *f = frame_of(m);
    const int status = stad_match_again(m, p, w);
    if (status != STAD_OK)
        return status;
    if (!disp_q4 || (p->speckle_window_size > 0 && !speckle_fits(f, speckle_work, speckle_bytes)))
        return STAD_E_SIZE;
    for (int32_t left_over = f->g.height; left_over > 0;)
        left_over -= pull_next(m, disp_q4, disp_stride);
    return filter_speckles(f, disp_q4, disp_stride, speckle_work, speckle_bytes);
}
