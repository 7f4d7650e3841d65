/* SPDX-License-Identifier: MIT
 * tune/tune_config.c - the customary config for stereo parameters, and the check of any config. */
#include "stad/tune.h"

#include <stddef.h>
#include <string.h>

/* Fitted on the design scenes alone, one rung for each kind of scene found there: textured and indoors without and with a
 * block, driving, and for chow large surfaces without texture. (docs/TUNING.md) */
static const stad_point ladder_bad[] = {{{8, 18, 1, 0, 63, 8}}, {{40, 150, 3, 0, 21, 8}}, {{50, 2200, 9, 0, 41, 8}}};
static const stad_point ladder_chow[] = {
    {{30, 90, 3, 34, 17, 1}}, {{8, 18, 1, 24, 63, 1}}, {{35, 2200, 9, 0, 35, 2}}, {{117, 726, 9, 15, 15, 1}}};

static void bring_ladder(stad_tune_config *c, const stad_point *ladder, size_t bytes)
{
    memcpy(c->ladder, ladder, bytes);
    c->ladder_count = (uint8_t)(bytes / sizeof *ladder);
}

void stad_tune_config_stereo(stad_tune_config *c, int purpose)
{
    static const stad_tune_axis stereo[STAD_TUNE_DIMS] = {{1, 4096, 1, STAD_TUNE_AREA, -1}, {2, 8192, 1, STAD_TUNE_AREA, -1},
                                                          {1, 11, 1, STAD_TUNE_ODD, -1},    {0, 40, 8, STAD_TUNE_LINEAR, -1},
                                                          {15, 127, 2, STAD_TUNE_LOG2, 1},  {1, 8, 1, STAD_TUNE_POWER, 1}};
    memset(c, 0, sizeof *c);
    c->method = STAD_TUNE_NCG;
    c->free_mask = (1u << STAD_TUNE_DIMS) - 1;
    c->ordered = 1;
    c->budget = 100;
    memcpy(c->axis, stereo, sizeof stereo);
    if (purpose == STAD_TUNE_FOR_BAD)
        bring_ladder(c, ladder_bad, sizeof ladder_bad);
    if (purpose == STAD_TUNE_FOR_CHOW)
        bring_ladder(c, ladder_chow, sizeof ladder_chow);
}

static int axis_sound(const stad_tune_axis *a)
{
    if (a->scale > STAD_TUNE_POWER || a->lo > a->hi || a->unit < 1)
        return 0;
    if (a->scale == STAD_TUNE_ODD && a->lo == a->hi && a->lo % 2 == 0)
        return 0; /* no odd number within */
    if (a->scale != STAD_TUNE_LINEAR)
        return a->lo >= 1;
    return a->lo >= -STAD_TUNE_UNITS * a->unit && a->hi <= STAD_TUNE_UNITS * a->unit;
}

static int refuse(const char **culprit, const char *field)
{
    if (culprit)
        *culprit = field;
    return STAD_E_PARAM;
}

int stad_tune_config_check(const stad_tune_config *c, const char **culprit)
{
    static const char *const names[STAD_TUNE_DIMS] = {
        "p1", "p2", "block_size", "uniqueness_ratio", "pre_filter_cap", "disp12_max_diff"};
    if (c->method > STAD_TUNE_DESCENT)
        return refuse(culprit, "method");
    if (c->budget < 1 || c->budget > STAD_TUNE_LOG)
        return refuse(culprit, "budget");
    if (c->ladder_count > STAD_TUNE_LADDER)
        return refuse(culprit, "ladder_count");
    if (c->free_mask >> STAD_TUNE_DIMS != 0)
        return refuse(culprit, "free_mask");
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        if (!axis_sound(&c->axis[i]))
            return refuse(culprit, names[i]);
    }
    return STAD_OK;
}
