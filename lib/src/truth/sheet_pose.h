/* SPDX-License-Identifier: MIT
 * truth/sheet_pose.h - where a target is, from the disparities of its marks.
 *
 * A point of the world is written P = ((x - cx) / d, (y - cy) / d, f / d): metric up to one factor, the baseline, which cancels.
 * On the sheet P is affine in millimetres, and a height goes along the normal with the same scale. */
#ifndef STAD_TRUTH_SHEET_POSE_H
#define STAD_TRUTH_SHEET_POSE_H

#include "stad/truth.h"

/* P = origin + x along_x + y along_y + h up, x, y, h in mm; Q24. */
typedef struct sheet_pose {
    int64_t origin[3];
    int32_t along_x[3], along_y[3], up[3];
    stad_camera camera;
} sheet_pose;

/* A point of the target as the left camera sees it. */
typedef struct sheet_sight {
    stad_corner p;
    int32_t d_q16;
} sheet_sight;

/* The pose from the corners of the pairs in `ids`, their disparity taken from the base plane. 1, or 0 when it is degenerate. */
int stad_sheet_pose(sheet_pose *pose, const stad_target *target, const stad_camera *camera, const stad_plane *base,
                    const stad_pair *pairs, int n, uint32_t ids);

/* Are a millimetre across and one down alike, and at a right angle, to a part in 32 of their squares? On a sheet that leans they
 * are not when focal length or principal point are wrong. */
int stad_sheet_is_square(const sheet_pose *pose);

/* 1, or 0 when the point is behind the camera or too far outside the image. */
int stad_sheet_see(const sheet_pose *pose, int32_t x_mm, int32_t y_mm, int32_t h_mm, sheet_sight *sight);

/* The plane of disparity through the four corners of a facet. 1, or 0 when it is degenerate or too steep. */
int stad_plane_through(const sheet_sight sight[4], stad_plane *plane);

#endif
