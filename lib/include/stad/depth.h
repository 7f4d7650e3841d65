/* SPDX-License-Identifier: MIT
 * stad/depth.h - disparities to depth in millimetres.
 *
 * Z = f * B / (d + offset), with f the focal length in pixels, B the baseline in millimetres and the offset the difference
 * of the principal points' columns (cx of the right view minus cx of the left; 0 for most rectified rigs). In whole numbers:
 * depth = (focal_baseline_q4 + s / 2) / s with s = disp_q4 + offset_q4, so rounded to the nearest millimetre, half up. */
#ifndef STAD_DEPTH_H
#define STAD_DEPTH_H

#include <stdint.h>

#include "stad/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A pair of cameras, as far as depth needs it. */
typedef struct stad_depth {
    uint32_t focal_baseline_q4; /* f * B * 16, px * mm * 16, 1 .. 2^31: f 436.244 px and B 110.08 mm give 768351 */
    int16_t offset_q4;          /* px * 16, added to every disparity */
    int16_t none_q4;            /* the value that means no disparity: (min_disparity - 1) * 16 */
} stad_depth;

/* Depths of a row of `width` disparities: 0 where there is none or where s <= 0 (at or beyond infinity); 65535 stands for
 * everything from 65535 mm on. `disp_q4_row` and `depth_mm_row` may not overlap. STAD_E_PARAM: focal_baseline_q4 is out of
 * range; nothing is written. */
int stad_depth_row(const stad_depth *depth, const int16_t *disp_q4_row, int32_t width, uint16_t *depth_mm_row);

#ifdef __cplusplus
}
#endif

#endif
