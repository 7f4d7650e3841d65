/* SPDX-License-Identifier: MIT
 * tune/tune_cross.h - what is left of a budget after the descents. */
#ifndef STAD_TUNE_CROSS_H
#define STAD_TUNE_CROSS_H

#include "tune/tune_core.h"

/* Asks for a new point made of good ones, until the budget is spent or no new one is found. */
void stad_tune_cross(stad_tune *t);

#endif
