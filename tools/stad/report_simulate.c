/* SPDX-License-Identifier: MIT
 * stad/report_simulate.c - the report of `stad simulate`: the monitor's signal, runs, setup before and after, a frame with both. */
#include <string.h>

#include "../common/colour.h"
#include "simulate.h"

#define PLOT_W 640
#define PLOT_H 180

static double frame_x(const simulation *s, int i)
{
    return s->row_count > 1 ? (double)i * PLOT_W / (s->row_count - 1) : 0;
}

static void signal_plot(report *r, const simulation *s)
{
    fprintf(r->to, "<svg class=\"signal\" viewBox=\"-60 -10 %d %d\" width=\"%d\">", PLOT_W + 80, PLOT_H + 50, PLOT_W + 80);
    for (int i = 0; i <= 4; i++)
        fprintf(r->to,
                "<line x1=\"0\" x2=\"%d\" y1=\"%d\" y2=\"%d\" stroke=\"var(--line)\"/><text x=\"-6\" "
                "y=\"%d\" text-anchor=\"end\">%d %%</text>",
                PLOT_W, PLOT_H - i * PLOT_H / 4, PLOT_H - i * PLOT_H / 4, PLOT_H - i * PLOT_H / 4 + 4, 25 * i);
    fputs("<polyline fill=\"none\" stroke=\"var(--mark)\" stroke-width=\"2\" points=\"", r->to);
    for (int i = 0; i < s->row_count; i++)
        if (!s->rows[i].skipped)
            fprintf(r->to, "%.1f,%.1f ", frame_x(s, i), PLOT_H * (1 - s->rows[i].share));
    fputs("\"/>", r->to);
    for (int i = 0; i < s->row_count; i++)
        if (s->rows[i].state == STAD_MONITOR_DEGRADED || s->rows[i].skipped)
            fprintf(r->to,
                    "<line class=\"%s\" x1=\"%.1f\" x2=\"%.1f\" y1=\"0\" y2=\"%d\" stroke=\"%s\" "
                    "stroke-width=\"2\"/>",
                    s->rows[i].skipped ? "skipped" : "alarm", frame_x(s, i), frame_x(s, i), PLOT_H,
                    s->rows[i].skipped ? "#999" : "#d33");
    fprintf(r->to, "<text x=\"0\" y=\"%d\">frame %d</text><text x=\"%d\" y=\"%d\" text-anchor=\"end\">%d</text></svg>\n",
            PLOT_H + 18, s->rows[0].frame, PLOT_W, PLOT_H + 18, s->rows[s->row_count - 1].frame);
    fputs("<p class=\"soft\">Share of firm pixels, which the monitor watches; red: it asks for a "
          "recalibration; grey: a frame that could not "
          "be read.</p>\n",
          r->to);
}

/* What decided, by enum stad_calib_outcome. */
static const char *decision(int outcome)
{
    static const char *const reasons[] = {"under way",
                                          "the rig is sound: nothing to do",
                                          "better on the other pose, by the margin",
                                          "the correction was confirmed; no other set held on the other pose",
                                          "nothing held on the other pose",
                                          "worse on probation: the set before came back",
                                          "no marks were seen in time",
                                          "the target was not shown in another pose",
                                          "the rows do not agree, or no correction was confirmed on a target held still",
                                          "too many frames of no use",
                                          "called off"};
    return outcome >= 0 && outcome < (int)(sizeof reasons / sizeof reasons[0]) ? reasons[outcome] : "?";
}

static const char *verdict(const stad_calib_report *c, int verdict)
{
    return c->rig.corners > 0 ? calib_verdict_name(verdict) : "&ndash;";
}

static void cost_cell(report *r, int32_t before_q20, int32_t after_q20)
{
    const int32_t costs[2] = {before_q20, after_q20};
    fputs("<td>", r->to);
    for (int i = 0; i < 2; i++) {
        if (simulate_is_measured(costs[i]))
            fprintf(r->to, "%.2f", 100.0 * costs[i] / STAD_COST_ONE);
        else
            fputs("&ndash;", r->to);
        fputs(i == 0 ? " &rarr; " : " %</td>", r->to);
    }
}

static void live_faults(report *r, const simulation *s)
{
    int last;
    for (int i = simulate_spell(s, 0, &last); i < s->row_count; i = simulate_spell(s, last + 1, &last))
        fprintf(r->to, "<p>Camera fault in the frames %d to %d: %s.</p>\n", s->rows[i].frame, s->rows[last].frame,
                calib_fault_name(s->rows[i].live));
}

static void runs(report *r, const simulation *s)
{
    if (s->run_count == 0) {
        const int phase = stad_calib_report_of(&s->calib)->phase;
        const int adopted = phase == STAD_CALIB_PROBATION || phase == STAD_CALIB_RECHECK || phase == STAD_CALIB_COMPARE;
        fputs(adopted ? "<p>A run has adopted and stored a set; its probation was not over at the last frame.</p>\n"
              : phase != STAD_CALIB_IDLE ? "<p>A run was under way at the last frame: nothing of it is adopted or stored.</p>\n"
                                         : "<p>There was no run: nothing was adopted and nothing stored.</p>\n",
              r->to);
        return;
    }
    fputs("<table><tr><th>run ended at frame</th><th>outcome</th><th>last "
          "fault</th><th>rig</th><th>evaluations</th><th>tuning pose</th><th>other "
          "pose</th><th>why</th></tr>\n",
          r->to);
    for (int i = 0; i < s->run_count; i++) {
        const stad_calib_report *c = &s->runs[i].report;
        fprintf(r->to, "<tr><td>%d</td><td>%s</td><td>%s</td><td>%s &rarr; %s</td><td>%d</td>", s->runs[i].frame,
                calib_outcome_name(c->outcome), calib_fault_name(c->fault), verdict(c, c->verdict_before),
                verdict(c, c->verdict_after), c->evaluations);
        cost_cell(r, c->tune_before_q20, c->tune_after_q20);
        cost_cell(r, c->judge_before_q20, c->judge_after_q20);
        fprintf(r->to, "<td>%s</td></tr>\n", decision(c->outcome));
    }
    fputs("</table>\n<p>Adopted is only what was better on a pose it was not tuned on.</p>\n", r->to);
}

static void correction(report *r, const char *which, const stad_setup *setup)
{
    sim_correction c = simulate_correction(&setup->rig);
    fprintf(r->to, "<p>Correction of the right view, %s: ", which);
    if (setup->corrected)
        fprintf(r->to, "%.2f px, %.2f degrees, %.2f %%.</p>\n", c.dy_px, c.roll_degrees, c.scale_percent);
    else
        fputs("none.</p>\n", r->to);
}

static void setups(report *r, const simulation *s)
{
    const stad_params *in_use = &stad_calib_setup(&s->calib)->params;
    fputs("<table><tr><th>parameter</th><th>at the start</th><th>in use at the end</th><th>stored</th></tr>\n", r->to);
    for (int i = 0; i < FIELD_COUNT; i++) {
        fprintf(r->to, "<tr><td>%s</td><td>%ld</td><td>%ld</td>", params_field_name(i), params_get(&s->initial.params, i),
                params_get(in_use, i));
        if (s->stored_slot >= 0)
            fprintf(r->to, "<td>%ld</td></tr>\n", params_get(&s->stored.params, i));
        else
            fputs("<td>&ndash;</td></tr>\n", r->to);
    }
    fputs("</table>\n", r->to);
    correction(r, "in use", stad_calib_setup(&s->calib));
    if (s->stored_slot >= 0)
        correction(r, "stored", &s->stored);
}

/* Row by row, as the setup has it. */
static int straighten(const stad_setup *setup, picture *right, tool_fail *f)
{
    picture out;
    const stad_image image = picture_view(right);
    if (!setup->corrected)
        return TOOL_OK;
    int status = picture_alloc(&out, right->width, right->height, right->channels, f);
    if (status)
        return status;
    for (int y = 0; y < right->height; y++)
        stad_rig_row(&setup->rig, &image, y, out.pix + (size_t)y * (size_t)right->width * (size_t)right->channels);
    picture_free(right);
    *right = out;
    return TOOL_OK;
}

static int map_with(simulation *s, const stad_setup *setup, int frame, picture *map, tool_fail *f)
{
    picture left, right;
    disparity d = {0};
    int status = recording_read(&s->frames, frame, s->options.color, &left, &right, f);
    if (status)
        return status;
    status = degrade_pair(&s->bad, frame, &left, &right, f);
    if (status == TOOL_OK)
        status = straighten(setup, &right, f);
    if (status == TOOL_OK)
        status = engine_run(&s->ahead.frame[0].engine, &setup->params, &left, &right, &d, NULL, f);
    if (status == TOOL_OK)
        status = colour_disparity(map, &d, setup->params.num_disparities, f);
    picture_free(&left);
    picture_free(&right);
    disparity_free(&d);
    return status;
}

/* The last frame that could be read, with the setup of the start and with that of the end. */
static int last_frame(report *r, simulation *s, tool_fail *f)
{
    picture map[2] = {{0, 0, 0, NULL}, {0, 0, 0, NULL}};
    int i = s->row_count - 1;
    while (i > 0 && s->rows[i].skipped)
        i--;
    report_heading(r, "The last frame");
    int status = map_with(s, &s->initial, s->rows[i].frame, &map[0], f);
    if (status == TOOL_OK)
        status = map_with(s, stad_calib_setup(&s->calib), s->rows[i].frame, &map[1], f);
    if (status == TOOL_OK)
        status = report_slider(r, &map[0], &map[1], "setup of the start", "setup of the end", f);
    report_scale(r, s->initial.params.min_disparity, s->initial.params.num_disparities);
    picture_free(&map[0]);
    picture_free(&map[1]);
    return status;
}

int simulate_write_report(simulation *s, tool_fail *f)
{
    report r;
    int status = report_open(&r, s->report, "A board, simulated", s->rig.focal_px * s->rig.baseline_m, f);
    if (status)
        return status;
    fprintf(r.to, "<p>Frames: %d, skipped: %d, alarms: %d, runs: %d.</p>\n", s->row_count, s->skipped, s->alarms, s->run_count);
    if (s->stopped[0]) {
        fputs("<p>Stopped before the end: ", r.to);
        report_escaped(&r, s->stopped);
        fputs("</p>\n", r.to);
    }
    if (simulate_learning(s))
        fputs("<p>The monitor was still learning what is usual at the last frame: no alarm could come.</p>\n", r.to);
    if (s->row_count)
        signal_plot(&r, s);
    live_faults(&r, s);
    report_heading(&r, "Runs");
    runs(&r, s);
    setups(&r, s);
    if (s->row_count > s->skipped)
        status = last_frame(&r, s, f);
    report_heading(&r, "To repeat it");
    report_commands(&r, (const char *const *)&s->command, 1);
    return report_close(&r, status == TOOL_OK, f);
}
