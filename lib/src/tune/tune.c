/* SPDX-License-Identifier: MIT
 * tune/tune.c - chooses the method by the config; the only file that links them all. */
#include "stad/tune.h"

int stad_tune_init(stad_tune *t, const stad_tune_config *c, const stad_point *start)
{
    switch (c->method) {
    case STAD_TUNE_NCG_PAPER:
        return stad_tune_paper_init(t, c, start);
    case STAD_TUNE_SD:
        return stad_tune_sd_init(t, c, start);
    case STAD_TUNE_HYBRID:
        return stad_tune_hybrid_init(t, c, start);
    case STAD_TUNE_DESCENT:
        return stad_tune_descent_init(t, c, start);
    default:
        return stad_tune_ncg_init(t, c, start); /* refuses what is none of these */
    }
}

int stad_tune_tell(stad_tune *t, int32_t cost_q20)
{
    switch (t->config.method) {
    case STAD_TUNE_NCG_PAPER:
        return stad_tune_paper_tell(t, cost_q20);
    case STAD_TUNE_SD:
        return stad_tune_sd_tell(t, cost_q20);
    case STAD_TUNE_HYBRID:
        return stad_tune_hybrid_tell(t, cost_q20);
    case STAD_TUNE_DESCENT:
        return stad_tune_descent_tell(t, cost_q20);
    default:
        return stad_tune_ncg_tell(t, cost_q20);
    }
}
