/* SPDX-License-Identifier: MIT
 * stad/measure.h - every measure of a disparity map against truth, by the library's scorer. */
#ifndef STAD_MEASURE_H
#define STAD_MEASURE_H

#include "../common/disparity_file.h"
#include "../common/truth_file.h"
#include "stad/score.h"

/* The thresholds that tables use, px. */
#define MEASURE_THRESHOLDS 4
extern const double measure_threshold[MEASURE_THRESHOLDS];

/* Fractions, but for rmse and mae, which are px. `bad` is (wrong + missing) / visible, `bad_estimated` wrong / visible with a
 * disparity; the counts and chow are those of `threshold`. docs/TUNING.md defines them all. */
typedef struct measures {
    double bad[MEASURE_THRESHOLDS], bad_estimated[MEASURE_THRESHOLDS];
    double threshold, bad_at_threshold, chow;
    double d1, d1_estimated, rmse, mae, density;
    stad_score_counts counts;
} measures;

/* Sizes must agree. TOOL_USAGE when no pixel at all can be scored. */
int measure(measures *m, const disparity *d, const truth_map *t, int num_disparities, double threshold, tool_fail *f);

/* The same but for the lists of `bad`. */
int measure_at(measures *m, const disparity *d, const truth_map *t, int num_disparities, double threshold, tool_fail *f);

/* Feeds a whole map to a score under way. */
void measure_feed(stad_score *s, const disparity *d, const truth_map *t);

#endif
