/* SPDX-License-Identifier: MIT
 * stad/report.h - a report to look at: one HTML file that needs no other file and no network.
 *
 * Opened, filled from top to bottom, closed. Pictures are in it as data; the sliders are a few lines of script. */
#ifndef STAD_REPORT_H
#define STAD_REPORT_H

#include <stddef.h>
#include <stdio.h>

#include "../common/disparity_file.h"
#include "../common/picture.h"
#include "../common/truth_file.h"
#include "../common/whole_file.h"
#include "measure.h"

typedef struct report {
    FILE *to;
    tool_out out;
    double focal_baseline; /* focal length (px) * baseline (m); 0 = not known, distances are left out */
} report;

/* --focal PX and --baseline METRES, 0 = not given. Distances are shown where both are. */
typedef struct report_rig {
    double focal_px, baseline_m;
} report_rig;

/* The command as it was typed, quoted for a shell; to be called before getopt_long. malloc'd, NULL when there is no memory. */
char *report_command(int argc, char **argv);

int report_open(report *r, const char *path, const char *title, double focal_baseline, tool_fail *f);
int report_close(report *r, int ok, tool_fail *f);

/* Text is escaped. */
void report_escaped(report *r, const char *text);
void report_heading(report *r, const char *text);
void report_paragraph(report *r, const char *text);
void report_commands(report *r, const char *const *commands, int count);

int report_picture(report *r, const picture *p, const char *caption, tool_fail *f);

/* Two pictures of one size, the second laid over the first up to a line that the reader moves. */
int report_slider(report *r, const picture *before, const picture *after, const char *before_name, const char *after_name,
                  tool_fail *f);

/* What the colours of a disparity map and of an error map mean. */
void report_scale(report *r, int min_disparity, int num_disparities);
void report_error_legend(report *r, double threshold);

/* Costs of successive evaluations and the best so far, as a plot; a NAN is left out. */
void report_curve(report *r, const double *cost, int count, const char *name);

/* A table of measures, a column for each of `count`. */
void report_measures(report *r, const measures *m, const char *const *names, int count);

#endif
