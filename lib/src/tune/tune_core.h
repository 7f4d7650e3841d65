/* SPDX-License-Identifier: MIT
 * tune/tune_core.h - what all methods share: the log, and the walk between variables and lattice points.
 *
 * A method is written as one plain function from the start to the end of the search. It gets costs from stad_tune_look();
 * when the log has no answer it returns at once, and after the next tell it runs again from the start: everything it did
 * before is answered from the log, so it comes by the same path to the same place and goes on. The state of a search is
 * therefore its log and nothing else. A rerun is some hundred thousand integer operations late in a search: little beside scoring
 * a frame. */
#ifndef STAD_TUNE_CORE_H
#define STAD_TUNE_CORE_H

#include "stad/tune.h"

/* stad_tune.phase */
enum tune_phase { TUNE_PHASE_NONE = 0, TUNE_PHASE_ASKING = 1, TUNE_PHASE_FINISHED = 2 };

#define TUNE_ONE      65536 /* one step of a continuous variable, Q16 */
#define TUNE_INFINITY INT32_MAX

/* Variables: continuous axes in steps, Q16; discrete axes hold their integer. */
typedef struct tune_vars {
    int32_t v[STAD_TUNE_DIMS];
} tune_vars;

int stad_tune_core_init(stad_tune *t, const stad_tune_config *c, const stad_point *start, int method);

/* Records a cost for the pending point. STAD_OK: the caller runs its method again from the start; the search is finished unless
 * that asks for a point. */
int stad_tune_core_turn(stad_tune *t, int32_t cost_q20);

/* The cost of x. 1: *cost is set; 0: not known, the method must return at once. */
int stad_tune_look(stad_tune *t, const stad_point *x, int32_t *cost);

/* Scores the start and its ladder. 0: a cost is wanted. */
int stad_tune_score_ladder(stad_tune *t);

int stad_tune_is_free(const stad_tune_config *c, int i);
int stad_tune_is_continuous(const stad_tune_config *c, int i);

/* Both: an axis that sweeps and steps walk. */
int stad_tune_is_swept(const stad_tune *t, int i);

/* Variables to the nearest allowed lattice point and back. */
void stad_tune_to_point(const stad_tune *t, const tune_vars *v, stad_point *x);
void stad_tune_to_vars(const stad_tune_config *c, const stad_point *x, tune_vars *v);

/* Room of continuous variable i from v towards `side`, Q16 steps, >= 0. */
int32_t stad_tune_room(const stad_tune *t, const tune_vars *v, int i, int side);

int stad_tune_same(const stad_point *a, const stad_point *b);

/* The log entry that holds x, or -1. */
int stad_tune_find(const stad_tune *t, const stad_point *x);

#endif
