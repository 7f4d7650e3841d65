/* SPDX-License-Identifier: MIT
 * stad/report_tune.c - the report of `stad tune`: before and after, parameters, the search, the commands. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../common/colour.h"
#include "report.h"
#include "report_make.h"

/* Pictures are shown of this many scenes of a list. */
#define REPORT_SCENES 6

/* A scene at the start and at the best point. */
typedef struct before_after {
    disparity disp[2];
    picture map[2], error[2];
    measures m[2];
} before_after;

static void free_both(before_after *b)
{
    for (int i = 0; i < 2; i++) {
        disparity_free(&b->disp[i]);
        picture_free(&b->map[i]);
        picture_free(&b->error[i]);
    }
}

/* The tuned values on a scene's own range. */
static stad_params tuned(const scored_scene *c, const tune_point *at)
{
    stad_params p = c->base;
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        params_set(&p, tune_field(i), params_get(&at->params, tune_field(i)));
    return p;
}

static int match_both(before_after *b, scored_scene *c, const tune_job *j, tool_fail *f)
{
    const tune_point *at[2] = {&j->first, &j->best};
    int status = TOOL_OK;
    memset(b, 0, sizeof *b);
    for (int i = 0; i < 2 && status == TOOL_OK; i++) {
        stad_params p = tuned(c, at[i]);
        status = engine_run(&c->engine, &p, &c->left, &c->right, &b->disp[i], NULL, f);
        if (status == TOOL_OK)
            status = measure(&b->m[i], &b->disp[i], &c->truth, p.num_disparities, j->how.threshold, f);
        if (status == TOOL_OK)
            status = colour_disparity(&b->map[i], &b->disp[i], p.num_disparities, f);
        if (status == TOOL_OK)
            status = colour_error_map(&b->error[i], &b->disp[i], &c->truth, j->how.threshold, f);
    }
    return status;
}

static int show_truth(report *r, const scored_scene *c, tool_fail *f)
{
    picture truth, left = {c->left.width, c->left.height, c->left.channels, c->left.pix};
    int status = colour_truth(&truth, &c->truth, c->base.min_disparity, c->base.num_disparities, f);
    if (status)
        return status;
    if (left.channels == 1)
        status = report_slider(r, &left, &truth, "left frame", "truth", f);
    else
        status = report_picture(r, &truth, "truth", f);
    picture_free(&truth);
    return status;
}

static int scene_part(report *r, scored_scene *c, const tune_job *j, tool_fail *f)
{
    static const char *const names[2] = {"before", "after"};
    before_after b;
    report_heading(r, c->left_path);
    int status = match_both(&b, c, j, f);
    if (status == TOOL_OK) {
        report_measures(r, b.m, names, 2);
        status = report_slider(r, &b.map[0], &b.map[1], "disparity before", "disparity after", f);
    }
    report_scale(r, c->base.min_disparity, c->base.num_disparities);
    if (status == TOOL_OK)
        status = report_slider(r, &b.error[0], &b.error[1], "error before", "error after", f);
    report_error_legend(r, j->how.threshold);
    if (status == TOOL_OK)
        status = show_truth(r, c, f);
    free_both(&b);
    return status;
}

static void parameters(report *r, const tune_job *j)
{
    fputs("<table><tr><th>parameter</th><th>before</th><th>after</th><th></th></tr>\n", r->to);
    for (int i = 0; i < FIELD_COUNT; i++) {
        const char *kind = "kept";
        for (int k = 0; k < STAD_TUNE_DIMS; k++)
            if (tune_field(k) == i && j->tune.config.free_mask >> k & 1)
                kind = "free";
        fprintf(r->to, "<tr><td>%s</td><td>%ld</td><td>%ld</td><td>%s</td></tr>\n", params_field_name(i),
                params_get(&j->first.params, i), params_get(&j->best.params, i), kind);
    }
    fputs("</table>\n", r->to);
}

static void search(report *r, const tune_job *j)
{
    static double cost[STAD_TUNE_LOG];
    stad_point x;
    int32_t q20;
    int n = 0;
    while (n < STAD_TUNE_LOG && stad_tune_trace(&j->tune, n, &x, &q20) == STAD_OK) {
        cost[n] = q20 == STAD_COST_FAILED ? (double)NAN : (double)q20 / STAD_COST_ONE;
        n++;
    }
    report_curve(r, cost, n, tune_cost_name(j->how.cost));
}

static void verdict(report *r, const tune_job *j)
{
    char gain[60], n[40];
    if (j->stopped[0])
        fprintf(r->to, "<p><strong>The search was %s.</strong></p>\n", j->stopped);
    fprintf(r->to,
            "<p><strong>%s: %.3f %% before, %.3f %% after</strong>, %s, with %s of "
            "method %s in %.1f s, mode "
            "%s, %d scene%s.</p>\n<p class=\"soft\">Measured on what it was tuned on. Whether it holds "
            "elsewhere, other scenes must "
            "say: <code>stad match --params</code> and <code>stad eval</code>.</p>\n",
            tune_cost_name(j->how.cost), 100 * j->first.cost, 100 * j->best.cost, tune_gain(gain, sizeof gain, j),
            tune_evaluations(n, sizeof n, j), tune_method_name(j->method), j->seconds, params_mode_name(j->how.mode),
            j->set.count, j->set.count == 1 ? "" : "s");
}

/* `stad match` with what was found, for the first scene. */
static void match_command(char *line, size_t room, const tune_job *j)
{
    int n = snprintf(line, room, "stad match LEFT RIGHT -o OUT.npy --mode %s%s", params_mode_name(j->how.mode),
                     j->options.color ? " --color" : "");
    for (int i = 0; i < FIELD_COUNT && n > 0 && (size_t)n < room; i++)
        n += snprintf(line + n, room - (size_t)n, " --%s %ld", params_field_option(i), params_get(&j->best.params, i));
}

int report_tune(const char *path, const char *command, const report_rig *rig, tune_job *j, tool_fail *f)
{
    report r;
    char match[600];
    int status = report_open(&r, path, "Parameters tuned", rig->focal_px * rig->baseline_m, f);
    if (status)
        return status;
    verdict(&r, j);
    parameters(&r, j);
    report_heading(&r, "The search");
    search(&r, j);
    for (int i = 0; i < j->set.count && i < REPORT_SCENES && status == TOOL_OK; i++)
        status = scene_part(&r, &j->set.scene[i], j, f);
    report_heading(&r, "To repeat it");
    match_command(match, sizeof match, j);
    const char *const commands[2] = {command, match};
    report_commands(&r, commands, 2);
    return report_close(&r, status == TOOL_OK, f);
}
