/* SPDX-License-Identifier: MIT
 * stad/tune_job.h - what `stad tune` is asked for, and what came of it. */
#ifndef STAD_TUNE_JOB_H
#define STAD_TUNE_JOB_H

#include "match_options.h"
#include "report.h"
#include "scene_set.h"
#include "stad/tune.h"

/* A point of the search and its measures, means over the scenes. Fractions; rmse in px. */
typedef struct tune_point {
    stad_params params; /* of the first scene */
    double cost, bad, chow, rmse, density;
} tune_point;

typedef struct tune_job {
    match_options options;
    params_some start; /* --start NAME=V,... */
    int from;          /* --start default: 'd', sample: 's', neither: 0 */
    const char *list, *json, *header, *report;
    char *command; /* as typed, for the report */
    report_rig rig;
    double cx, cy; /* principal point, px; not a number = the middle */
    int method;
    unsigned free_mask;
    long max_evals; /* 0: the library's own */
    long seed;
    long share; /* frames whose winners are kept */
    scoring how;
    scene_set set;
    stad_tune tune;
    tune_point first, best; /* best: the start itself unless something costs less */
    double seconds;
    char stopped[80]; /* why the search did not come to its end; "" when it did */
} tune_job;

const char *tune_method_name(int method);
int tune_method_of(const char *name);
const char *tune_cost_name(int cost);
int tune_cost_of(const char *name);

/* Which field of stad_params a coordinate of the search is. */
int tune_field(int dim);

/* The search itself: reads the scenes, evaluates, fills first, best and seconds. A signal ends it after the evaluation at hand:
 * TOOL_OK, and `stopped` says so. */
int tune_search(tune_job *j, tool_fail *f);

/* By how much the best is lower than the start: "3.1 % lower", or that nothing is. */
const char *tune_gain(char *text, size_t room, const tune_job *j);

/* "1 evaluation", "2 evaluations" */
const char *tune_evaluations(char *text, size_t room, const tune_job *j);

void tune_print(const tune_job *j);
int tune_write_json(const tune_job *j, tool_fail *f);
int tune_write_header(const tune_job *j, tool_fail *f);

#endif
