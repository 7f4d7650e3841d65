/* SPDX-License-Identifier: MIT
 * tune/tune_hybrid.c - a coarse random search, then the swept descent from the best it found. */
#include "tune/tune_random.h"
#include "tune/tune_search.h"

/* A random point: continuous axes uniform in their variable, discrete ones among their values. */
static void random_point(const stad_tune *t, uint32_t *state, stad_point *x)
{
    stad_point lo, hi;
    tune_vars v, from, to;
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        lo.v[i] = t->config.axis[i].lo;
        hi.v[i] = t->config.axis[i].hi;
    }
    stad_tune_to_vars(&t->config, &lo, &from);
    stad_tune_to_vars(&t->config, &hi, &to);
    for (int i = 0; i < STAD_TUNE_DIMS; i++) { /* an area of the largest block may end below where that of the smallest begins */
        const int rising = from.v[i] <= to.v[i];
        v.v[i] = stad_tune_between(state, rising ? from.v[i] : to.v[i], rising ? to.v[i] : from.v[i]);
    }
    stad_tune_to_point(t, &v, x);
}

static void run(stad_tune *t)
{
    uint32_t state = t->config.seed ? t->config.seed : 1;
    int32_t cost;
    if (!stad_tune_look(t, &t->start, &cost))
        return;
    const int draws = t->config.budget / 4;
    for (int k = 0; k < draws; k++) {
        stad_point x;
        random_point(t, &state, &x);
        if (!stad_tune_look(t, &x, &cost))
            return;
    }
    stad_tune_search(t);
}

int stad_tune_hybrid_init(stad_tune *t, const stad_tune_config *c, const stad_point *start)
{
    return stad_tune_core_init(t, c, start, STAD_TUNE_HYBRID);
}

int stad_tune_hybrid_tell(stad_tune *t, int32_t cost_q20)
{
    const int status = stad_tune_core_turn(t, cost_q20);
    if (status == STAD_OK)
        run(t);
    return status;
}
