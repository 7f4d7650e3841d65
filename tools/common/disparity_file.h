/* SPDX-License-Identifier: MIT
 * common/disparity_file.h - disparity maps as files: .npy, .pfm, .png. */
#ifndef TOOL_DISPARITY_FILE_H
#define TOOL_DISPARITY_FILE_H

#include <stdint.h>

#include "fail.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Owned; packed rows of px * 16. none_q4, and anything below, means that there is no disparity. */
typedef struct disparity {
    int width, height;
    int16_t none_q4;
    int16_t *q4;
} disparity;

int disparity_alloc(disparity *d, int width, int height, int min_disparity, tool_fail *f);
void disparity_free(disparity *d);

/* Is `path` of a kind that can be written, and can it hold disparities from min_disparity on? To ask before the work. */
int disparity_check_path(const char *path, int min_disparity, int num_disparities, tool_fail *f);

/* By suffix. .npy: int16, the values as they are. .pfm: pixels, none = +inf. .png: 16 bits, px * 256, none = 0 (a disparity of
 * 0 is written as 1/256, KITTI's custom); refused when a disparity is negative. */
int disparity_write(const disparity *d, const char *path, tool_fail *f);

/* The same files read back. Pixels that are no multiple of 1/16 (another matcher's) are rounded to the nearest. */
int disparity_read(disparity *d, const char *path, int min_disparity, tool_fail *f);

#ifdef __cplusplus
}
#endif

#endif
