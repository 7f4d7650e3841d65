/* SPDX-License-Identifier: MIT
 * tune/tune_ncg.h - the descents of the swept search, for methods that choose where to start. */
#ifndef STAD_TUNE_NCG_H
#define STAD_TUNE_NCG_H

#include "tune/tune_core.h"

/* Descends from the best point met so far, then again as tune_ncg.c says. `rungs`: how many entries of the log are starts. */
void stad_tune_ncg_descents(stad_tune *t, int rungs);

#endif
