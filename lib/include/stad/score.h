/* SPDX-License-Identifier: MIT
 * stad/score.h - disparity rows against truth rows: exact counts, and a cost from them.
 *
 * Rows are fed one at a time, in any order, from as many frames as wanted: begin once, feed all rows of all frames, end.
 * No disparity image is kept. All counting is exact: a disparity of 1/16 px and a truth of 1/65536 px are compared as
 * integers, and a cost is one rounded division of two counts. docs/TUNING.md defines every measure.
 *
 * Shapes: a row is `width` elements, x = 0 first, in the left image. Only columns x >= max(min_disparity + num_disparities, 0)
 * are scored: left of them the matcher has part of its range outside the right image.
 * Memory: the caller owns everything; nothing is kept but the struct. Re-entrant. */
#ifndef STAD_SCORE_H
#define STAD_SCORE_H

#include <stdint.h>

#include "stad/cost.h"
#include "stad/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Truth of a pixel that has none. */
#define STAD_TRUTH_NONE INT32_MIN

/* Label of a pixel. */
enum stad_label {
    STAD_LABEL_IGNORED = 0, /* not scored: no truth, or masked out */
    STAD_LABEL_VISIBLE = 1, /* seen by both cameras */
    STAD_LABEL_OCCLUDED = 2 /* its counterpart in the right image is hidden or outside */
};

/* The cost that stad_score_end() returns. `wrong`: |d - truth| > threshold; `missing`: no disparity. */
enum stad_score_cost {
    STAD_SCORE_BAD = 0,     /* (wrong + missing) / visible, over visible pixels */
    STAD_SCORE_CHOW = 1,    /* (2 wrong_visible + 2 wrong_occluded + missing_visible) / (2 (visible + occluded)) */
    STAD_SCORE_D1 = 2,      /* as BAD, but wrong when the error exceeds 3 px and 5 % of the truth */
    STAD_SCORE_RMSE = 3,    /* root mean square error / num_disparities, at most 1. To report: it has many local minima */
    STAD_SCORE_MAE = 4,     /* mean absolute error / num_disparities, at most 1. To report */
    STAD_SCORE_MISSING = 5, /* missing / visible: 1 - density */
    /* the rest needs no truth, only the *_blind calls; `considered`: pixels of scored columns */
    STAD_SCORE_BLIND = 6,    /* reference-free: (considered - matched) / considered + 2 SPECKLE + PHOTO, up to 4 */
    STAD_SCORE_PHOTO = 7,    /* its part: truncated photometric error; a missing pixel counts half the limit */
    STAD_SCORE_SPECKLE = 8,  /* its part: pixels in speckles / considered */
    STAD_SCORE_LR = 9,       /* pixels that fail the left-right check / considered */
    STAD_SCORE_ENTROPY = 10, /* entropy of the disparities in 32 bins, 1 = all bins alike: a flat scene has little */
    STAD_SCORE_WEIGHTED = 11 /* sum of the above, each times its weight */
};
#define STAD_SCORE_TERMS 11 /* the costs that can be weighted */

/* What to count and what to make of it. Start from stad_score_config_init(). */
typedef struct stad_score_config {
    int16_t min_disparity;   /* px, as matched */
    int16_t num_disparities; /* px, as matched, > 0 */
    int32_t threshold_q16;   /* px * 65536, >= 0: an error above it is wrong; 65536 is customary, 3 * 65536 on KITTI 2015 */
    uint8_t cost;            /* enum stad_score_cost */
    uint8_t photo_limit;     /* grey levels, 1..255: a larger photometric error counts as this much; customary 16 */
    int16_t weight_q8[STAD_SCORE_TERMS]; /* STAD_SCORE_WEIGHTED only: weight * 256 of each cost, each >= 0 */
} stad_score_config;

/* Exact counts over scored pixels. Sums are over visible pixels that have a disparity. */
typedef struct stad_score_counts {
    int32_t visible, occluded;                 /* scored pixels by label */
    int32_t wrong_visible, wrong_occluded;     /* with a disparity, error above the threshold */
    int32_t missing_visible, missing_occluded; /* without a disparity */
    int32_t d1_visible, d1_occluded;           /* with a disparity, error above 3 px and above 5 % of the truth */
    int64_t square_sum_q16;                    /* squared errors, px^2 * 65536, of errors rounded to 1/256 px */
    int64_t abs_sum_q16;                       /* absolute errors, px * 65536, exact */
    /* reference-free */
    int32_t considered, matched; /* pixels in scored columns; of these with a disparity */
    int32_t speckle;             /* matched pixels in components that the speckle filter would remove */
    int32_t inconsistent;        /* considered pixels rejected by the left-right check */
    int64_t photo_sum;           /* grey levels * 80: truncated errors, half of photo_limit for a missing pixel */
} stad_score_counts;

/* A scorer. Read `counts` freely; the rest is private. Copyable. */
typedef struct stad_score {
    stad_score_config config; /* as given */
    stad_score_counts counts; /* so far */
    int32_t histogram[32];    /* matched pixels in 32 equal bins of the disparity range, for the entropy */
} stad_score;

/* A customary config: threshold 1 px, photo_limit 16, no weights. The arguments are the fields of these names and within their ranges. */
void stad_score_config_init(stad_score_config *c, int cost, int min_disparity, int num_disparities);

/* Starts a score. STAD_OK, or STAD_E_PARAM when a field is out of the range given at it; then nothing may be fed. */
int stad_score_begin(stad_score *s, const stad_score_config *c);

/* Feeds row y (y is only for symmetry with the matcher: rows may come in any order). `disp_q4_row`: px * 16, where
 * (min_disparity - 1) * 16 and anything below means no disparity. `truth_q16_row`: px * 65536, looked at only where the label is not
 * STAD_LABEL_IGNORED, |truth| < 4096 px there; STAD_TRUTH_NONE is ignored whatever its label. `label_row`: enum stad_label. */
void stad_score_row(stad_score *s, int y, const int16_t *disp_q4_row, const int32_t *truth_q16_row, const uint8_t *label_row,
                    int width);

/* Feeds a row to the reference-free costs: disparities as above and the two grey rows they came from. The photometric error
 * of a pixel is |left(x) - right(x - d)|, each less the mean of the 5 px around it in its row, right interpolated linearly. */
void stad_score_row_blind(stad_score *s, int y, const int16_t *disp_q4_row, const uint8_t *left_row, const uint8_t *right_row,
                          int width);

/* Adds a frame's counters that only the matcher knows: pixels that its speckle filter removed, pixels that its left-right
 * check rejected. */
void stad_score_frame_blind(stad_score *s, int32_t speckle, int32_t inconsistent);

/* The configured cost, Q20, rounded to nearest. STAD_COST_FAILED when its denominator is zero (no pixel scored).
 * More rows may be fed afterwards. */
int32_t stad_score_end(const stad_score *s);

/* Any cost from the same counts: enum stad_score_cost but STAD_SCORE_WEIGHTED. */
int32_t stad_score_cost_of(const stad_score *s, int cost);

/* Root mean square error and mean absolute error over visible pixels with a disparity, px * 65536, rounded; 0 when there
 * are none. */
int32_t stad_score_rmse_q16(const stad_score *s);
int32_t stad_score_mae_q16(const stad_score *s); /* the latter */

/* Labels a row of dense truth. A pixel is occluded when another left pixel of the row whose disparity is more than 1 px
 * larger lands on its right column, or when its column x - d, rounded, is outside the right image; a pixel lands on both
 * columns next to x - d. Pixels of STAD_TRUTH_NONE become STAD_LABEL_IGNORED, the rest visible. `work`: width elements of
 * scratch. For sparse truth, or where a mask is at hand, use that instead: this rule needs the occluder's truth. */
void stad_score_label_row(const int32_t *truth_q16_row, int width, uint8_t *label_row, int32_t *work);

#ifdef __cplusplus
}
#endif

#endif
