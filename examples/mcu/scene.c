/* SPDX-License-Identifier: MIT
 * examples/mcu/scene.c - a made-up stereo scene with known disparity, a row at a time, from integers alone. */
#include "scene.h"

#include <stddef.h>

enum { SURFACES = 3, CELL = 4 }; /* nearest first, the ground last; texture cells of 4 x 4 px */

static uint32_t mix(uint32_t v)
{
    v ^= v >> 16;
    v *= 0x7feb352du;
    v ^= v >> 15;
    v *= 0x846ca68bu;
    return v ^ (v >> 16);
}

/* 0..255, a fixed function of a place. */
static int32_t random_at(uint32_t seed, int32_t x, int32_t y)
{
    return (int32_t)(mix(seed + (uint32_t)x * 0x9e3779b9u + mix((uint32_t)y)) & 255);
}

/* Disparity of a surface in a row, px * 16: boxes face the camera, the ground rises towards it. */
static int32_t disparity_q4(const scene *s, int surface, int y)
{
    const int32_t d = s->disparities;
    if (surface == 0)
        return 16 * d * 3 / 4 + 5;
    if (surface == 1)
        return 16 * d / 2;
    return 16 * d / 8 + 4 * d * y / s->height;
}

/* Is column x_q4 / 16 of the left view on the surface, were it alone? */
static int covers(const scene *s, int surface, int32_t x_q4, int y)
{
    const int32_t w = 16 * s->width, h = s->height;
    if (surface == 0)
        return x_q4 >= w * 5 / 8 && x_q4 < w * 7 / 8 && y >= h / 6 && y < h * 2 / 3;
    if (surface == 1)
        return x_q4 >= w * 3 / 8 && x_q4 < w * 9 / 16 && y >= h / 3 && y < h * 5 / 6;
    return 1;
}

/* A coarse pattern blended with a fine one, 40..215. */
static int32_t texture(const scene *s, int surface, int32_t x, int y)
{
    const uint32_t seed = s->seed + (uint32_t)surface * 0x51ed27u;
    const int32_t far_x = (x + 4096) % CELL, cell_x = (x + 4096) / CELL, far_y = y % CELL, cell_y = y / CELL;
    const int32_t top = random_at(seed, cell_x, cell_y) * (CELL - far_x) + random_at(seed, cell_x + 1, cell_y) * far_x;
    const int32_t end = random_at(seed, cell_x, cell_y + 1) * (CELL - far_x) + random_at(seed, cell_x + 1, cell_y + 1) * far_x;
    const int32_t coarse = (top * (CELL - far_y) + end * far_y) / (CELL * CELL);
    return 40 + coarse / 2 + random_at(seed ^ 0xf17eu, x, y) * 3 / 16;
}

/* Grey level of column x_q4 / 16 of a surface, between its two texture columns. */
static int32_t grey(const scene *s, int surface, int32_t x_q4, int y)
{
    const int32_t x = (x_q4 + 16 * 256) / 16 - 256, far = x_q4 - 16 * x;
    return (texture(s, surface, x, y) * (16 - far) + texture(s, surface, x + 1, y) * far + 8) / 16;
}

/* A pixel of the view whose column x shows each surface shifted by `shifted` times its disparity. */
static uint8_t pixel(const scene *s, int x, int y, int shifted, int *surface)
{
    const uint32_t seed = s->seed ^ (shifted ? 0xabcdu : 0x1234u);
    int32_t x_q4 = 0;
    int i;
    for (i = 0; i < SURFACES; i++) {
        x_q4 = 16 * x + (shifted ? disparity_q4(s, i, y) : 0);
        if (covers(s, i, x_q4, y))
            break;
    }
    *surface = i;
    return (uint8_t)(grey(s, i, x_q4, y) + random_at(seed, x, y) % (2 * s->noise + 1) - s->noise);
}

void scene_row(const scene *s, int y, uint8_t *left, uint8_t *right, int32_t *truth_q16)
{
    int x, surface;
    for (x = 0; x < s->width; x++) {
        right[x] = pixel(s, x, y, 1, &surface);
        left[x] = pixel(s, x, y, 0, &surface);
        if (truth_q16 != NULL)
            truth_q16[x] = disparity_q4(s, surface, y) * 4096;
    }
}
