/* SPDX-License-Identifier: MIT
 * calib/calib_parts.h - what the files of calib/ share. The pump's phases are in stad/calib.h. */
#ifndef STAD_CALIB_PARTS_H
#define STAD_CALIB_PARTS_H

#include "stad/calib.h"

/* -- health.c: can these views be used at all? Remembers them in view[0] and view[1]. Returns enum stad_calib_fault. */
int stad_calib_views_fault(const stad_calib *c, stad_calib_view *view, const stad_image *left, const stad_image *right);

/* 1: size and channels are the geometry's. */
int stad_calib_size_fits(const stad_calib *c, const stad_image *image);

/* -- pairs.c */
/* What is left of the rows' disagreement of `count` raw pairs with a correction applied; `room` for as many. Returns
 * enum stad_rig_verdict. */
int stad_calib_rig_verdict(const stad_rig *rig, const stad_pair *pairs, int count, stad_pair *room, stad_rig_report *report);
/* By the mean move, since the tuning frame, of the corners that both frames show, in the left view; a frame that
 * shares no mark is another pose for certain. */
int stad_calib_is_another_pose(const stad_calib *c, const stad_pair *pairs, int count);

/* 1: no mark has moved by a quarter of a pixel, in the left view, since the last frame in the pool. */
int stad_calib_is_still(const stad_calib *c, const stad_pair *pairs, int count);

/* -- collect.c: patience has run out, or the set in use cannot be matched: keep what is proven so far. */
void stad_calib_give_up(stad_calib *c);

/* -- points.c: parameters as the tuner's points */
stad_point stad_calib_point_of(const stad_params *params);
stad_params stad_calib_params_at(const stad_params *base, const stad_point *point);
int stad_calib_point_equal(const stad_point *a, const stad_point *b);
int stad_calib_fits(const stad_geometry *g, const stad_params *params); /* 1: the live matcher would take them */
void stad_calib_tune_config(const stad_calib *c, int budget, stad_tune_config *out);

/* -- presets.c */
int32_t stad_calib_handicap_q16(int i); /* by how much the target flatters preset i; 0 for any other number */

/* -- rule.c: costs into decisions */
int32_t stad_calib_raised(int32_t cost_q20, int64_t by_q16);
int32_t stad_calib_penalised(const stad_point *start, const stad_point *x, int32_t cost_q20, int32_t lambda_q16);
int32_t stad_calib_margin(int32_t cost_q20, int32_t pixels, int32_t least_q20);
int stad_calib_is_better(int32_t now_q20, int32_t was_q20, int32_t margin_q20); /* now + margin <= was, which was measured */

/* -- trial.c: the phases that ask for matches */
void stad_calib_trial_begin(stad_calib *c);                          /* enters PICK */
void stad_calib_trial_point(const stad_calib *c, stad_point *point); /* what the open MATCH is about */
int stad_calib_trial_hold(const stad_calib *c);
void stad_calib_trial_cost(stad_calib *c, int32_t cost_q20);

/* -- calib.c: how phases end */
void stad_calib_enter(stad_calib *c, int phase);
void stad_calib_finish(stad_calib *c, int outcome);
void stad_calib_adopt(stad_calib *c); /* candidate becomes active; asks for the save */
void stad_calib_roll_back(stad_calib *c);

#endif
