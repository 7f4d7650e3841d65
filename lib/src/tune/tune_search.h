/* SPDX-License-Identifier: MIT
 * tune/tune_search.h - the whole swept search, from what its method has scored first to the end of the budget. */
#ifndef STAD_TUNE_SEARCH_H
#define STAD_TUNE_SEARCH_H

#include "tune/tune_core.h"

/* Descends from the best point met so far and, unless one descent is all that is asked for, goes further. */
void stad_tune_search(stad_tune *t);

#endif
