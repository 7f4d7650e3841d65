/* SPDX-License-Identifier: MIT
 * tune/tune_sd.c - steepest descent with the line search of tune_paper.c. */
#include "tune/tune_wolfe.h"

int stad_tune_sd_init(stad_tune *t, const stad_tune_config *c, const stad_point *start)
{
    return stad_tune_core_init(t, c, start, STAD_TUNE_SD);
}

int stad_tune_sd_tell(stad_tune *t, int32_t cost_q20)
{
    const int status = stad_tune_core_turn(t, cost_q20);
    if (status == STAD_OK)
        stad_tune_wolfe_run(t, 0);
    return status;
}
