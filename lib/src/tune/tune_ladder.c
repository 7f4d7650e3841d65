/* SPDX-License-Identifier: MIT
 * config -> [LADDER] -> descent         tune/tune_ladder.c - the points that are scored before a search sets out. */
#include "tune/tune_core.h"

int stad_tune_score_ladder(stad_tune *t)
{
    int32_t cost;
    if (!stad_tune_look(t, &t->start, &cost))
        return 0;
    for (int i = 0; i < t->config.ladder_count; i++) {
        stad_point x;
        tune_vars v;
        stad_tune_to_vars(&t->config, &t->config.ladder[i], &v);
        stad_tune_to_point(t, &v, &x);
        if (!stad_tune_look(t, &x, &cost))
            return 0;
    }
    return 1;
}
