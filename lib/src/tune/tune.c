/* SPDX-License-Identifier: MIT
 * tune/tune.c - chooses the method by the config; links them all. */
#include "stad/tune.h"

int stad_tune_init(stad_tune *t, const stad_tune_config *c, const stad_point *start)
{
    return stad_tune_ncg_init(t, c, start);
}

int stad_tune_tell(stad_tune *t, int32_t cost_q20)
{
    return stad_tune_ncg_tell(t, cost_q20);
}
