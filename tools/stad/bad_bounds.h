/* SPDX-License-Identifier: MIT
 * stad/bad_bounds.h - `bad` of many disparity maps of one scene: what is right at each pixel is found once. */
#ifndef STAD_BAD_BOUNDS_H
#define STAD_BAD_BOUNDS_H

#include "../common/disparity_file.h"
#include "../common/truth_file.h"
#include "stad/score.h"

/* The least and the most disparity, q4, that is right at each pixel; all of them where none is counted. */
typedef struct bad_bounds {
    int16_t *least, *most;
    int32_t visible; /* pixels that are counted */
} bad_bounds;

/* Of this truth at a score's range and threshold. */
int bad_bounds_make(bad_bounds *b, const truth_map *t, const stad_score_config *c, tool_fail *f);
void bad_bounds_free(bad_bounds *b);

/* Visible pixels of a map that are wrong or missing: what a score counts as wrong_visible + missing_visible. */
int32_t bad_bounds_count(const bad_bounds *b, const disparity *d);

#endif
