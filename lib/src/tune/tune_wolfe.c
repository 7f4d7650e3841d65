/* SPDX-License-Identifier: MIT
 * tell -> [WOLFE] -> ask         tune/tune_wolfe.c - gradient descent as the literature writes it, on rounded parameters.
 *
 * Central differences in every free coordinate, block size and disp12 taken as if they were continuous, a strong Wolfe line
 * search with gradients, PR+ with a restart every STAD_TUNE_DIMS iterations. Kept in the variables of tune_descent.c, so that a
 * comparison shows the method and not the variables. It is not meant to be used. */
#include "tune/tune_wolfe.h"

#include <string.h>

#define FIRST_DIFF (TUNE_ONE / 4)
#define LAST_DIFF  (TUNE_ONE / 64)
#define ITERATIONS 40

static void steepest(wolfe_way *d, const wolfe_spot *s)
{
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        d->way[i] = -s->slope[i];
}

/* way = -slope + beta * way with PR+; back to steepest descent when that does not lead down. */
static void conjugate(wolfe_way *d, const wolfe_spot *old, const wolfe_spot *s)
{
    int32_t change[STAD_TUNE_DIMS];
    const int64_t below = stad_tune_wolfe_dot(old->slope, old->slope);
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        change[i] = s->slope[i] - old->slope[i];
    int64_t beta_q8 = below > 0 ? stad_tune_wolfe_dot(s->slope, change) * 256 / below : 0;
    beta_q8 = beta_q8 < 0 ? 0 : beta_q8 > 2048 ? 2048 : beta_q8;
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        const int64_t way = -(int64_t)s->slope[i] + beta_q8 * d->way[i] / 256;
        d->way[i] = (int32_t)(way > WOLFE_SLOPE_MOST ? WOLFE_SLOPE_MOST : way < -WOLFE_SLOPE_MOST ? -WOLFE_SLOPE_MOST : way);
    }
    if (stad_tune_wolfe_dot(d->way, s->slope) >= 0)
        steepest(d, s);
}

static void measure(wolfe_way *d)
{
    d->longest = 0;
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        const int32_t size = d->way[i] < 0 ? -d->way[i] : d->way[i];
        d->longest = size > d->longest ? size : d->longest;
    }
}

/* Halves the differences. 0: they were as small as they get. */
static int finer(wolfe_way *d)
{
    int coarse = 0;
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        coarse |= d->diff[i] > LAST_DIFF;
        d->diff[i] = d->diff[i] / 2 > LAST_DIFF ? d->diff[i] / 2 : LAST_DIFF;
    }
    return coarse;
}

void stad_tune_wolfe_run(stad_tune *t, int use_conjugate)
{
    wolfe_spot s, old;
    wolfe_way d;
    int32_t a = WOLFE_ONE;
    memset(&d, 0, sizeof d);
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        d.diff[i] = FIRST_DIFF;
    stad_tune_wolfe_from(t, &t->start, s.z);
    if (!stad_tune_wolfe_cost(t, s.z, &s.cost) || !stad_tune_wolfe_gradient(t, &d, &s))
        return;
    steepest(&d, &s);
    for (int k = 1; k <= ITERATIONS; k++) {
        int moved = 0;
        t->counts.iterations++;
        old = s;
        measure(&d);
        if (d.longest > 0 && !stad_tune_wolfe_search(t, &d, &s, &a, &moved))
            return;
        if (!moved) {
            if (!finer(&d) || !stad_tune_wolfe_gradient(t, &d, &s))
                return;
            a = WOLFE_ONE;
        }
        if (moved && use_conjugate && k % STAD_TUNE_DIMS != 0)
            conjugate(&d, &old, &s);
        else
            steepest(&d, &s);
    }
}
