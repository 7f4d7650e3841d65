/* SPDX-License-Identifier: MIT
 * tune/tune_paper.c - nonlinear conjugate gradient as the literature writes it: PR+ and strong Wolfe. */
#include "tune/tune_wolfe.h"

int stad_tune_paper_init(stad_tune *t, const stad_tune_config *c, const stad_point *start)
{
    return stad_tune_core_init(t, c, start, STAD_TUNE_NCG_PAPER);
}

int stad_tune_paper_tell(stad_tune *t, int32_t cost_q20)
{
    const int status = stad_tune_core_turn(t, cost_q20);
    if (status == STAD_OK)
        stad_tune_wolfe_run(t, 1);
    return status;
}
