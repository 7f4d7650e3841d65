/* SPDX-License-Identifier: MIT
 * stad/params.h - the matcher's parameters: names and meaning of cv::StereoSGBM.
 *
 * Exact semantics: docs/SPEC.md section 1. OpenCV repairs odd values in silence; here stad_params_check() refuses them and
 * names the field, and stad_params_normalize() does openly what OpenCV does. */
#ifndef STAD_PARAMS_H
#define STAD_PARAMS_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Same numbers as cv::StereoSGBM::MODE_*. */
enum stad_mode {
    STAD_MODE_SGBM = 0, /* five paths, one pass: the usual choice */
    STAD_MODE_HH = 1,   /* eight paths, two passes: keeps the whole frame */
    STAD_MODE_3WAY = 2, /* three paths, least memory */
    STAD_MODE_HH4 = 3   /* four paths, two passes */
};

/* A set of parameters. stad_params_sample() and stad_params_default() fill it. */
typedef struct stad_params {
    int16_t min_disparity;       /* px, smallest disparity searched; may be negative */
    int16_t num_disparities;     /* px, > 0; a multiple of 16 (8 is enough outside STAD_MODE_3WAY) */
    int16_t block_size;          /* px, odd, >= 1: side of the matching block */
    int16_t p1;                  /* cost of a disparity step of one, 1..32766 */
    int16_t p2;                  /* cost of a larger step, p1 + 1..32767 */
    int16_t disp12_max_diff;     /* px, >= 1: largest left-right difference that passes */
    int16_t pre_filter_cap;      /* odd, >= 15: clip of the x-Sobel prefilter */
    int16_t uniqueness_ratio;    /* percent, 0..99: margin by which the best cost must win */
    int32_t speckle_window_size; /* px, 0 = off: components up to this size are removed */
    int32_t speckle_range;       /* px, >= 0: disparity step that still joins a component */
} stad_params;

/* The parameters of OpenCV's stereo_match sample: p1 = 8 c b^2, p2 = 32 c b^2, cap 63, uniqueness 10, disp12 1, speckle off.
 * min_disparity is 0. A product above 32767 is cut to the field's range, which stad_params_check() still accepts; so is a number of
 * disparities or a block, which it refuses. */
void stad_params_sample(stad_params *p, int num_disparities, int block_size, int channels);

/* What cv::StereoSGBM::create() starts from, normalised: p1 2, p2 5, block 3, uniqueness 0, cap 15, disp12 1, speckle off. */
void stad_params_default(stad_params *p, int num_disparities);

/* Does openly what OpenCV does in silence: block_size <= 0 becomes 5 (3 in 3WAY) and an even one the next odd, p1 <= 0
 * becomes 2, p2 <= 0 becomes 5 and at least p1 + 1, uniqueness < 0 becomes 10, disp12 <= 0 becomes 1, the cap becomes odd
 * and at least 15, speckle_window_size < 0 becomes 0. One limit of its own: p1 32767 becomes 32766, because p2 must be
 * larger and fit too. Returns how many fields changed. */
int stad_params_normalize(stad_params *p, int mode);

/* Checks every field against the defined domain for images `width` pixels wide. STAD_OK, or STAD_E_PARAM with the name of
 * the first offending field in *culprit (a constant string such as "block_size"; `culprit` may be NULL). */
int stad_params_check(const stad_params *p, int mode, int width, const char **culprit);

#ifdef __cplusplus
}
#endif

#endif
