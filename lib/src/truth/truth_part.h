/* SPDX-License-Identifier: MIT
 * truth/truth_part.h - adds a raised part of a target to a truth. */
#ifndef STAD_TRUTH_PART_H
#define STAD_TRUTH_PART_H

#include "truth/sheet_pose.h"

/* Masks the outline of a part. STAD_OK, or a status. */
int stad_truth_add_outline(stad_truth *t, const sheet_pose *pose, const stad_target *target, int part);

/* Adds a facet. Returns 1, 0 when it is turned away or edge on, or a status. */
int stad_truth_add_facet(stad_truth *t, const sheet_pose *pose, const stad_target_facet *facet);

#endif
