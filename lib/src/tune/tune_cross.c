/* SPDX-License-Identifier: MIT
 * log -> [CROSS] -> point         tune/tune_cross.c - a good point, moved by the difference of two other good points.
 *
 * That is differential evolution with the log for a population. The differences of the best points lie along the valleys
 * that the descents have found, whichever way these run, and lead from one block or one end of the cap to another with
 * all other variables following. Every third point lies close to the best instead: costs are rough there, by as much as is
 * left to gain. A draw depends on the log and on its length alone, so a rerun need not repeat it. */
#include "tune/tune_cross.h"
#include "tune/tune_random.h"
#include "base/arith.h"

#define PARENTS 24
#define FIRST   12 /* of them, as long as they give something new */
#define FEWEST  4
#define DRAWS   64
#define CLOSE   8    /* of them, at every third point */
#define NEAR    2800 /* 3 percent, Q16 of an octave */

typedef struct parents {
    uint8_t entry[PARENTS]; /* of the log, the best first */
    int count;
} parents;
typedef char entries_fit[STAD_TUNE_LOG <= 255 ? 1 : -1];

/* Puts log entry i where its cost belongs, if it belongs among the best. */
static void offer(const stad_tune *t, parents *p, int i)
{
    int at = p->count;
    if (t->cost[i] == STAD_COST_FAILED || (at == PARENTS && t->cost[i] >= t->cost[p->entry[at - 1]]))
        return;
    if (at < PARENTS)
        p->count++;
    else
        at--;
    for (; at > 0 && t->cost[p->entry[at - 1]] > t->cost[i]; at--)
        p->entry[at] = p->entry[at - 1];
    p->entry[at] = (uint8_t)i;
}

#define MOST (STAD_TUNE_UNITS * TUNE_ONE) /* of linear variables; all others are far below */

/* Coordinate i of `base` moved by what leads from b to a. */
static int32_t moved(const stad_tune *t, int i, const tune_vars *base, const tune_vars *a, const tune_vars *b)
{
    if (!stad_tune_is_free(&t->config, i))
        return base->v[i]; /* of any value, 0 included */
    if (t->config.axis[i].scale == STAD_TUNE_POWER)
        return base->v[i] * a->v[i] / b->v[i]; /* values of int16: up to 2^30 */
    return clamp_i64((int64_t)base->v[i] + a->v[i] - b->v[i], -MOST, MOST);
}

/* Among the first `count` parents: half of the draws start at the best; half of the variables move, and one surely. */
static void draw(const stad_tune *t, const parents *p, int count, uint32_t *state, stad_point *x)
{
    tune_vars base, a, b;
    const int from = stad_tune_random(state) >> 31 ? 0 : stad_tune_between(state, 0, count - 1);
    const int to = stad_tune_between(state, 0, count - 1);
    const int other = (to + stad_tune_between(state, 1, count - 1)) % count;
    const int surely = stad_tune_between(state, 0, STAD_TUNE_DIMS - 1);
    stad_tune_to_vars(&t->config, &t->point[p->entry[from]], &base);
    stad_tune_to_vars(&t->config, &t->point[p->entry[to]], &a);
    stad_tune_to_vars(&t->config, &t->point[p->entry[other]], &b);
    tune_vars v = base;
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        if (i == surely || stad_tune_random(state) >> 31)
            v.v[i] = moved(t, i, &base, &a, &b);
    }
    stad_tune_to_point(t, &v, x);
}

/* The best with its areas moved by up to `reach`. */
static void draw_close(const stad_tune *t, const parents *p, uint32_t *state, int32_t reach, stad_point *x)
{
    tune_vars v;
    stad_tune_to_vars(&t->config, &t->point[p->entry[0]], &v);
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        if (stad_tune_is_free(&t->config, i) && t->config.axis[i].scale == STAD_TUNE_AREA)
            v.v[i] += stad_tune_between(state, -reach, reach);
    }
    stad_tune_to_point(t, &v, x);
}

void stad_tune_cross(stad_tune *t)
{
    parents best = {{0}, 0};
    uint32_t state = (t->config.seed ^ 2463534242u) + (uint32_t)t->count * 2654435761u;
    t->counts.calls += t->count - t->cursor; /* those of earlier draws */
    t->cursor = t->count;
    for (int i = 0; i < t->count; i++)
        offer(t, &best, i);
    if (best.count < FEWEST)
        return;
    state = state ? state : 1;
    for (int k = 0; k < DRAWS; k++) {
        stad_point x;
        int32_t cost;
        if (t->count % 3 == 0 && k < CLOSE)
            draw_close(t, &best, &state, NEAR * (k + 1), &x);
        else
            draw(t, &best, k < DRAWS / 2 && best.count > FIRST ? FIRST : best.count, &state, &x);
        if (stad_tune_find(t, &x) < 0) {
            stad_tune_look(t, &x, &cost);
            return;
        }
    }
}
