/* SPDX-License-Identifier: MIT
 * stad/simulate_output.c - what a simulated board did: for a person, as CSV, as JSON, as a report. */
#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>

#include "simulate.h"

sim_correction simulate_correction(const stad_rig *rig)
{
    const double unit = 16777216.0; /* Q24 */
    sim_correction c = {rig->a_q16 / 65536.0, rig->b_q24 / unit * 180 / 3.14159265358979, 100 * rig->c_q24 / unit};
    return c;
}

static void print_correction(const stad_setup *setup)
{
    sim_correction c = simulate_correction(&setup->rig);
    if (setup->corrected)
        printf(", right view corrected by %.2f px, %.2f degrees, %.2f %%", c.dy_px, c.roll_degrees, c.scale_percent);
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

int simulate_is_measured(int32_t cost_q20)
{
    return cost_q20 >= 0 && cost_q20 != STAD_COST_FAILED;
}

static void print_cost(int32_t cost_q20)
{
    if (simulate_is_measured(cost_q20))
        printf("%.2f", 100.0 * cost_q20 / STAD_COST_ONE);
    else
        putchar('-');
}

static void print_change(const char *where, int32_t before_q20, int32_t after_q20)
{
    printf(", %s ", where);
    print_cost(before_q20);
    fputs(" -> ", stdout);
    print_cost(after_q20);
    fputs(" %", stdout);
}

static void print_costs(const stad_calib_report *c)
{
    if (saw_marks(c))
        printf(", rig %s -> %s", calib_verdict_name(c->verdict_before), calib_verdict_name(c->verdict_after));
    if (c->evaluations) {
        printf(", %d evaluations", c->evaluations);
        print_change("tuning pose", c->tune_before_q20, c->tune_after_q20);
        print_change("other pose", c->judge_before_q20, c->judge_after_q20);
    }
    if (c->fault)
        printf(", last fault: %s", calib_fault_name(c->fault));
    putchar('\n');
}

static void print_run(const sim_run *r)
{
    printf("frame %d: run ended: %s", r->frame, calib_outcome_name(r->report.outcome));
    print_costs(&r->report);
}

int simulate_spell(const simulation *s, int i, int *last)
{
    while (i < s->row_count && s->rows[i].live == STAD_FAULT_NONE)
        i++;
    for (*last = i; *last + 1 < s->row_count && s->rows[*last + 1].live == s->rows[i].live;)
        ++*last;
    return i;
}

static void print_spell(const simulation *s, int first, int last)
{
    if (first == last)
        printf("frame %d: camera fault: %s\n", s->rows[first].frame, calib_fault_name(s->rows[first].live));
    else
        printf("frame %d: camera fault: %s, to frame %d\n", s->rows[first].frame, calib_fault_name(s->rows[first].live),
               s->rows[last].frame);
}

/* Camera faults, alarms and ends of runs, by frame. */
static void print_events(const simulation *s)
{
    int last, run = 0, spell = simulate_spell(s, 0, &last);
    for (int i = 0; i < s->row_count; i++) {
        const sim_row *r = &s->rows[i];
        if (i == spell) {
            print_spell(s, i, last);
            spell = simulate_spell(s, last + 1, &last);
        }
        if (r->state == STAD_MONITOR_DEGRADED)
            printf("frame %d: the monitor asks for a recalibration, firm share %.2f %%\n", r->frame, 100 * r->share);
        while (run < s->run_count && s->runs[run].frame <= r->frame)
            print_run(&s->runs[run++]);
    }
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
    printf("%d frames of %d x %d", s->row_count - s->skipped, s->geometry.width, s->geometry.height);
    if (s->skipped)
        printf(", %d skipped", s->skipped);
    printf(", %.1f a second\n", s->seconds > 0 ? (s->row_count - s->skipped) / s->seconds : 0.0);
    print_events(s);
    if (simulate_learning(s))
        printf("monitor: still learning what is usual at the last frame: no alarm could come (--learn-frames)\n");
    printf("state:   %s%s", calib_phase_name(now->phase), unfinished(now->phase));
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
    fputs("frame,state,phase,firm_share,considered,firm,valid,rejected_uniqueness,rejected_check", out.stream);
    for (int k = 0; k < FIELD_COUNT; k++)
        fprintf(out.stream, ",%s", params_field_name(k));
    fputs(",fault,live_fault\n", out.stream);
    for (int i = 0; i < s->row_count; i++) {
        const sim_row *r = &s->rows[i];
        const stad_match_counts *c = &r->counts;
        fprintf(out.stream, "%d,%s,%s,%.5f,%d,%d,%d,%d,%d", r->frame, r->skipped ? "skipped" : calib_state_name(r->state),
                calib_phase_name(r->phase), r->share, c->considered, c->firm, c->valid, c->rejected_uniqueness,
                c->rejected_check);
        for (int k = 0; k < FIELD_COUNT; k++)
            fprintf(out.stream, ",%ld", params_get(&r->params, k));
        fprintf(out.stream, ",%s,%s\n", calib_fault_name(r->fault), calib_fault_name(r->live));
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
    return saw_marks(c) ? cJSON_CreateString(calib_verdict_name(verdict)) : cJSON_CreateNull();
}

static void add_cost(cJSON *o, const char *name, int32_t cost_q20)
{
    cJSON_AddItemToObject(
        o, name, simulate_is_measured(cost_q20) ? cJSON_CreateNumber((double)cost_q20 / STAD_COST_ONE) : cJSON_CreateNull());
}

static void add_report(cJSON *o, const stad_calib_report *c)
{
    cJSON_AddStringToObject(o, "fault", calib_fault_name(c->fault));
    cJSON_AddNumberToObject(o, "evaluations", c->evaluations);
    add_cost(o, "tune_before", c->tune_before_q20);
    add_cost(o, "tune_after", c->tune_after_q20);
    add_cost(o, "judge_before", c->judge_before_q20);
    add_cost(o, "judge_after", c->judge_after_q20);
    cJSON_AddItemToObject(o, "verdict_before", verdict_json(c, c->verdict_before));
    cJSON_AddItemToObject(o, "verdict_after", verdict_json(c, c->verdict_after));
}

static cJSON *run_json(const sim_run *r)
{
    cJSON *o = setup_json(&r->setup);
    cJSON_AddNumberToObject(o, "frame", r->frame);
    cJSON_AddStringToObject(o, "outcome", calib_outcome_name(r->report.outcome));
    add_report(o, &r->report);
    return o;
}

/* The run that the last frame left open, or null. */
static cJSON *open_run_json(const stad_calib_report *c)
{
    if (c->phase == STAD_CALIB_IDLE)
        return cJSON_CreateNull();
    cJSON *o = cJSON_CreateObject();
    cJSON_AddStringToObject(o, "phase", calib_phase_name(c->phase));
    add_report(o, c);
    return o;
}

static cJSON *live_faults_json(const simulation *s)
{
    int last;
    cJSON *list = cJSON_CreateArray();
    for (int i = simulate_spell(s, 0, &last); i < s->row_count; i = simulate_spell(s, last + 1, &last)) {
        cJSON *o = cJSON_CreateObject();
        cJSON_AddNumberToObject(o, "frame", s->rows[i].frame);
        cJSON_AddNumberToObject(o, "last_frame", s->rows[last].frame);
        cJSON_AddStringToObject(o, "fault", calib_fault_name(s->rows[i].live));
        cJSON_AddItemToArray(list, o);
    }
    return list;
}

static cJSON *simulation_json(const simulation *s)
{
    cJSON *o = cJSON_CreateObject(), *runs = cJSON_CreateArray(), *alarms = cJSON_CreateArray();
    cJSON_AddNumberToObject(o, "frames", s->row_count);
    cJSON_AddNumberToObject(o, "skipped", s->skipped);
    cJSON_AddItemToObject(o, "stopped", s->stopped[0] ? cJSON_CreateString(s->stopped) : cJSON_CreateNull());
    cJSON_AddBoolToObject(o, "learning", simulate_learning(s));
    cJSON_AddStringToObject(o, "phase", calib_phase_name(stad_calib_report_of(&s->calib)->phase));
    for (int i = 0; i < s->row_count; i++)
        if (s->rows[i].state == STAD_MONITOR_DEGRADED)
            cJSON_AddItemToArray(alarms, cJSON_CreateNumber(s->rows[i].frame));
    cJSON_AddItemToObject(o, "alarms", alarms);
    for (int i = 0; i < s->run_count; i++)
        cJSON_AddItemToArray(runs, run_json(&s->runs[i]));
    cJSON_AddItemToObject(o, "runs", runs);
    cJSON_AddItemToObject(o, "run_under_way", open_run_json(stad_calib_report_of(&s->calib)));
    cJSON_AddItemToObject(o, "live_faults", live_faults_json(s));
    cJSON_AddItemToObject(o, "in_use", setup_json(stad_calib_setup(&s->calib)));
    cJSON_AddItemToObject(o, "stored", s->stored_slot >= 0 ? setup_json(&s->stored) : cJSON_CreateNull());
    cJSON_AddNumberToObject(o, "seconds", s->seconds);
    return o;
}

int simulate_write_json(const simulation *s, tool_fail *f)
{
    return json_write(s->json, simulation_json(s), f);
}
