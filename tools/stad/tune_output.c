/* SPDX-License-Identifier: MIT
 * stad/tune_output.c - what `stad tune` found: for a person, as JSON, as a C header. */
#include <cjson/cJSON.h>
#include <stdio.h>

#include "../common/whole_file.h"
#include "tool.h"
#include "tune_job.h"

static void print_point(const char *name, const tune_point *p)
{
    printf("%-6s %8.3f %% %8.3f %% %8.4f px %7.2f %%   ", name, 100 * p->bad, 100 * p->chow, p->rmse, 100 * p->density);
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        printf("%s%s %ld", i ? ", " : "", params_field_name(tune_field(i)), params_get(&p->params, tune_field(i)));
    putchar('\n');
}

const char *tune_gain(char *text, size_t room, const tune_job *j)
{
    if (j->best.cost < j->first.cost)
        snprintf(text, room, "%.1f %% lower", 100 * (1 - j->best.cost / j->first.cost));
    else
        snprintf(text, room, "nothing better than the start was found");
    return text;
}

const char *tune_evaluations(char *text, size_t room, const tune_job *j)
{
    int n = stad_tune_counts_of(&j->tune).evaluations;
    snprintf(text, room, "%d evaluation%s", n, n == 1 ? "" : "s");
    return text;
}

void tune_print(const tune_job *j)
{
    char gain[60], n[40];
    printf("%-6s %10s %10s %11s %9s\n", "", "bad", "chow", "rmse", "density");
    print_point("start", &j->first);
    print_point("best", &j->best);
    printf("%s on %s: %s, %s, %.1f s%s%s\n", tune_method_name(j->method), tune_cost_name(j->how.cost),
           tune_gain(gain, sizeof gain, j), tune_evaluations(n, sizeof n, j), j->seconds, j->stopped[0] ? "; " : "", j->stopped);
}

static cJSON *point_json(const tune_point *p)
{
    cJSON *o = cJSON_CreateObject();
    cJSON_AddItemToObject(o, "params", params_to_json(&p->params));
    cJSON_AddNumberToObject(o, "cost", p->cost);
    cJSON_AddNumberToObject(o, "bad", p->bad);
    cJSON_AddNumberToObject(o, "chow", p->chow);
    cJSON_AddNumberToObject(o, "rmse", p->rmse);
    cJSON_AddNumberToObject(o, "density", p->density);
    return o;
}

/* The values of a point by name. */
static cJSON *values_json(const stad_point *x)
{
    cJSON *o = cJSON_CreateObject();
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        cJSON_AddNumberToObject(o, params_field_name(tune_field(i)), x->v[i]);
    return o;
}

static cJSON *free_json(unsigned mask)
{
    cJSON *list = cJSON_CreateArray();
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        if (mask >> i & 1)
            cJSON_AddItemToArray(list, cJSON_CreateString(params_field_name(tune_field(i))));
    return list;
}

/* [evaluation, cost, best so far, point], from 1 on; a point that could not be scored has the cost null. */
static cJSON *trace_json(const stad_tune *t)
{
    cJSON *list = cJSON_CreateArray();
    stad_point x;
    int32_t cost, best = STAD_COST_FAILED;
    for (int i = 0; stad_tune_trace(t, i, &x, &cost) == STAD_OK; i++) {
        cJSON *row = cJSON_CreateArray();
        best = cost < best ? cost : best;
        cJSON_AddItemToArray(row, cJSON_CreateNumber(i + 1));
        cJSON_AddItemToArray(row,
                             cost == STAD_COST_FAILED ? cJSON_CreateNull() : cJSON_CreateNumber((double)cost / STAD_COST_ONE));
        cJSON_AddItemToArray(row,
                             best == STAD_COST_FAILED ? cJSON_CreateNull() : cJSON_CreateNumber((double)best / STAD_COST_ONE));
        cJSON_AddItemToArray(row, values_json(&x));
        cJSON_AddItemToArray(list, row);
    }
    return list;
}

static cJSON *job_json(const tune_job *j)
{
    stad_tune_counts n = stad_tune_counts_of(&j->tune);
    cJSON *o = cJSON_CreateObject();
    cJSON_AddStringToObject(o, "method", tune_method_name(j->method));
    cJSON_AddStringToObject(o, "cost", tune_cost_name(j->how.cost));
    cJSON_AddNumberToObject(o, "seed", (double)j->seed);
    cJSON_AddNumberToObject(o, "budget", j->tune.config.budget);
    cJSON_AddItemToObject(o, "free", free_json(j->tune.config.free_mask));
    cJSON_AddStringToObject(o, "mode", params_mode_name(j->how.mode));
    cJSON_AddNumberToObject(o, "threshold", j->how.threshold);
    cJSON_AddNumberToObject(o, "scenes", j->set.count);
    cJSON_AddItemToObject(o, "start", point_json(&j->first));
    cJSON_AddItemToObject(o, "best", point_json(&j->best));
    cJSON_AddNumberToObject(o, "evaluations", n.evaluations);
    cJSON_AddNumberToObject(o, "calls", n.calls);
    cJSON_AddNumberToObject(o, "iterations", n.iterations);
    cJSON_AddNumberToObject(o, "seconds", j->seconds);
    cJSON_AddItemToObject(o, "stopped", j->stopped[0] ? cJSON_CreateString(j->stopped) : cJSON_CreateNull());
    cJSON_AddItemToObject(o, "trace", trace_json(&j->tune));
    return o;
}

int tune_write_json(const tune_job *j, tool_fail *f)
{
    return json_write(j->json, job_json(j), f);
}

int tune_write_header(const tune_job *j, tool_fail *f)
{
    tool_out out;
    int status = tool_out_open(&out, j->header, f);
    if (status)
        return status;
    fprintf(out.stream,
            "/* Found by stad tune, method %s, cost %s: %.3f %% (%.3f %% at the start), bad %.3f %%, density "
            "%.2f %%%s%s. */\n"
            "#ifndef STAD_TUNED_PARAMS_H\n#define STAD_TUNED_PARAMS_H\n\n#include <stad/params.h>\n\n"
            "#define STAD_TUNED_MODE %d /* %s */\n\nstatic const stad_params stad_tuned_params = {\n",
            tune_method_name(j->method), tune_cost_name(j->how.cost), 100 * j->best.cost, 100 * j->first.cost, 100 * j->best.bad,
            100 * j->best.density, j->stopped[0] ? "; " : "", j->stopped, j->how.mode, params_mode_name(j->how.mode));
    for (int i = 0; i < FIELD_COUNT; i++)
        fprintf(out.stream, "    %ld, /* %s */\n", params_get(&j->best.params, i), params_field_name(i));
    fputs("};\n\n#endif\n", out.stream);
    return tool_out_close(&out, 1, f);
}
