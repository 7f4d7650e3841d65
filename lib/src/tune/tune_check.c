/* SPDX-License-Identifier: MIT
 * bytes -> [CHECK] -> tell         tune/tune_check.c - whether bytes that were kept elsewhere are a tuner's state. */
#include "tune/tune_core.h"

static int in(int32_t v, int32_t lo, int32_t hi)
{
    return v >= lo && v <= hi;
}

/* Free coordinates within their axes, the others those of the start: as every point asked for. */
static int in_box(const stad_tune *t, const stad_point *x)
{
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        const stad_tune_axis *a = &t->config.axis[i];
        if (stad_tune_is_free(&t->config, i) ? !in(x->v[i], a->lo, a->hi) : x->v[i] != t->start.v[i])
            return 0;
    }
    return 1;
}

int stad_tune_check(const stad_tune *t)
{
    if (t->phase == TUNE_PHASE_NONE)
        return STAD_E_STATE;
    if (!in(t->phase, TUNE_PHASE_ASKING, TUNE_PHASE_FINISHED) || stad_tune_config_check(&t->config, 0) != STAD_OK ||
        !in(t->count, 0, STAD_TUNE_LOG))
        return STAD_E_CORRUPT;
    if (!in(t->best, -1, t->count - 1) || !in(t->lead, -1, t->count - 1) || !in(t->cursor, 0, t->count))
        return STAD_E_CORRUPT;
    if (t->phase == TUNE_PHASE_ASKING && t->count >= t->config.budget)
        return STAD_E_CORRUPT;
    if (!in_box(t, &t->start) || !in_box(t, &t->pending))
        return STAD_E_CORRUPT;
    for (int i = 0; i < t->count; i++)
        if (t->cost[i] < 0 || !in_box(t, &t->point[i]))
            return STAD_E_CORRUPT;
    return STAD_OK;
}
