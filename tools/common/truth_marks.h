/* SPDX-License-Identifier: MIT
 * common/truth_marks.h - ground truth from a frame pair that shows the printed target. */
#ifndef TOOL_TRUTH_MARKS_H
#define TOOL_TRUTH_MARKS_H

#include "picture.h"
#include "stad/params.h"
#include "stad/target.h"
#include "truth_file.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Finds the marks of the relief target in both views and makes the truth that its planes give. TOOL_FILE: too few marks, or marks that
 * do not fit a sheet; TOOL_REFUSED: the views' rows do not agree, so that no parameters would help; TOOL_USAGE: the target is outside
 * the searched range, or the camera makes no rectangular sheet of the marks. `names`: the two files. */
int truth_from_marks(truth_map *t, const picture *left, const picture *right, const stad_params *p, const stad_camera *camera,
                     const char *names, tool_fail *f);

#ifdef __cplusplus
}
#endif

#endif
