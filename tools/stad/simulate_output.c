/* SPDX-License-Identifier: MIT
 * stad/simulate_output.c - what a simulated board did: for a person, as CSV, as JSON, as a report. */
#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>

#include "simulate.h"

#define NAME_OF(list, i) ((i) >= 0 && (i) < (int)(sizeof(list) / sizeof(list)[0]) ? (list)[i] : "?")

const char *simulate_state_name(int state)
{
    static const char *const names[] = {"learning", "ok", "degraded"};
    return NAME_OF(names, state);
}

const char *simulate_phase_name(int phase)
{
    static const char *const names[] = {"idle",  "look", "other",     "confirm", "pick",   "tune",
                                        "judge", "save", "probation", "recheck", "compare"};
    return NAME_OF(names, phase);
}

const char *simulate_outcome_name(int outcome)
{
    static const char *const names[] = {"none",       "sound",       "adopted",  "corrected",
                                        "kept",       "rolled back", "no marks", "no pose",
                                        "rig failed", "fault",       "cancelled"};
    return NAME_OF(names, outcome);
}

const char *simulate_fault_name(int fault)
{
    static const char *const names[] = {"none",    "late",  "black", "saturated", "flat", "frozen",
                                        "swapped", "marks", "range", "rig",       "size", "camera",
                                        "moving"};
    return NAME_OF(names, fault);
}

const char *simulate_verdict_name(int verdict)
{
    static const char *const names[] = {"good", "watch", "correct", "fail"};
    return NAME_OF(names, verdict);
}

sim_correction simulate_correction(const stad_rig *rig)
{
    const double unit = 16777216.0; /* Q24 */
    sim_correction c = {rig->a_q16 / 65536.0, rig->b_q24 / unit * 180 / 3.14159265358979,
                        100 * rig->c_q24 / unit};
    return c;
}

static void print_correction(const stad_setup *setup)
{
    sim_correction c = simulate_correction(&setup->rig);
    if (setup->corrected)
        printf(", right view corrected by %.2f px, %.2f degrees, %.2f %%", c.dy_px, c.roll_degrees,
               c.scale_percent);
}

static void print_setup(const stad_setup *setup)
{
    for (int i = 0; i < FIELD_COUNT; i++)
        printf("%s%s %ld", i ? ", " : "", params_field_name(i), params_get(&setup->params, i));
    print_correction(setup);
    putchar('\n');
}

/* A verdict was given: marks were seen. */
static int saw_marks(const stad_calib_report *c)
{
    return c->rig.corners > 0;
}

static void print_costs(const stad_calib_report *c)
{
    if (saw_marks(c))
        printf(", rig %s -> %s", simulate_verdict_name(c->verdict_before),
               simulate_verdict_name(c->verdict_after));
    if (c->evaluations)
        printf(", %d evaluations, tuning pose %.2f -> %.2f %%, other pose %.2f -> %.2f %%", c->evaluations,
               100.0 * c->tune_before_q20 / STAD_COST_ONE, 100.0 * c->tune_after_q20 / STAD_COST_ONE,
               100.0 * c->judge_before_q20 / STAD_COST_ONE, 100.0 * c->judge_after_q20 / STAD_COST_ONE);
    if (c->fault)
        printf(", last fault: %s", simulate_fault_name(c->fault));
    putchar('\n');
}

static void print_run(const sim_run *r)
{
    printf("frame %d: run ended: %s", r->frame, simulate_outcome_name(r->report.outcome));
    print_costs(&r->report);
}

/* What a recording that ends too soon leaves open. */
static const char *unfinished(int phase)
{
    switch (phase) {
    case STAD_CALIB_IDLE:
        return "";
    case STAD_CALIB_PROBATION:
    case STAD_CALIB_RECHECK:
    case STAD_CALIB_COMPARE:
        return " (the set in use is adopted and stored, its probation was not over at the last frame)";
    default:
        return " (a run was under way at the last frame, nothing of it is adopted)";
    }
}

int simulate_learning(const simulation *s)
{
    for (int i = s->row_count - 1; i >= 0; i--)
        if (!s->rows[i].skipped)
            return s->rows[i].state == STAD_MONITOR_LEARNING;
    return 0;
}

void simulate_print(const simulation *s)
{
    const stad_calib_report *now = stad_calib_report_of(&s->calib);
    printf("%d frames of %d x %d", s->row_count - s->skipped, s->geometry.width,
           s->geometry.height);
    if (s->skipped)
        printf(", %d skipped", s->skipped);
    printf(", %.1f a second\n", s->seconds > 0 ? (s->row_count - s->skipped) / s->seconds : 0.0);
    for (int i = 0; i < s->row_count; i++)
        if (s->rows[i].state == STAD_MONITOR_DEGRADED)
            printf("frame %d: the monitor asks for a recalibration, firm share %.2f %%\n", s->rows[i].frame,
                   100 * s->rows[i].share);
    if (simulate_learning(s))
        printf("monitor: still learning what is usual at the last frame: no alarm could come (--learn-frames)\n");
    for (int i = 0; i < s->run_count; i++)
        print_run(&s->runs[i]);
    printf("state:   %s%s", simulate_phase_name(now->phase), unfinished(now->phase));
    if (now->phase != STAD_CALIB_IDLE)
        print_costs(now);
    else
        putchar('\n');
    fputs("in use:  ", stdout);
    print_setup(stad_calib_setup(&s->calib));
    if (s->stored_slot >= 0) {
        printf("stored:  ");
        print_setup(&s->stored);
    } else {
        puts("stored:  nothing");
    }
}

int simulate_write_csv(const simulation *s, tool_fail *f)
{
    tool_out out;
    int status = tool_out_open(&out, s->csv, f);
    if (status)
        return status;
    fputs("frame,state,phase,firm_share,considered,firm,valid,rejected_uniqueness,rejected_check",
          out.stream);
    for (int k = 0; k < FIELD_COUNT; k++)
        fprintf(out.stream, ",%s", params_field_name(k));
    fputs(",fault\n", out.stream);
    for (int i = 0; i < s->row_count; i++) {
        const sim_row *r = &s->rows[i];
        const stad_match_counts *c = &r->counts;
        fprintf(out.stream, "%d,%s,%s,%.5f,%d,%d,%d,%d,%d", r->frame,
                r->skipped ? "skipped" : simulate_state_name(r->state), simulate_phase_name(r->phase),
                r->share, c->considered, c->firm, c->valid, c->rejected_uniqueness, c->rejected_check);
        for (int k = 0; k < FIELD_COUNT; k++)
            fprintf(out.stream, ",%ld", params_get(&r->params, k));
        fprintf(out.stream, ",%s\n", simulate_fault_name(r->fault));
    }
    return tool_out_close(&out, 1, f);
}

static cJSON *correction_json(const stad_rig *rig)
{
    cJSON *o = cJSON_CreateObject();
    sim_correction c = simulate_correction(rig);
    cJSON_AddNumberToObject(o, "dy_px", c.dy_px);
    cJSON_AddNumberToObject(o, "roll_degrees", c.roll_degrees);
    cJSON_AddNumberToObject(o, "scale_percent", c.scale_percent);
    return o;
}

static cJSON *setup_json(const stad_setup *setup)
{
    cJSON *o = cJSON_CreateObject();
    cJSON_AddItemToObject(o, "params", params_to_json(&setup->params));
    cJSON_AddBoolToObject(o, "corrected", setup->corrected);
    cJSON_AddItemToObject(o, "correction", setup->corrected ? correction_json(&setup->rig) : cJSON_CreateNull());
    return o;
}

static cJSON *verdict_json(const stad_calib_report *c, int verdict)
{
    return saw_marks(c) ? cJSON_CreateString(simulate_verdict_name(verdict)) : cJSON_CreateNull();
}

static cJSON *run_json(const sim_run *r)
{
    const stad_calib_report *c = &r->report;
    cJSON *o = setup_json(&r->setup);
    cJSON_AddNumberToObject(o, "frame", r->frame);
    cJSON_AddStringToObject(o, "outcome", simulate_outcome_name(c->outcome));
    cJSON_AddStringToObject(o, "fault", simulate_fault_name(c->fault));
    cJSON_AddNumberToObject(o, "evaluations", c->evaluations);
    cJSON_AddNumberToObject(o, "tune_before", (double)c->tune_before_q20 / STAD_COST_ONE);
    cJSON_AddNumberToObject(o, "tune_after", (double)c->tune_after_q20 / STAD_COST_ONE);
    cJSON_AddNumberToObject(o, "judge_before", (double)c->judge_before_q20 / STAD_COST_ONE);
    cJSON_AddNumberToObject(o, "judge_after", (double)c->judge_after_q20 / STAD_COST_ONE);
    cJSON_AddItemToObject(o, "verdict_before", verdict_json(c, c->verdict_before));
    cJSON_AddItemToObject(o, "verdict_after", verdict_json(c, c->verdict_after));
    return o;
}

static cJSON *simulation_json(const simulation *s)
{
    cJSON *o = cJSON_CreateObject(), *runs = cJSON_CreateArray(), *alarms = cJSON_CreateArray();
    cJSON_AddNumberToObject(o, "frames", s->row_count);
    cJSON_AddNumberToObject(o, "skipped", s->skipped);
    cJSON_AddItemToObject(o, "stopped", s->stopped[0] ? cJSON_CreateString(s->stopped) : cJSON_CreateNull());
    cJSON_AddBoolToObject(o, "learning", simulate_learning(s));
    cJSON_AddStringToObject(o, "phase", simulate_phase_name(stad_calib_report_of(&s->calib)->phase));
    for (int i = 0; i < s->row_count; i++)
        if (s->rows[i].state == STAD_MONITOR_DEGRADED)
            cJSON_AddItemToArray(alarms, cJSON_CreateNumber(s->rows[i].frame));
    cJSON_AddItemToObject(o, "alarms", alarms);
    for (int i = 0; i < s->run_count; i++)
        cJSON_AddItemToArray(runs, run_json(&s->runs[i]));
    cJSON_AddItemToObject(o, "runs", runs);
    cJSON_AddItemToObject(o, "in_use", setup_json(stad_calib_setup(&s->calib)));
    cJSON_AddItemToObject(o, "stored", s->stored_slot >= 0 ? setup_json(&s->stored) : cJSON_CreateNull());
    cJSON_AddNumberToObject(o, "seconds", s->seconds);
    return o;
}

int simulate_write_json(const simulation *s, tool_fail *f)
{
    tool_out out;
    int status = tool_out_open(&out, s->json, f);
    if (status)
        return status;
    cJSON *o = simulation_json(s);
    char *text = cJSON_Print(o);
    if (text)
        fprintf(out.stream, "%s\n", text);
    else
        tool_fail_set(f, TOOL_FILE, "%s: not enough memory", s->json);
    status = tool_out_close(&out, text != NULL, f);
    cJSON_free(text);
    cJSON_Delete(o);
    return status;
}
