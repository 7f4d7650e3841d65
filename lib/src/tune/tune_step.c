/* SPDX-License-Identifier: MIT
 * slopes -> [STEP] -> points         tune/tune_step.c - a joint step along the scaled conjugate direction (PR+).
 *
 * Scaling by the curvature that the probes gave makes the step good; beta adds little (docs/TUNING.md, Ablation). */
#include "tune/tune_switches.h"
#include "tune/tune_walk.h"
#include "base/arith.h"
#include "base/divide.h"

#include <string.h>

#define BETA_ONE   4096 /* Q12 */
#define MAX_MOVE   (3 * TUNE_ONE)
#define MAX_TRIES  3
#define MAX_FOLLOW 8

typedef struct direction {
    int32_t move[STAD_TUNE_DIMS]; /* steps, Q16 */
    int64_t fall;                 /* slope . scaled steepest way, >= 0 */
} direction;

/* The curvature, at least what would send the point two probing distances away, and never next to nothing. */
static int32_t scale_of(const tune_walk *w, int i)
{
    int64_t scale = TUNE_SCALING ? w->curve[i] : 0;
    const int64_t held = stad_div_i64((int64_t)abs_i32(w->slope[i]) * 65536, 2 * (int64_t)w->step);
    const int64_t least = w->cost / 1000;
    scale = scale > held ? scale : held;
    scale = scale > least ? scale : least;
    scale = scale > 104 ? scale : 104; /* 1e-4 in Q20 */
    return scale < INT32_MAX ? (int32_t)scale : INT32_MAX;
}

/* PR+: z . (g - g') / (g' . z'), held to 0..2, Q12. |z| <= 2^18 (twice the probing distance) and |g| <= 2^24: sums stay
 * below 2^46. */
static int64_t beta_q12(const stad_tune *t, const tune_walk *w, const direction *d)
{
    int64_t above = 0;
    if (!w->has_old || !TUNE_BETA || w->old_fall <= 0)
        return 0;
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        above -= stad_tune_is_swept(t, i) ? (int64_t)d->move[i] * ((int64_t)w->slope[i] - w->old_slope[i]) : 0;
    if (above <= 0)
        return 0;
    const int64_t beta = stad_div_i64(above * BETA_ONE, w->old_fall);
    return beta < 2 * BETA_ONE ? beta : 2 * BETA_ONE;
}

static int64_t along(const stad_tune *t, const tune_walk *w, const int32_t *move)
{
    int64_t sum = 0;
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        sum += stad_tune_is_swept(t, i) ? (int64_t)move[i] * w->slope[i] : 0;
    return sum;
}

/* Shortens the direction so that no coordinate moves more than `most`. Returns the longest move. */
static int32_t hold(const stad_tune *t, int32_t *move, int64_t most)
{
    int32_t longest = 0;
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        if (stad_tune_is_swept(t, i) && abs_i32(move[i]) > longest)
            longest = abs_i32(move[i]);
    }
    if (longest <= most)
        return longest;
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        move[i] = (int32_t)stad_div_i64(move[i] * most, longest);
    return (int32_t)most;
}

static void choose_direction(const stad_tune *t, const tune_walk *w, direction *d)
{
    memset(d, 0, sizeof *d);
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        if (stad_tune_is_swept(t, i))
            d->move[i] = -stad_tune_div_q16(w->slope[i], scale_of(w, i));
    }
    d->fall = -along(t, w, d->move);
    const int64_t beta = beta_q12(t, w, d);
    if (beta == 0)
        return;
    int32_t steepest[STAD_TUNE_DIMS];
    memcpy(steepest, d->move, sizeof steepest);
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        d->move[i] += (int32_t)(beta * w->old_move[i] / BETA_ONE);
    if (along(t, w, d->move) >= 0)
        memcpy(d->move, steepest, sizeof steepest);
}

typedef struct trial {
    stad_point x;
    int32_t cost;
    int64_t fall; /* slope . way really taken: what the gradient promises, Q20 */
} trial;

static int try_step(stad_tune *t, const tune_walk *w, const direction *d, int32_t a_q12, trial *out)
{
    tune_vars v = w->at;
    int32_t way[STAD_TUNE_DIMS];
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        v.v[i] += (int32_t)((int64_t)d->move[i] * a_q12 / BETA_ONE);
    stad_tune_to_point(t, &v, &out->x);
    stad_tune_to_vars(&t->config, &out->x, &v);
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        way[i] = v.v[i] - w->at.v[i];
    out->fall = along(t, w, way) / 65536;
    return stad_tune_same(&out->x, &w->x) ? (out->cost = w->cost, 1) : stad_tune_look(t, &out->x, &out->cost);
}

/* The floor of the parabola through f with the promised slope and the trial's cost, Q12. */
static int32_t next_length(const tune_walk *w, const trial *r, int32_t a_q12, int success)
{
    const int64_t bend = stad_tune_rise(w->cost, r->cost) - r->fall;
    if (bend <= 0)
        return success ? 2 * a_q12 : a_q12 / 2;
    const int64_t a = stad_div_i64(-r->fall * a_q12, 2 * bend);
    return a < 0 ? 0 : a > 4 * (int64_t)a_q12 ? 4 * a_q12 : (int32_t)a;
}

/* At most MAX_TRIES points along the direction: expand while it pays, shrink until it does. */
static int line_search(stad_tune *t, tune_walk *w, const direction *d, int32_t longest)
{
    trial best = {w->x, w->cost, 0};
    int32_t a = BETA_ONE;
    for (int k = 1; k <= MAX_TRIES; k++) {
        trial r;
        if (!try_step(t, w, d, a, &r))
            return 0;
        const int64_t wanted = stad_div_i64(r.fall, 10);
        const int success = r.cost < w->cost && stad_tune_rise(w->cost, r.cost) <= wanted;
        int32_t next = next_length(w, &r, a, success);
        const int leads = r.cost < best.cost;
        if (leads)
            best = r;
        if (success) {
            next = next < 5 * a / 2 ? next : 5 * a / 2;
            if (5 * next <= 7 * a || !leads)
                break;
        } else {
            if (best.cost < w->cost)
                break;
            next = next < a / 5 ? a / 5 : next > 3 * a / 5 ? 3 * a / 5 : next;
            if ((int64_t)longest * next / BETA_ONE < TUNE_ONE / 16)
                break;
        }
        a = next;
    }
    if (best.cost < w->cost)
        stad_tune_walk_move(t, w, &best.x, best.cost);
    return 1;
}

int stad_tune_joint_step(stad_tune *t, tune_walk *w)
{
    direction d;
    choose_direction(t, w, &d);
    const int32_t longest = hold(t, d.move, MAX_MOVE);
    if (longest >= TUNE_ONE / 16 && !line_search(t, w, &d, longest))
        return 0;
    memcpy(w->old_slope, w->slope, sizeof w->old_slope);
    w->old_fall = d.fall;
    memcpy(w->old_move, d.move, sizeof w->old_move);
    w->has_old = 1;
    return 1;
}

int stad_tune_follow(stad_tune *t, tune_walk *w, const tune_vars *from)
{
    int32_t move[STAD_TUNE_DIMS];
    int axes = 0;
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        move[i] = stad_tune_is_swept(t, i) ? w->at.v[i] - from->v[i] : 0;
        axes += move[i] != 0;
    }
    for (int k = 0; axes >= 2 && k < MAX_FOLLOW; k++) {
        stad_point x;
        int32_t cost;
        tune_vars v = w->at;
        hold(t, move, MAX_MOVE);
        for (int i = 0; i < STAD_TUNE_DIMS; i++)
            v.v[i] += move[i];
        stad_tune_to_point(t, &v, &x);
        if (stad_tune_same(&x, &w->x))
            return 1;
        if (!stad_tune_look(t, &x, &cost))
            return 0;
        if (cost >= w->cost)
            return 1;
        stad_tune_walk_move(t, w, &x, cost);
        for (int i = 0; i < STAD_TUNE_DIMS; i++)
            move[i] *= 2;
    }
    return 1;
}
