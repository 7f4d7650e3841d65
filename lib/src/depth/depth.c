/* SPDX-License-Identifier: MIT
 * disparity -> [DEPTH]
 * depth/depth.c - disparities to millimetres, one 32-bit division a pixel. */
#include "stad/depth.h"
#include "base/arith.h"

/* Bounds: s is at most 65534, so focal_baseline_q4 + s / 2 stays below 2^31 + 2^15. */
static uint16_t depth_of(const stad_depth *depth, int16_t disp_q4)
{
    const int32_t s = (int32_t)disp_q4 + depth->offset_q4;
    if (disp_q4 == depth->none_q4 || s <= 0)
        return 0;
    const uint32_t mm = (depth->focal_baseline_q4 + (uint32_t)s / 2u) / (uint32_t)s;
    return (uint16_t)(mm < UINT16_MAX ? mm : UINT16_MAX);
}

int stad_depth_row(const stad_depth *depth, const int16_t *disp_q4_row, int32_t width, uint16_t *depth_mm_row)
{
    STAD_ASSERT(depth && (width <= 0 || (disp_q4_row && depth_mm_row)));
    if (depth->focal_baseline_q4 < 1 || depth->focal_baseline_q4 > (uint32_t)1 << 31)
        return STAD_E_PARAM;
    for (int32_t x = 0; x < width; x++)
        depth_mm_row[x] = depth_of(depth, disp_q4_row[x]);
    return STAD_OK;
}
