/* SPDX-License-Identifier: MIT
 * stad/report_make.h - the reports of `stad eval` and `stad tune`. */
#ifndef STAD_REPORT_MAKE_H
#define STAD_REPORT_MAKE_H

#include "measure.h"
#include "tune_job.h"

int report_rig_option(report_rig *r, int is_focal, const char *text, tool_fail *f);

int report_eval(const char *path, const char *command, const report_rig *rig, const disparity *d, const truth_map *t,
                int num_disparities, const measures *m, tool_fail *f);

int report_tune(const char *path, const char *command, const report_rig *rig, tune_job *j, tool_fail *f);

#endif
