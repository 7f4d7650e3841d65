/* SPDX-License-Identifier: MIT
 * proof/prove_tune.h - a tuner in the midst of any search, and a walk of any kind, for the proofs of its methods.
 *
 * Coordinates as stereo has them, and others of the widest ranges there are; any of them free or cheap, any budget and seed,
 * points of the coordinates' ranges, linear ones within 1024 units of zero. In the place of base/log.c and base/divide.c, proved
 * by prove_base.c and prove_score.c, stand their results: a logarithm of a range is nothing that ranges can tell. */
#ifndef PROVE_TUNE_H
#define PROVE_TUNE_H

#include <string.h>

#include "base/divide.h"
#include "base/log.h"
#include "proof/prove.h"
#include "tune/tune_walk.h"

enum { WALL = 1 << 24, LONGEST = 6 * TUNE_ONE };

static stad_tune t;

#ifndef PROVE_WITH_LOGARITHMS
int64_t stad_div_i64(int64_t a, int64_t b)
{
    return a / b;
}

int32_t stad_log2_q16(uint32_t v)
{
    //@ assert v <= 32767;
    (void)v;
    return any(0, 15 << 16);
}

int64_t stad_exp2_q16(int32_t e_q16)
{
    (void)e_q16;
    return any64(0, 1ll << 46);
}
#endif

static stad_point any_point(void)
{
    stad_point x;
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        x.v[i] = (int16_t)any(t.config.axis[i].lo, t.config.axis[i].hi);
    return x;
}

static void any_search(int stereo, int method)
{
    static const stad_tune_axis widest[STAD_TUNE_DIMS] = {
        {-32768, 32767, 32, STAD_TUNE_LINEAR, -1}, {-1024, 1024, 1, STAD_TUNE_LINEAR, 1}, {1, 32767, 1, STAD_TUNE_ODD, 1},
        {1, 32767, 1, STAD_TUNE_LOG2, -1},         {2, 32000, 7, STAD_TUNE_AREA, 1},      {1, 32767, 1, STAD_TUNE_POWER, 1}};
    stad_tune_config_stereo(&t.config, STAD_TUNE_FOR_BAD);
    for (int i = 0; i < STAD_TUNE_DIMS && !stereo; i++)
        t.config.axis[i] = widest[i];
    t.config.method = (uint8_t)method;
    t.config.seed = (uint32_t)any64(0, UINT32_MAX);
    t.config.cheap_mask = (uint8_t)any(0, 255);
    t.config.free_mask = (uint8_t)any(0, 63);
    t.config.budget = (int16_t)any(1, STAD_TUNE_LOG);
    t.config.ordered = (uint8_t)any(0, 1);
    t.config.patience = (uint8_t)any(0, 1);
    t.start = any_point();
    t.count = (int16_t)any(1, STAD_TUNE_LOG);
    t.best = (int16_t)any(0, STAD_TUNE_LOG - 1);
    t.lead = (int16_t)any(0, STAD_TUNE_LOG - 1);
    t.cursor = (int16_t)any(0, STAD_TUNE_LOG);
    t.counts.iterations = 0;
    t.counts.calls = any(0, 1 << 20);
    memset(t.point, 1, sizeof t.point); /* of values within the ranges, should the loop be taken as a whole */
    for (int i = 0; i < STAD_TUNE_LOG; i++) {
        t.cost[i] = any(0, INT32_MAX);
        t.point[i] = any_point();
    }
}

/* A walk at any point, with whatever it may have learnt on its way. */
static tune_walk any_walk(void)
{
    tune_walk w;
    w.x = any_point();
    w.cost = any(0, INT32_MAX);
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        w.at.v[i] = any(-(1 << 27), 1 << 27);
        w.slope[i] = any(-WALL, WALL);
        w.curve[i] = any(0, INT32_MAX);
        w.old_slope[i] = any(-WALL, WALL);
        w.old_move[i] = any(-LONGEST, LONGEST);
        w.side[i] = any(0, 1) ? 1 : -1;
    }
#ifndef PROVE_WITH_LOGARITHMS
    stad_tune_to_vars(&t.config, &w.x, &w.at);
#endif
    w.old_fall = any64(-(1ll << 50), 1ll << 50);
    w.step = any(TUNE_ONE / 8, 3 * TUNE_ONE / 4);
    w.has_old = (uint8_t)any(0, 1);
    return w;
}

#endif
