/* SPDX-License-Identifier: MIT
 * proof/prove_look.h - the log as a walk meets it: any cost, set only where it is had; points of one first value, the same or not. */
#ifndef PROVE_LOOK_H
#define PROVE_LOOK_H

#include "proof/prove_tune.h"

int stad_tune_look(stad_tune *tune, const stad_point *x, int32_t *cost)
{
    (void)tune, (void)x;
    if (any(0, 1))
        return 0;
    *cost = any(0, INT32_MAX);
    return 1;
}

int stad_tune_same(const stad_point *a, const stad_point *b)
{
    return a->v[0] == b->v[0] && any(0, 1);
}

#endif
