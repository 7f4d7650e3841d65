/* SPDX-License-Identifier: MIT
 * tune/tune_descent.h - the descents of the swept search, for methods that choose where to start or how to go on. */
#ifndef STAD_TUNE_DESCENT_H
#define STAD_TUNE_DESCENT_H

#include "tune/tune_core.h"

/* Descends from the best point met so far, then again as tune_descent.c says. `rungs`: how many entries of the log are starts.
 * 1: converged, there is budget left; 0: a cost is wanted, or one descent was all that was asked for. */
int stad_tune_descents(stad_tune *t, int rungs);

/* The same from the start and its ladder, which are scored first. */
int stad_tune_descend_ladder(stad_tune *t);

#endif
