/* SPDX-License-Identifier: MIT
 * bytes -> [CHECK] -> tell         tune/tune_check.c - whether bytes that were kept elsewhere are a tuner's state. */
#include "stad/tune.h"

static int in(int32_t v, int32_t lo, int32_t hi)
{
    return v >= lo && v <= hi;
}

int stad_tune_check(const stad_tune *t)
{
    if (t->phase == 0)
        return STAD_E_STATE;
    if (!in(t->phase, 1, 2) || stad_tune_config_check(&t->config, 0) != STAD_OK || !in(t->count, 0, STAD_TUNE_LOG))
        return STAD_E_CORRUPT;
    if (!in(t->best, -1, t->count - 1) || !in(t->lead, -1, t->count - 1) || !in(t->cursor, 0, t->count))
        return STAD_E_CORRUPT;
    if (t->phase == 1 && t->count >= t->config.budget)
        return STAD_E_CORRUPT;
    for (int i = 0; i < t->count; i++)
        if (t->cost[i] < 0)
            return STAD_E_CORRUPT;
    return STAD_OK;
}
