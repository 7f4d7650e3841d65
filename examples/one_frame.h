/* SPDX-License-Identifier: MIT
 * examples/one_frame.h - what the examples for operating systems do: match one made-up frame by rows. */
#ifndef ONE_FRAME_H
#define ONE_FRAME_H

#include "stad/stad.h"

enum { WIDTH = 160, HEIGHT = 120, DISPARITIES = 32, BLOCK = 5, P2 = 800, CAP = 63, SHIFT = 9 };

static STAD_ALIGNED uint8_t
    work[STAD_MATCH_BYTES(WIDTH, HEIGHT, 1, DISPARITIES, BLOCK, P2, CAP, STAD_MODE_SGBM, STAD_MEMORY_SMALL)];
static stad_match matcher;
static uint8_t left[WIDTH], right[WIDTH];
static int16_t disp_q4[WIDTH];

/* A wall of noise SHIFT pixels deep. */
static void camera_row(int y)
{
    for (int x = 0; x < WIDTH; x++) {
        const uint32_t row = (uint32_t)y * 40503u;
        const uint32_t at = (uint32_t)(x + SHIFT) * 2654435761u ^ row, here = (uint32_t)x * 2654435761u ^ row;
        right[x] = (uint8_t)(at >> 13);
        left[x] = (uint8_t)(here >> 13);
    }
}

/* Returns a status; counts: how many pixels were looked at, and how many have a disparity. */
static int match_one_frame(stad_match_counts *counts)
{
    const stad_geometry geometry = {WIDTH, HEIGHT, 1, DISPARITIES, BLOCK, P2, CAP, STAD_MODE_SGBM, STAD_MEMORY_SMALL};
    stad_params params;
    stad_params_sample(&params, DISPARITIES, BLOCK, 1);
    int status = stad_match_init(&matcher, &geometry, work, sizeof work);
    if (status == STAD_OK)
        status = stad_match_begin(&matcher, &params);
    for (int y = 0; y < HEIGHT && status == STAD_OK; y++) {
        camera_row(y);
        status = stad_match_push(&matcher, left, right);
        while (stad_match_pull(&matcher, disp_q4) >= 0) { /* a row of disparities: yours to use */
        }
    }
    *counts = *stad_match_counts_of(&matcher);
    return status;
}

#endif
