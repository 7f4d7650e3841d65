/* SPDX-License-Identifier: MIT
 * tell -> [LOG] -> ask         tune/tune_log.c - the log of points and costs, which is the state of a search. */
#include "tune/tune_core.h"

#include <string.h>

#include "base/bytes.h"

int stad_tune_same(const stad_point *a, const stad_point *b)
{
    return bytes_equal(a, b, sizeof *a);
}

int stad_tune_core_init(stad_tune *t, const stad_tune_config *c, const stad_point *start, int method)
{
    memset(t, 0, sizeof *t); /* padding too: equal states are equal bytes */
    t->best = -1;
    t->lead = -1;
    t->phase = TUNE_PHASE_FINISHED;
    if (stad_tune_config_check(c, NULL) != STAD_OK || c->method != method)
        return STAD_E_PARAM;
    memcpy(&t->config, c, sizeof *c);
    t->start = *start;
    tune_vars v;
    stad_tune_to_vars(c, start, &v);
    stad_tune_to_point(t, &v, &t->start);
    t->pending = t->start;
    t->phase = TUNE_PHASE_ASKING;
    return STAD_OK;
}

int stad_tune_ask(const stad_tune *t, stad_point *x)
{
    if (t->phase != TUNE_PHASE_ASKING)
        return 0;
    *x = t->pending;
    return 1;
}

static void rewind_log(stad_tune *t)
{
    t->phase = TUNE_PHASE_FINISHED;
    t->cursor = 0;
    t->lead = -1;
    if (t->cost[t->best < 0 ? 0 : t->best] == 0)
        return; /* the end: nothing is run again */
    t->counts.calls = 0;
    t->counts.iterations = 0;
}

int stad_tune_core_turn(stad_tune *t, int32_t cost_q20)
{
    if (t->phase != TUNE_PHASE_ASKING)
        return STAD_E_STATE;
    if (cost_q20 < 0)
        return STAD_E_PARAM;
    t->point[t->count] = t->pending;
    t->cost[t->count] = cost_q20;
    if (cost_q20 != STAD_COST_FAILED && (t->best < 0 || cost_q20 < t->cost[t->best]))
        t->best = t->count;
    t->count++;
    t->counts.evaluations = t->count;
    rewind_log(t);
    return STAD_OK;
}

/* A rerun meets the points in the order of the log, so the cursor answers most. */
int stad_tune_find(const stad_tune *t, const stad_point *x)
{
    if (t->cursor < t->count && stad_tune_same(&t->point[t->cursor], x))
        return t->cursor;
    for (int i = 0; i < t->count; i++) {
        if (stad_tune_same(&t->point[i], x))
            return i;
    }
    return -1;
}

int stad_tune_look(stad_tune *t, const stad_point *x, int32_t *cost)
{
    if (t->best >= 0 && t->cost[t->best] == 0)
        return 0; /* nothing is better: finished */
    const int i = stad_tune_find(t, x);
    if (i >= 0) {
        t->counts.calls++;
        t->cursor = (int16_t)(i == t->cursor ? i + 1 : t->cursor);
        if (t->lead < 0 || t->cost[i] < t->cost[t->lead])
            t->lead = (int16_t)i;
        *cost = t->cost[i];
        return 1;
    }
    if (t->count < t->config.budget) {
        t->counts.calls++;
        t->pending = *x;
        t->phase = TUNE_PHASE_ASKING;
    }
    return 0;
}

int stad_tune_best(const stad_tune *t, stad_point *x, int32_t *cost_q20)
{
    if (t->best < 0)
        return STAD_E_STATE;
    if (x)
        *x = t->point[t->best];
    if (cost_q20)
        *cost_q20 = t->cost[t->best];
    return STAD_OK;
}

int stad_tune_trace(const stad_tune *t, int i, stad_point *x, int32_t *cost_q20)
{
    if (i < 0 || i >= t->count)
        return STAD_E_PARAM;
    *x = t->point[i];
    *cost_q20 = t->cost[i];
    return STAD_OK;
}

stad_tune_counts stad_tune_counts_of(const stad_tune *t)
{
    return t->counts;
}
