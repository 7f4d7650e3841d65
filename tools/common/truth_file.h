/* SPDX-License-Identifier: MIT
 * common/truth_file.h - ground truth as files, and which of its pixels the right camera sees. */
#ifndef TOOL_TRUTH_FILE_H
#define TOOL_TRUTH_FILE_H

#include <stdint.h>

#include "fail.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Owned, packed rows. q16: px * 65536, STAD_TRUTH_NONE where there is none; label: enum stad_label. */
typedef struct truth_map {
    int width, height;
    int32_t *q16;
    uint8_t *label;
} truth_map;

void truth_free(truth_map *t);

/* Is truth of that name a picture, whose steps a scale turns into pixels? Else it holds pixels already. */
int truth_has_scale(const char *path);

/* .pfm (pixels; NaN or infinite = none), 16-bit .png (px * 256, or * scale if scale > 0; 0 = none), 8-bit .png or .pgm
 * (px * scale; 0 = none; refused when scale is 0), .npy or .npz (int16: px * 16, below min_disparity = none; float:
 * as .pfm).
 * Pixels are labelled by the library's rule. */
int truth_read(truth_map *t, const char *path, double scale, int min_disparity, tool_fail *f);

/* Labels from a mask instead: 0 and 128 = hidden from the right camera, anything else = visible. */
int truth_mask(truth_map *t, const char *path, tool_fail *f);

#ifdef __cplusplus
}
#endif

#endif
