/* SPDX-License-Identifier: MIT
 * common/colour.h - disparity and error as colours to look at. */
#ifndef TOOL_COLOUR_H
#define TOOL_COLOUR_H

#include <stdint.h>

#include "disparity_file.h"
#include "picture.h"
#include "truth_file.h"

#ifdef __cplusplus
extern "C" {
#endif

/* v in 0..1 to R, G, B: lightness grows steadily from dark (far) to bright (near), the hue turns once on the way, so it
 * reads in grey too. Green's cubehelix (Bull. Astr. Soc. India 39, 289, 2011). */
void colour_of(double v, uint8_t rgb[3]);

/* The map over min_disparity .. min_disparity + num_disparities; pixels without a disparity are black. */
int colour_disparity(picture *p, const disparity *d, int num_disparities, tool_fail *f);

/* The truth in the same colours: px * 65536 in rows of `width`. */
int colour_truth(picture *p, const truth_map *t, int min_disparity, int num_disparities, tool_fail *f);

/* How a pixel is in an error map. */
enum colour_error_kind { ERROR_NO_TRUTH, ERROR_MISSING, ERROR_RIGHT, ERROR_WRONG };
void colour_error(enum colour_error_kind kind, double error_in_thresholds, uint8_t rgb[3]);

/* Where the map errs: right = blue, wrong = yellow to red with the error, missing = violet, no truth = grey; occluded pixels
 * at half the brightness. */
int colour_error_map(picture *p, const disparity *d, const truth_map *t, double threshold, tool_fail *f);

#ifdef __cplusplus
}
#endif

#endif
