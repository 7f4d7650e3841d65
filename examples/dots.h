/* SPDX-License-Identifier: MIT
 * examples/dots.h - random dots whose right half stands nearer, for the pages that need frames and truth. */
#ifndef EXAMPLE_DOTS_H
#define EXAMPLE_DOTS_H

#include <stdint.h>

/* Disparity at column x of the right frame: 3 px, and 11 px right of the middle. */
static inline int dots_disparity(int x, int width)
{
    return x < width / 2 ? 3 : 11;
}

/* A row of both frames: dots 2 px wide, and noise of +-`noise` grey levels on the right one. */
static inline void dots_row(int y, int width, int noise, uint8_t *left, uint8_t *right)
{
    uint32_t dice = (uint32_t)y * 2654435761u + 1;
    for (int x = 0; x < width; x++) {
        dice = dice * 1664525u + 1013904223u;
        left[x] = x % 2 ? left[x - 1] : (uint8_t)(32 + (dice >> 24) * 3 / 4);
    }
    for (int x = 0; x < width; x++) {
        int from = x + dots_disparity(x, width);
        dice = dice * 1664525u + 1013904223u;
        int v = left[from < width ? from : width - 1] + (int)(dice >> 24) % (2 * noise + 1) - noise;
        right[x] = (uint8_t)(v < 0 ? 0 : v > 255 ? 255 : v);
    }
}

/* Truth of a row of the left frame, px * 65536. A left pixel that two right columns claim shows the nearer one. */
static inline void dots_truth(int width, int32_t none, int32_t *truth_q16)
{
    for (int x = 0; x < width; x++)
        truth_q16[x] = none;
    for (int x = 0; x < width; x++)
        if (x + dots_disparity(x, width) < width)
            truth_q16[x + dots_disparity(x, width)] = dots_disparity(x, width) * 65536;
}

#endif
