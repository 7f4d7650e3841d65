/* SPDX-License-Identifier: MIT
 * tell -> [DESCENT] -> ask         tune/tune_descent.c - the swept lattice conjugate gradient, until it has converged.
 *
 * From where a method begins: sweep the axes, each giving slope and curvature and moving at once; take one
 * joint step; poll the discrete axes when the sweeps slow down; halve the probing distance when an iteration gains under
 * 0.4 percent. Axes whose probes are cheap are swept first, and settled wherever the others lead. */
#include "tune/tune_descent.h"
#include "tune/tune_switches.h"
#include "tune/tune_walk.h"

#define REACH_LEAST (TUNE_ONE / 8)
#define ITERATIONS  30

/* The sweeps' order: what the matching cost is made of, how it is spread, what is kept of it. */
static const uint8_t sweep_order[STAD_TUNE_DIMS] = {STAD_TUNE_PRE_FILTER_CAP,   STAD_TUNE_P1,         STAD_TUNE_P2,
                                                    STAD_TUNE_UNIQUENESS_RATIO, STAD_TUNE_BLOCK_SIZE, STAD_TUNE_DISP12_MAX_DIFF};

static int is_cheap(const stad_tune *t, int i)
{
    return t->config.free_mask & t->config.cheap_mask & 1 << i;
}

/* Probes the cheap axes around here. */
static int probe_cheap(stad_tune *t, tune_walk *w)
{
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        int moved;
        if (is_cheap(t, i) &&
            !(stad_tune_is_continuous(&t->config, i) ? stad_tune_sweep_axis(t, w, i) : stad_tune_poll(t, w, i, &moved)))
            return 0;
    }
    return 1;
}

/* The same at the distance of now and at the least. */
static int settle(stad_tune *t, tune_walk *w)
{
    const int32_t step = w->step;
    if (!probe_cheap(t, w))
        return 0;
    w->step = REACH_LEAST;
    if (!probe_cheap(t, w))
        return 0;
    w->step = step;
    return 1;
}

static int sweep_all(stad_tune *t, tune_walk *w)
{
    if (!probe_cheap(t, w))
        return 0;
    for (int k = 0; k < STAD_TUNE_DIMS; k++) {
        const int i = sweep_order[k];
        const int32_t before = w->cost;
        if (is_cheap(t, i) || !stad_tune_is_swept(t, i))
            continue;
        if (!stad_tune_sweep_axis(t, w, i) || (w->cost < before && !settle(t, w)))
            return 0;
    }
    return 1;
}

/* Polls every discrete axis of the given scale. */
static int poll_all(stad_tune *t, tune_walk *w, int scale, int *moved)
{
    *moved = 0;
    for (int i = 0; TUNE_POLLS && i < STAD_TUNE_DIMS; i++) {
        int m;
        if (!stad_tune_is_free(&t->config, i) || t->config.axis[i].scale != scale)
            continue;
        if (!stad_tune_poll(t, w, i, &m))
            return 0;
        *moved |= m;
    }
    return 1;
}

/* After the block has moved the smoothness terms bend anew. */
static void forget_curve(const stad_tune *t, tune_walk *w)
{
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        if (t->config.axis[i].scale == STAD_TUNE_AREA)
            w->curve[i] = 0;
    }
    w->has_old = 0;
}

/* After an iteration that brought little: another block, at the least step a leap, or else finer steps. *done: none is left. */
static int go_finer(stad_tune *t, tune_walk *w, int32_t reach, int *done)
{
    const int least = w->step <= REACH_LEAST;
    int moved = 0, leapt = 0;
    if ((least || w->step == reach) && !poll_all(t, w, STAD_TUNE_ODD, &moved))
        return 0;
    if (least && !stad_tune_leap(t, w, 1, &leapt))
        return 0;
    *done = least && !moved && !leapt;
    if (moved || leapt) {
        forget_curve(t, w);
        w->step = least ? TUNE_REACH_AGAIN : w->step;
    } else {
        w->step = w->step / 2 > REACH_LEAST ? w->step / 2 : REACH_LEAST;
        w->has_old = 0;
    }
    return 1;
}

int stad_tune_descend(stad_tune *t, tune_walk *w, int entry, int32_t reach, int32_t goal)
{
    int32_t polled_at = t->cost[entry];
    int moved, done = 0;
    stad_tune_walk_from(t, w, &t->point[entry], t->cost[entry], reach);
    for (int k = 1; k <= ITERATIONS && !done; k++) {
        const int32_t before = w->cost;
        const tune_vars from = w->at;
        t->counts.iterations++;
        if (w->cost < polled_at - polled_at / 33) {
            if (!poll_all(t, w, STAD_TUNE_ODD, &moved))
                return 0;
            if (moved)
                forget_curve(t, w);
            polled_at = w->cost;
        }
        if (2 * w->step <= reach && !poll_all(t, w, STAD_TUNE_POWER, &moved))
            return 0;
        if (!sweep_all(t, w) || (TUNE_JOINT && !stad_tune_joint_step(t, w)))
            return 0;
        if (TUNE_FOLLOW && !stad_tune_follow(t, w, &from))
            return 0;
        if ((k == 1 || w->cost < before) && !settle(t, w))
            return 0;
        if (w->cost > goal && before - w->cost < w->cost - goal) /* another gain like this would not do */
            return 1;
        if (before - w->cost <= before / 250 && !go_finer(t, w, reach, &done))
            return 0;
        if ((k & 3) == 0)
            w->has_old = 0;
    }
    return 1;
}
