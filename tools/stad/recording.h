/* SPDX-License-Identifier: MIT
 * stad/recording.h - recorded stereo frames, however they lie on the disk. */
#ifndef STAD_RECORDING_H
#define STAD_RECORDING_H

#include "../common/picture.h"

typedef struct recording {
    const char *where;
    char **left, **right; /* file names by frame, owned; `right` NULL: side by side in `left` */
    int count;
    int raw_width, raw_height; /* > 0: one file, left and right frames of 8 bits in turns */
} recording;

/* Finds the frames below `where`, in the order of their names:
 *     a folder with pairs of names that differ in left/right, or in a leading or trailing 0/1
 *     folders image_0, image_1 (or _2, _3; or _00/data ...), as KITTI has them
 *     folders cam0/data, cam1/data, perhaps below mav0, as EuRoC has them
 *     side_by_side: pictures that hold both views beside each other
 *     raw_width > 0: a file of 8-bit frames */
int recording_open(recording *r, const char *where, int side_by_side, int raw_width, int raw_height, tool_fail *f);
void recording_close(recording *r);

/* Frame i, grey or B, G, R. The two views have one size. */
int recording_read(const recording *r, int i, int color, picture *left, picture *right, tool_fail *f);

#endif
