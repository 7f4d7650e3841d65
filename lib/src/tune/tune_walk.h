/* SPDX-License-Identifier: MIT
 * tune/tune_walk.h - a descent: where it stands, and what it has learnt of the slope there.
 *
 * Slopes are cost per step, Q20; curvatures cost per step squared, Q20; distances steps in Q16. Differences of costs are held
 * to +-2^24, so a failed evaluation is a steep wall and not an overflow. Every function returns 0 when a cost it needs is not
 * known yet; the caller then returns at once (tune_core.h). */
#ifndef STAD_TUNE_WALK_H
#define STAD_TUNE_WALK_H

#include "tune/tune_core.h"

typedef struct tune_walk {
    stad_point x;
    int32_t cost;
    tune_vars at;
    int32_t slope[STAD_TUNE_DIMS];
    int32_t curve[STAD_TUNE_DIMS];     /* 0: unknown or not convex */
    int32_t old_slope[STAD_TUNE_DIMS]; /* at the last joint step, and its direction */
    int32_t old_move[STAD_TUNE_DIMS];
    int64_t old_fall;            /* old_slope . its scaled steepest way, positive */
    int32_t step;                /* probing distance, Q16 */
    int8_t side[STAD_TUNE_DIMS]; /* where to look first */
    uint8_t has_old;             /* the old_ fields hold */
} tune_walk;

/* Starts a descent at x. `reach`: the first probing distance, Q16 of a step. */
void stad_tune_walk_from(const stad_tune *t, tune_walk *w, const stad_point *x, int32_t cost, int32_t reach);

/* Puts the walk at a point it has seen. */
void stad_tune_walk_move(const stad_tune *t, tune_walk *w, const stad_point *x, int32_t cost);

/* Slope and curvature on continuous axis i from one to three points, moving to the best of them. */
int stad_tune_sweep_axis(stad_tune *t, tune_walk *w, int i);

/* One joint step along the scaled conjugate direction. */
int stad_tune_joint_step(stad_tune *t, tune_walk *w);

/* Goes on by the way of this iteration, from `from` to here, as long as it pays. */
int stad_tune_follow(stad_tune *t, tune_walk *w, const tune_vars *from);

/* Tries the two neighbours of discrete axis i, the side of the last success first; moves to the first that is better, on an axis of
 * powers as far as that pays. */
int stad_tune_poll(stad_tune *t, tune_walk *w, int i, int *moved);

/* Tries the ends of `parts` parts of each plain logarithmic axis, and with more parts than one of each linear axis; moves to what
 * is better. Costs have a second valley there: on some scenes the pre-filter cap works nearly as well at 15 as at 127, and badly
 * between, on some the uniqueness at 0 and at 20. */
int stad_tune_leap(stad_tune *t, tune_walk *w, int parts, int *moved);

/* to - from as costs, held to +-2^24. */
int32_t stad_tune_rise(int32_t from, int32_t to);

/* a * 65536 / b and clipped to int32, b != 0. */
int32_t stad_tune_div_q16(int64_t a, int64_t b);

#endif
