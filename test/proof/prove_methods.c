/* SPDX-License-Identifier: MIT
 * proof/prove_methods.c - every method of the tuner told any cost in the midst of any search: its descents, random points and crosses,
 * and the textbook ones; the log behind them.
 * SOURCES: tune/tune.c tune/tune_ncg.c tune/tune_descent.c tune/tune_once.c tune/tune_ladder.c tune/tune_search.c tune/tune_hybrid.c tune/tune_cross.c tune/tune_random.c tune/tune_paper.c tune/tune_sd.c tune/tune_wolfe.c tune/tune_check.c tune/tune_lattice.c tune/tune_config.c base/log.c base/divide.c
 * PRECISION: 1
 * OPTIONS: -eva-min-loop-unroll 42 -eva-slevel 0 -eva-domains equality
 * KNOWN: division by zero. assert b->v[i]
 * GUARD: tune/tune_config.c return a->lo >= 1;
 * GUARD: tune/tune_check.c !in_box(t, &t->point[i])
 * A power's range begins at 1, and so do the points of the log, of a kept one too; the log is one heap of points here.
 *
 * In the place of walks, joint steps and line searches stand the states that they leave: prove_walk.c, prove_step.c, prove_wolfe.c. */
#define PROVE_WITH_LOGARITHMS
#include "proof/prove_tune.h"
#define stad_tune_look look_in_log
#include "tune/tune_log.c"
#undef stad_tune_look
#include "tune/tune_wolfe.h"

/* prove_tune.c is about the log itself. A cost is set even where the method must not look at it. */
int stad_tune_look(stad_tune *tune, const stad_point *x, int32_t *cost)
{
    (void)x;
    tune->lead = (int16_t)any(0, STAD_TUNE_LOG - 1);
    tune->cursor = (int16_t)any(0, STAD_TUNE_LOG);
    tune->counts.calls = any(0, 1 << 20);
    *cost = any(0, INT32_MAX);
    return any(0, 1);
}

static int any_way(const stad_tune *tune, tune_walk *w)
{
    const int32_t step = w->step;
    (void)tune;
    *w = any_walk();
    w->step = step;
    return any(0, 1);
}

void stad_tune_walk_from(const stad_tune *tune, tune_walk *w, const stad_point *x, int32_t cost, int32_t reach)
{
    //@ assert 0 <= cost && 65536 / 8 <= reach <= 3 * 65536 / 4;
    w->step = reach;
    any_way(tune, w);
    w->x = *x;
}

int stad_tune_sweep_axis(stad_tune *tune, tune_walk *w, int i)
{
    //@ assert 0 <= i < 6 && 65536 / 8 <= w->step <= 3 * 65536 / 4;
    (void)i;
    return any_way(tune, w);
}

int stad_tune_poll(stad_tune *tune, tune_walk *w, int i, int *moved)
{
    //@ assert 0 <= i < 6;
    (void)i;
    *moved = any(0, 1);
    return any_way(tune, w);
}

int stad_tune_leap(stad_tune *tune, tune_walk *w, int parts, int *moved)
{
    //@ assert 1 <= parts <= 4;
    (void)parts;
    *moved = any(0, 1);
    return any_way(tune, w);
}

int stad_tune_joint_step(stad_tune *tune, tune_walk *w)
{
    return any_way(tune, w);
}

int stad_tune_follow(stad_tune *tune, tune_walk *w, const tune_vars *from)
{
    (void)from;
    return any_way(tune, w);
}

void stad_tune_wolfe_from(const stad_tune *tune, const stad_point *x, int32_t *z)
{
    (void)tune, (void)x;
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        z[i] = any(-(1 << 27), 1 << 27);
}

int stad_tune_wolfe_cost(stad_tune *tune, const int32_t *z, int32_t *cost)
{
    (void)tune, (void)z;
    *cost = any(0, INT32_MAX);
    return any(0, 1);
}

int stad_tune_wolfe_gradient(stad_tune *tune, wolfe_way *d, wolfe_spot *s)
{
    (void)tune;
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        s->slope[i] = any(-WOLFE_SLOPE_MOST, WOLFE_SLOPE_MOST);
        d->diff[i] = any(TUNE_ONE / 64, 2 * TUNE_ONE);
    }
    return any(0, 1);
}

int stad_tune_wolfe_search(stad_tune *tune, wolfe_way *d, wolfe_spot *s, int32_t *a_q12, int *moved)
{
    //@ assert 1 <= d->longest <= 1 << 24;
    s->cost = any(0, INT32_MAX);
    stad_tune_wolfe_from(tune, 0, s->z);
    *a_q12 = any(1, 16 * WOLFE_ONE);
    *moved = any(0, 1);
    return stad_tune_wolfe_gradient(tune, d, s);
}

int64_t stad_tune_wolfe_dot(const int32_t *a, const int32_t *b)
{
    int64_t sum = 0;
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        sum += (int64_t)a[i] * b[i];
    return sum;
}

static void prove_method(int method)
{
    any_search(0, method);
    t.config.budget = STAD_TUNE_LOG;
    t.count = (int16_t)any(1, STAD_TUNE_LOG - 1);
    t.phase = TUNE_PHASE_ASKING;
    t.pending = any_point();
    stad_tune_tell(&t, any(INT32_MIN, INT32_MAX));
}

int main(void)
{
    for (int method = STAD_TUNE_NCG; method <= STAD_TUNE_DESCENT; method++)
        prove_method(method);
    stad_tune_check(&t);
    return 0;
}
