/* SPDX-License-Identifier: MIT
 * tell -> [ONCE] -> ask         tune/tune_once.c - the swept lattice conjugate gradient until it has converged: method DESCENT. */
#include "tune/tune_descent.h"

int stad_tune_descent_init(stad_tune *t, const stad_tune_config *c, const stad_point *start)
{
    return stad_tune_core_init(t, c, start, STAD_TUNE_DESCENT);
}

int stad_tune_descent_tell(stad_tune *t, int32_t cost_q20)
{
    tune_walk w;
    const int status = stad_tune_core_turn(t, cost_q20);
    if (status == STAD_OK && stad_tune_score_ladder(t))
        stad_tune_descend(t, &w, t->lead, TUNE_REACH_FIRST, TUNE_INFINITY);
    return status;
}
