/* SPDX-License-Identifier: MIT
 * stad/tune_names.c - methods, costs and coordinates by name. */
#include "tune_job.h"

#include <string.h>

static const char *const methods[] = {"ncg", "ncg-paper", "sd", "hybrid", "descent"};
static const char *const costs[] = {"bad", "chow", "d1", "rmse", "mae", "missing"};

#define COUNT(list) ((int)(sizeof(list) / sizeof(list)[0]))

static int find(const char *const *list, int count, const char *name)
{
    for (int i = 0; i < count; i++)
        if (strcmp(list[i], name) == 0)
            return i;
    return -1;
}

const char *tune_method_name(int method)
{
    return methods[method];
}

int tune_method_of(const char *name)
{
    return find(methods, COUNT(methods), name);
}

const char *tune_cost_name(int cost)
{
    return costs[cost];
}

int tune_cost_of(const char *name)
{
    return find(costs, COUNT(costs), name);
}

int tune_field(int dim)
{
    static const int field[STAD_TUNE_DIMS] = {
        [STAD_TUNE_P1] = FIELD_P1,
        [STAD_TUNE_P2] = FIELD_P2,
        [STAD_TUNE_BLOCK_SIZE] = FIELD_BLOCK_SIZE,
        [STAD_TUNE_UNIQUENESS_RATIO] = FIELD_UNIQUENESS_RATIO,
        [STAD_TUNE_PRE_FILTER_CAP] = FIELD_PRE_FILTER_CAP,
        [STAD_TUNE_DISP12_MAX_DIFF] = FIELD_DISP12_MAX_DIFF,
    };
    return field[dim];
}
