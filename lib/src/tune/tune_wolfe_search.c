/* SPDX-License-Identifier: MIT
 * tune/tune_wolfe_search.c - central differences and the strong Wolfe line search of tune_wolfe.c. */
#include "tune/tune_wolfe.h"
#include "base/arith.h"

#include <string.h>

#define TRIALS 10

static int32_t rounded(int32_t q16)
{
    return q16 >= 0 ? (q16 + TUNE_ONE / 2) / TUNE_ONE : -((TUNE_ONE / 2 - q16) / TUNE_ONE);
}

static void to_lattice(const stad_tune *t, const int32_t *z, stad_point *x)
{
    tune_vars v;
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        const int scale = t->config.axis[i].scale;
        v.v[i] = scale == STAD_TUNE_ODD     ? 2 * clamp_i32(rounded(z[i]), 0, 16383) + 1
                 : scale == STAD_TUNE_POWER ? 1 << clamp_i32(rounded(z[i]), 0, 14)
                                            : z[i];
    }
    stad_tune_to_point(t, &v, x);
}

void stad_tune_wolfe_from(const stad_tune *t, const stad_point *x, int32_t *z)
{
    tune_vars v;
    stad_tune_to_vars(&t->config, x, &v);
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        z[i] = v.v[i];
        if (t->config.axis[i].scale == STAD_TUNE_ODD)
            z[i] = (x->v[i] - 1) / 2 * TUNE_ONE;
        if (t->config.axis[i].scale == STAD_TUNE_POWER) {
            z[i] = 0;
            for (int32_t rest = x->v[i]; rest > 1; rest /= 2)
                z[i] += TUNE_ONE;
        }
    }
}

int stad_tune_wolfe_cost(stad_tune *t, const int32_t *z, int32_t *cost)
{
    stad_point x;
    to_lattice(t, z, &x);
    return stad_tune_look(t, &x, cost);
}

int stad_tune_wolfe_gradient(stad_tune *t, wolfe_way *d, wolfe_spot *s)
{
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        int32_t up, down, z[STAD_TUNE_DIMS];
        s->slope[i] = 0;
        if (!stad_tune_is_free(&t->config, i))
            continue;
        memcpy(z, s->z, sizeof z);
        z[i] = s->z[i] + d->diff[i];
        if (!stad_tune_wolfe_cost(t, z, &up))
            return 0;
        z[i] = s->z[i] - d->diff[i];
        if (!stad_tune_wolfe_cost(t, z, &down))
            return 0;
        int64_t slope = ((int64_t)up - down) * 65536 / (2 * (int64_t)d->diff[i]);
        s->slope[i] = slope > WOLFE_SLOPE_MOST    ? WOLFE_SLOPE_MOST
                      : slope < -WOLFE_SLOPE_MOST ? -WOLFE_SLOPE_MOST
                                                  : (int32_t)slope;
        if (up == down && d->diff[i] < TUNE_ONE)
            d->diff[i] *= 2;
    }
    return 1;
}

int64_t stad_tune_wolfe_dot(const int32_t *a, const int32_t *b)
{
    int64_t sum = 0;
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        sum += (int64_t)a[i] * b[i];
    return sum;
}

/* Slope along the direction per unit of length (one step of the longest coordinate), Q20. */
static int64_t slope_along(const wolfe_way *d, const wolfe_spot *s)
{
    return stad_tune_wolfe_dot(d->way, s->slope) / d->longest;
}

int stad_tune_wolfe_search(stad_tune *t, wolfe_way *d, wolfe_spot *s, int32_t *a_q12, int *moved)
{
    const int64_t s0 = slope_along(d, s);
    int32_t lo = 0, hi = 0, a = *a_q12;
    wolfe_spot next;
    wolfe_spot best = *s;
    for (int k = 0; k < TRIALS && a > 0; k++) {
        for (int i = 0; i < STAD_TUNE_DIMS; i++)
            next.z[i] = s->z[i] + (int32_t)((int64_t)d->way[i] * a / d->longest * (TUNE_ONE / WOLFE_ONE));
        if (!stad_tune_wolfe_cost(t, next.z, &next.cost))
            return 0;
        if (next.cost >= s->cost || (int64_t)next.cost - s->cost > s0 * a / WOLFE_ONE / 10000) {
            hi = a;
        } else {
            if (!stad_tune_wolfe_gradient(t, d, &next))
                return 0;
            const int64_t sa = slope_along(d, &next);
            if (next.cost < best.cost) {
                best = next;
                *a_q12 = a;
            }
            if (10 * sa >= 4 * s0 && 10 * sa <= -4 * s0)
                break;
            if (sa < 0)
                lo = a;
            else
                hi = a;
        }
        a = hi ? (lo + hi) / 2 : a < 8 * WOLFE_ONE ? 2 * a : 0;
    }
    *moved = best.cost < s->cost;
    *s = best;
    return 1;
}
