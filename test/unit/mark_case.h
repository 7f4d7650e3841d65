/* SPDX-License-Identifier: MIT
 * unit/mark_case.h - rendered frames of a calibration target for the tests of mark, truth and rig. */
#ifndef TEST_MARK_CASE_H
#define TEST_MARK_CASE_H

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "scene/target_scene.h"
#include "stad/stad.h"

enum { CASE_WIDTH = 320, CASE_HEIGHT = 240, CASE_PIXELS = CASE_WIDTH * CASE_HEIGHT };

typedef struct mark_case {
    target_camera camera;
    target_pose pose;
    const stad_target *target;
    double noise;
    unsigned seed;
    int room; /* quads of clutter behind */
} mark_case;

static target_scene case_scene;
static float case_grey[CASE_PIXELS];
static uint8_t case_left[CASE_PIXELS], case_right[CASE_PIXELS];
static uint8_t case_work[STAD_MARK_BYTES(CASE_WIDTH, CASE_HEIGHT)] STAD_ALIGNED;

/* The relief target, its marks about 34 px a side, leaning back, in front of a cluttered room. */
static inline mark_case case_of(unsigned seed)
{
    mark_case c;
    memset(&c, 0, sizeof c);
    target_camera_default(&c.camera, CASE_WIDTH, CASE_HEIGHT);
    target_random r;
    target_random_seed(&r, seed);
    c.pose.centre.x = 10 + 30 * target_random_uniform(&r);
    c.pose.centre.y = 20 * target_random_uniform(&r) - 10;
    c.pose.centre.z = 470 + 60 * target_random_uniform(&r);
    c.pose.pitch = 0.2 + 0.4 * target_random_uniform(&r);
    c.pose.yaw = 0.3 * target_random_uniform(&r) - 0.15;
    c.pose.roll = 0.4 * target_random_uniform(&r) - 0.2;
    c.target = stad_target_relief();
    c.noise = 3;
    c.seed = seed;
    c.room = 8;
    return c;
}

static inline void case_view(const mark_case *c, int view, uint8_t *pix)
{
    target_random r;
    target_random_seed(&r, c->seed * 2u + (unsigned)view);
    target_render(&case_scene, &c->camera, view, NULL, case_grey, NULL);
    target_expose(case_grey, CASE_PIXELS, 30, 220);
    target_add_noise(case_grey, CASE_PIXELS, c->noise, &r);
    target_quantise(case_grey, CASE_PIXELS, pix);
}

/* Renders both views into case_left and case_right. */
static inline void case_render(const mark_case *c)
{
    target_scene_clear(&case_scene);
    if (c->target)
        target_scene_add(&case_scene, c->target, &c->pose);
    target_scene_add_room(&case_scene, &c->camera, c->pose.centre.z * 1.5, c->pose.centre.z * 4, c->room, c->seed);
    case_view(c, 0, case_left);
    case_view(c, 1, case_right);
}

/* The true corner of a mark in the left (0) or the drifted right view (1), px. */
static inline void case_corner(const mark_case *c, int tag, int corner, int view, double *x, double *y)
{
    const stad_target_tag *t = &c->target->tags[tag];
    const double x_mm = t->x_mm + (corner == 1 || corner == 2 ? c->target->tag_mm : 0);
    const double y_mm = t->y_mm + (corner >= 2 ? c->target->tag_mm : 0);
    const target_vector p = target_point(c->target, &c->pose, x_mm, y_mm, 0);
    *x = c->camera.cx + c->camera.f * (p.x - (view ? c->camera.baseline : 0)) / p.z;
    *y = c->camera.cy + c->camera.f * p.y / p.z;
    if (view)
        target_drift(&c->camera, x, y);
}

static inline int case_find(const uint8_t *pix, stad_mark *marks, int max)
{
    const stad_image image = stad_image_packed(pix, CASE_WIDTH, CASE_HEIGHT, 1);
    return stad_mark_find(&image, NULL, marks, max, case_work, sizeof case_work);
}

/* Finds and pairs the marks of both views. */
static inline int case_pairs(stad_pair *pairs, int max)
{
    stad_mark left[32], right[32];
    const int n_left = case_find(case_left, left, 32), n_right = case_find(case_right, right, 32);
    return stad_mark_pair(left, n_left, right, n_right, pairs, max);
}

#endif
