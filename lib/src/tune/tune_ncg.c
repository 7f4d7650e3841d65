/* SPDX-License-Identifier: MIT
 * tune/tune_ncg.c - the swept lattice search (first form: coordinate sweeps and polls). */
#include "tune/tune_core.h"

typedef struct walk {
    tune_vars at;
    int32_t cost;
} walk;

/* Tries a point; moves there when it is better. 0: not known yet. */
static int attempt(stad_tune *t, walk *w, const tune_vars *v, int *moved)
{
    stad_point x;
    int32_t cost;
    stad_tune_to_point(t, v, &x);
    if (!stad_tune_look(t, &x, &cost))
        return 0;
    *moved = cost < w->cost;
    if (*moved) {
        stad_tune_to_vars(&t->config, &x, &w->at);
        w->cost = cost;
    }
    return 1;
}

static int sweep(stad_tune *t, walk *w, int32_t step, int *gained)
{
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        if (!stad_tune_is_free(&t->config, i))
            continue;
        for (int k = 0; k < 2; k++) {
            const int side = k == 0 ? t->config.axis[i].side : -t->config.axis[i].side;
            tune_vars v = w->at;
            int moved = 0;
            if (stad_tune_is_continuous(&t->config, i))
                v.v[i] += side * step;
            else if (t->config.axis[i].scale == STAD_TUNE_ODD)
                v.v[i] += 2 * side;
            else
                v.v[i] = side > 0 ? v.v[i] * 2 : v.v[i] / 2;
            if (!attempt(t, w, &v, &moved))
                return 0;
            *gained |= moved;
            if (moved)
                break;
        }
    }
    t->counts.iterations++;
    return 1;
}

static void run(stad_tune *t)
{
    walk w;
    stad_tune_to_vars(&t->config, &t->start, &w.at);
    if (!stad_tune_look(t, &t->start, &w.cost))
        return;
    for (int32_t step = TUNE_ONE; step >= TUNE_ONE / 8;) {
        int gained = 0;
        if (!sweep(t, &w, step, &gained))
            return;
        if (!gained)
            step /= 2;
    }
}

int stad_tune_ncg_init(stad_tune *t, const stad_tune_config *c, const stad_point *start)
{
    return stad_tune_core_init(t, c, start, STAD_TUNE_NCG);
}

int stad_tune_ncg_tell(stad_tune *t, int32_t cost_q20)
{
    const int status = stad_tune_core_record(t, cost_q20);
    if (status != STAD_OK)
        return status;
    stad_tune_core_rewind(t);
    run(t);
    return STAD_OK;
}
