/* SPDX-License-Identifier: MIT
 * tune/tune_descent.h - one descent of the swept search, for methods that choose where to start and how to go on. */
#ifndef STAD_TUNE_DESCENT_H
#define STAD_TUNE_DESCENT_H

#include "tune/tune_walk.h"

#define TUNE_REACH_FIRST (3 * TUNE_ONE / 4) /* first probing distances: from afar, */
#define TUNE_REACH_AGAIN (TUNE_ONE / 2)     /* and from where something has been gained */

/* Descends from a log entry until nothing is gained at the least probing distance, or until another iteration like the last would
 * not come below `goal`. 1: converged, and w is where it ended; 0: a cost is wanted. */
int stad_tune_descend(stad_tune *t, tune_walk *w, int entry, int32_t reach, int32_t goal);

#endif
