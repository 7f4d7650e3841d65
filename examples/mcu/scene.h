/* SPDX-License-Identifier: MIT
 * examples/mcu/scene.h - a made-up stereo scene with known disparity, a row at a time, from integers alone.
 *
 * Two boxes float before a sloping ground, all covered by a pseudo-random texture; both views see the same surfaces, so
 * the truth is exact. Stands in for a camera: no frame is stored, and every core makes the same pixels. */
#ifndef SCENE_H
#define SCENE_H

#include <stdint.h>

typedef struct scene {
    int16_t width, height; /* px */
    int16_t disparities;   /* px; all truth lies in [1, disparities - 2] */
    int16_t noise;         /* grey levels, largest error of a pixel, different in both views */
    uint32_t seed;
} scene;

/* Row y of both views, and the left view's disparity, px * 65536. `truth_q16` may be NULL. */
void scene_row(const scene *s, int y, uint8_t *left, uint8_t *right, int32_t *truth_q16);

#endif
