/* SPDX-License-Identifier: MIT
 * stad/report_eval.c - the report of `stad eval`: measures, the map against the truth, where it errs. */
#include "../common/colour.h"
#include "report.h"
#include "report_make.h"
#include "tool.h"

int report_rig_option(report_rig *r, int is_focal, const char *text, tool_fail *f)
{
    return is_focal ? tool_real("focal", text, 1, 1e6, &r->focal_px, f)
                    : tool_real("baseline", text, 1e-4, 1e3, &r->baseline_m, f);
}

static int pictures(report *r, const disparity *d, const truth_map *t, int num_disparities, double threshold, tool_fail *f)
{
    picture map = {0}, truth = {0}, error = {0};
    int status = colour_disparity(&map, d, num_disparities, f);
    if (status == TOOL_OK)
        status = colour_truth(&truth, t, d->none_q4 / 16 + 1, num_disparities, f);
    if (status == TOOL_OK)
        status = colour_error_map(&error, d, t, threshold, f);
    report_heading(r, "Disparity");
    if (status == TOOL_OK)
        status = report_slider(r, &map, &truth, "matched", "truth", f);
    report_scale(r, d->none_q4 / 16 + 1, num_disparities);
    report_heading(r, "Error");
    if (status == TOOL_OK)
        status = report_picture(r, &error, "error of each pixel whose truth is known", f);
    report_error_legend(r, threshold);
    picture_free(&map);
    picture_free(&truth);
    picture_free(&error);
    return status;
}

int report_eval(const char *path, const char *command, const report_rig *rig, const disparity *d, const truth_map *t,
                int num_disparities, const measures *m, tool_fail *f)
{
    static const char *const names[1] = {"measured"};
    report r;
    int status = report_open(&r, path, "A disparity map against the truth", rig->focal_px * rig->baseline_m, f);
    if (status)
        return status;
    report_measures(&r, m, names, 1);
    fprintf(r.to,
            "<p class=\"soft\">%d pixels scored that both cameras see, %d hidden from the right one; columns "
            "from %d on.</p>\n",
            m->counts.visible, m->counts.occluded, d->none_q4 / 16 + 1 + num_disparities);
    status = pictures(&r, d, t, num_disparities, m->threshold, f);
    report_heading(&r, "To repeat it");
    report_commands(&r, &command, 1);
    return report_close(&r, status == TOOL_OK, f);
}
