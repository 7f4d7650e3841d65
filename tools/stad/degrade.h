/* SPDX-License-Identifier: MIT
 * stad/degrade.h - makes good recordings bad, to rehearse what a board would do. */
#ifndef STAD_DEGRADE_H
#define STAD_DEGRADE_H

#include "../common/picture.h"

typedef struct degrade {
    double noise;    /* grey levels, standard deviation, either view on its own */
    double gain;     /* percent, the right view's; 100 = alike */
    double blur;     /* px, standard deviation, both views */
    double vignette; /* percent of light lost in the corners, both views */
    double dim;      /* percent of light lost everywhere, both views */
    int from;        /* first frame */
} degrade;

int degrade_any(const degrade *d);

/* Degrades frame i, grey, in place; the same i gives the same noise. */
int degrade_pair(const degrade *d, int i, picture *left, picture *right, tool_fail *f);

#endif
