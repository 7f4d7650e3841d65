/* SPDX-License-Identifier: MIT
 * points -> [WALK] -> slopes         tune/tune_walk.c - one coordinate at a time: probe, learn the parabola, move.
 *
 * The probes that give the slope give the curvature for nothing, and a probe that is better is taken at once. */
#include "tune/tune_walk.h"
#include "base/divide.h"

#include <string.h>

#define WALL (1 << 24)

int32_t stad_tune_rise(int32_t from, int32_t to)
{
    const int64_t rise = (int64_t)to - from;
    return rise > WALL ? WALL : rise < -WALL ? -WALL : (int32_t)rise;
}

int32_t stad_tune_div_q16(int64_t a, int64_t b)
{
    const int64_t q = stad_div_i64(a * 65536, b);
    return q > INT32_MAX ? INT32_MAX : q < -INT32_MAX ? -INT32_MAX : (int32_t)q;
}

void stad_tune_walk_move(const stad_tune *t, tune_walk *w, const stad_point *x, int32_t cost)
{
    w->x = *x;
    w->cost = cost;
    stad_tune_to_vars(&t->config, x, &w->at);
}

void stad_tune_walk_from(const stad_tune *t, tune_walk *w, const stad_point *x, int32_t cost, int32_t reach)
{
    memset(w, 0, sizeof *w);
    stad_tune_walk_move(t, w, x, cost);
    w->step = reach;
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        w->side[i] = t->config.axis[i].side < 0 ? -1 : 1;
}

/* A probe: its distance from where the axis was entered, with sign, and its cost. */
typedef struct probe {
    stad_point x;
    int32_t from_q16;
    int32_t cost;
} probe;

/* Goes `distance` along axis i, to the next integer at least. 1: known; *moved 0 when there is no other point there. */
static int probe_at(stad_tune *t, const tune_walk *w, int i, int32_t distance, probe *p, int *moved)
{
    tune_vars v = w->at;
    v.v[i] += distance;
    stad_tune_to_point(t, &v, &p->x);
    if (p->x.v[i] == w->x.v[i]) {
        const stad_tune_axis *a = &t->config.axis[i];
        const int quantum = a->scale == STAD_TUNE_LINEAR ? 1 : a->unit;
        const int next = w->x.v[i] + (distance < 0 ? -quantum : quantum);
        if (next < a->lo || next > a->hi) {
            *moved = 0;
            return 1;
        }
        stad_point x = w->x;
        x.v[i] = (int16_t)next;
        stad_tune_to_vars(&t->config, &x, &v);
        stad_tune_to_point(t, &v, &p->x);
    }
    stad_tune_to_vars(&t->config, &p->x, &v);
    p->from_q16 = v.v[i] - w->at.v[i];
    *moved = p->from_q16 != 0 && (p->from_q16 < 0) == (distance < 0);
    return !*moved || stad_tune_look(t, &p->x, &p->cost);
}

/* How far to go on after a first probe at `r` was better: to the parabola's floor, or as far again. */
static int32_t go_on(const tune_walk *w, int i, int32_t r, int32_t secant)
{
    const int32_t curve = w->curve[i];
    if (curve <= 0)
        return 2 * r;
    const int64_t slope = secant - (int64_t)curve * r / (2 * 65536);
    const int64_t floor = stad_div_i64(-slope * 65536, curve);
    return floor < 0 ? 0 : floor > 3 * (int64_t)r ? 3 * r : (int32_t)floor;
}

/* Does the curvature known from before say that the other side cannot be better? */
static int other_side_useless(const tune_walk *w, int i, int32_t r, int32_t secant)
{
    const int32_t curve = w->curve[i];
    if (curve <= 0 || !w->has_old)
        return 0;
    const int64_t bend = (int64_t)curve * r / 65536; /* the slope's change over r */
    const int64_t slope = secant - bend / 2;
    return slope * 100 <= 35 * bend;
}

/* Slope and curvature at `best_q16` from the entry point (0, f) and the probes. */
static void learn(tune_walk *w, int i, int32_t entry_cost, const probe *a, const probe *b, int32_t best_q16)
{
    const int32_t d1 = stad_tune_div_q16(stad_tune_rise(entry_cost, a->cost), a->from_q16);
    int32_t curve = w->curve[i];
    if (b && b->from_q16 != a->from_q16) {
        const int32_t d2 = stad_tune_div_q16(stad_tune_rise(entry_cost, b->cost), b->from_q16);
        curve = stad_tune_div_q16(2 * ((int64_t)d2 - d1), (int64_t)b->from_q16 - a->from_q16);
        w->curve[i] = curve > 0 ? curve : 0;
    }
    const int64_t slope = d1 + (int64_t)curve * (2 * (int64_t)best_q16 - a->from_q16) / (2 * 65536);
    w->slope[i] = slope > WALL ? WALL : slope < -WALL ? -WALL : (int32_t)slope;
}

/* The second probe: onwards after a success, else on the other side. *moved 0: none is worth while. */
static int second_probe(stad_tune *t, const tune_walk *w, int i, const probe *a, probe *b, int *moved)
{
    const int s = a->from_q16 < 0 ? -1 : 1;
    const int32_t r = s * a->from_q16, secant = stad_tune_div_q16(stad_tune_rise(w->cost, a->cost), r);
    *moved = 0;
    if (a->cost < w->cost) {
        int32_t far = go_on(w, i, r, secant);
        const int32_t room = stad_tune_room(t, &w->at, i, s);
        if (4 * (int64_t)far > 6 * (int64_t)r && far > room)
            far = room;
        return 4 * (int64_t)far <= 5 * (int64_t)r || probe_at(t, w, i, s * far, b, moved);
    }
    if (other_side_useless(w, i, r, secant))
        return 1;
    int32_t room = stad_tune_room(t, &w->at, i, -s);
    room = room < w->step ? room : w->step;
    return room <= w->step / 4 || probe_at(t, w, i, -s * room, b, moved);
}

int stad_tune_sweep_axis(stad_tune *t, tune_walk *w, int i)
{
    probe a, b;
    int moved = 0, moved_b = 0;
    w->slope[i] = 0;
    for (int k = 0; k < 2 && !moved; k++) {
        const int s = k == 0 ? w->side[i] : -w->side[i];
        const int32_t room = stad_tune_room(t, &w->at, i, s);
        const int32_t r = room < w->step ? room : w->step;
        if (r < w->step / 4 || r == 0)
            continue;
        if (!probe_at(t, w, i, s * r, &a, &moved))
            return 0;
    }
    if (!moved)
        return 1;
    if (!second_probe(t, w, i, &a, &b, &moved_b))
        return 0;
    const probe *best = moved_b && b.cost < a.cost ? &b : &a;
    const int better = best->cost < w->cost;
    learn(w, i, w->cost, &a, moved_b ? &b : NULL, better ? best->from_q16 : 0);
    if (better) {
        w->side[i] = best->from_q16 < 0 ? -1 : 1;
        stad_tune_walk_move(t, w, &best->x, best->cost);
    }
    if (stad_tune_room(t, &w->at, i, w->slope[i] > 0 ? -1 : 1) == 0)
        w->slope[i] = 0; /* downhill is out of bounds */
    return 1;
}

/* Looks at the point nearest to v and goes there if it is better. 0: its cost is wanted. */
static int try_there(stad_tune *t, tune_walk *w, const tune_vars *v, int *moved)
{
    stad_point x;
    int32_t cost;
    stad_tune_to_point(t, v, &x);
    if (!stad_tune_look(t, &x, &cost))
        return 0;
    *moved = cost < w->cost;
    if (*moved)
        stad_tune_walk_move(t, w, &x, cost);
    return 1;
}

static int neighbour(const stad_tune_axis *a, int value, int side)
{
    if (a->scale == STAD_TUNE_ODD)
        return value + 2 * side;
    return side > 0 ? value * 2 : value / 2;
}

int stad_tune_poll(stad_tune *t, tune_walk *w, int i, int *moved)
{
    const stad_tune_axis *a = &t->config.axis[i];
    *moved = 0;
    for (int k = 0; k < 2 && !*moved; k++) {
        const int s = k == 0 ? w->side[i] : -w->side[i];
        int better;
        do {
            const int next = neighbour(a, w->x.v[i], s);
            tune_vars v = w->at;
            if (next < a->lo || next > a->hi)
                break;
            v.v[i] = next;
            if (!try_there(t, w, &v, &better))
                return 0;
            if (better) {
                w->side[i] = (int8_t)s;
                *moved = 1;
            }
        } while (better && a->scale == STAD_TUNE_POWER);
    }
    return 1;
}

int stad_tune_leap(stad_tune *t, tune_walk *w, int parts, int *moved)
{
    *moved = 0;
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        const int scale = t->config.axis[i].scale;
        if (!stad_tune_is_free(&t->config, i) || (scale != STAD_TUNE_LOG2 && (scale != STAD_TUNE_LINEAR || parts == 1)))
            continue;
        const int32_t hi = w->at.v[i] + stad_tune_room(t, &w->at, i, 1);
        const int32_t part = (hi - w->at.v[i] + stad_tune_room(t, &w->at, i, -1)) / parts;
        for (int k = 0; k <= parts; k++) {
            tune_vars v = w->at;
            int better;
            v.v[i] = hi - part * (parts - k);
            if (!try_there(t, w, &v, &better))
                return 0;
            if (better) {
                w->curve[i] = 0;
                *moved = 1;
            }
        }
    }
    return 1;
}
