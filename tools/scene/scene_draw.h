/* SPDX-License-Identifier: MIT
 * scene/scene_draw.h - stereo pairs drawn from planes, with exact disparity and exact visibility.
 *
 * A scene is a list of surfaces in disparity space: over the left image, d(x, y) = c + a (x - width / 2) + b (y - height / 2).
 * A plane in space is a plane in disparity. The left pixel x shows the surface's paint at (x, y); the right pixel xr shows
 * it at the x with x - d(x, y) = xr, so a surface looks the same from both sides and the truth is exact by construction.
 * Where surfaces overlap, the one with the larger disparity hides the other, in either view. Integers only: the same scene
 * gives the same bytes on every machine. */
#ifndef TOOL_SCENE_DRAW_H
#define TOOL_SCENE_DRAW_H

#include <stdint.h>

#include "../common/fail.h"
#include "../common/picture.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SCENE_SURFACES 64

/* Grey of a surface at (u, v), px * 256 in left image coordinates. `what` is the surface's own. */
typedef int scene_paint(const void *what, int32_t u_q8, int32_t v_q8);

/* The paint of scene_random: noise of several grain sizes, so that every block of pixels looks different. */
typedef struct scene_noise {
    uint32_t seed;
    int grey, contrast;   /* mean, and largest deviation from it */
    int finest, coarsest; /* grain, log2 of px: 1 = 2 px */
    int stripes;          /* 0, or a period in px: the paint repeats, as a fence does */
} scene_noise;
int scene_paint_noise(const void *noise, int32_t u_q8, int32_t v_q8);

enum scene_shape { SCENE_EVERYWHERE, SCENE_BOX, SCENE_DISC };

typedef struct scene_surface {
    int32_t c_q16, a_q16, b_q16; /* disparity at the middle, and its slopes along x and y; |slope| < 1/2 */
    int shape;                   /* enum scene_shape, in left image coordinates */
    int x0, y0, x1, y1;          /* px, the box x0 <= x < x1 and y0 <= y < y1, or the disc inside it */
    scene_paint *paint;
    const void *what;
} scene_surface;

typedef struct scene {
    int width, height;
    int count;
    scene_surface surface[SCENE_SURFACES];
    scene_noise noise[SCENE_SURFACES]; /* what the paint of scene_random reads */
    uint32_t seed;                     /* of the camera noise */
    int camera_noise;                  /* largest deviation of a pixel, grey levels, either view on its own */
    int right_gain_q8;                 /* 256: both cameras are alike */
} scene;

/* A slanted background and `plates` plates in front of it, disparities within min_disparity .. min_disparity + num_disparities - 2, paints
 * rich and poor. 1 <= plates < SCENE_SURFACES. The scene points into itself: do not copy it. */
void scene_random(scene *s, int width, int height, int min_disparity, int num_disparities, int plates, uint32_t seed);

/* Grey pictures, truth (px * 65536, of every left pixel) and visibility (255: the right camera sees it too; 0: hidden by a
 * surface in front, or outside the right image). All four are allocated here; *truth_q16 is for free(). */
int scene_render(const scene *s, picture *left, picture *right, int32_t **truth_q16, picture *visible, tool_fail *f);

#ifdef __cplusplus
}
#endif

#endif
