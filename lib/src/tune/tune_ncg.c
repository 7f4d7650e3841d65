/* SPDX-License-Identifier: MIT
 * tell -> [NCG] -> ask         tune/tune_ncg.c - the swept lattice conjugate gradient, and what goes further when it has
 * converged. */
#include "tune/tune_descent.h"
#include "tune/tune_search.h"

int stad_tune_ncg_init(stad_tune *t, const stad_tune_config *c, const stad_point *start)
{
    return stad_tune_core_init(t, c, start, STAD_TUNE_NCG);
}

int stad_tune_ncg_tell(stad_tune *t, int32_t cost_q20)
{
    const int status = stad_tune_core_turn(t, cost_q20);
    if (status == STAD_OK && stad_tune_score_ladder(t))
        stad_tune_search(t);
    return status;
}
