/* SPDX-License-Identifier: MIT
 * stad/scene_frames.h - `stad scene --target`: a recording of a room in which someone holds up the target. */
#ifndef STAD_SCENE_FRAMES_H
#define STAD_SCENE_FRAMES_H

#include "../common/picture.h"

typedef struct scene_frames {
    const char *folder;
    int width, height, num_disparities, frames;
    unsigned seed;
    double noise;    /* grey levels, largest deviation */
    double drift_dy; /* px that the right camera has sunk, from drift_from on */
    int drift_from;
    int pgm;   /* 1: the views are written as .pgm */
    int share; /* per cent of the image's width that the target takes */
} scene_frames;

/* Writes NNN_left.png, NNN_right.png (or .pgm), NNN_disp.pfm and NNN_nonocc.png for every frame. */
int scene_frames_write(const scene_frames *s, tool_fail *f);

#endif
