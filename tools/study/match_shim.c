/* SPDX-License-Identifier: MIT
 * study/match_shim.c - one grey MODE_SGBM match for ctypes; keeps its workspace between calls of one geometry. */
#include <stdlib.h>

#include "stad/match.h"

int study_match(int width, int height, int disparities, const uint8_t *left, const uint8_t *right, const int *x, int16_t *out);

int study_match(int width, int height, int disparities, const uint8_t *left, const uint8_t *right, const int *x, int16_t *out)
{
    static stad_match matcher;
    static stad_geometry bound;
    static void *work;
    const stad_geometry g = {(int16_t)width, (int16_t)height, 1, (int16_t)disparities, 11, 8192, 127, STAD_MODE_SGBM, STAD_MEMORY_FAST};
    const stad_params p = {0, (int16_t)disparities, (int16_t)x[2], (int16_t)x[0], (int16_t)x[1], (int16_t)x[5], (int16_t)x[4], (int16_t)x[3], 0, 0};
    const stad_image l = stad_image_packed(left, width, height, 1), r = stad_image_packed(right, width, height, 1);
    if (!work || bound.width != g.width || bound.height != g.height || bound.max_disparities != g.max_disparities) {
        const size_t bytes = (stad_match_bytes(&g) + 63) & ~(size_t)63;
        free(work);
        work = aligned_alloc(64, bytes);
        if (!work)
            return STAD_E_SIZE;
        const int status = stad_match_init(&matcher, &g, work, bytes);
        if (status != STAD_OK)
            return status;
        bound = g;
    }
    return stad_match_frame(&matcher, &p, &l, &r, out, width, NULL, 0);
}
