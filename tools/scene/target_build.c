/* SPDX-License-Identifier: MIT
 * target table -> [scene/target_build.c] -> render - puts targets and rooms into a scene. */
#include "scene/target_scene.h"

#include <math.h>
#include <string.h>

void target_scene_clear(target_scene *s)
{
    s->count = 0;
}

target_vector target_point(const stad_target *target, const target_pose *pose, double x_mm, double y_mm, double h_mm)
{
    const double x = x_mm - target->width_mm / 2.0, y = y_mm - target->height_mm / 2.0, z = -h_mm;
    const double rx = cos(pose->roll) * x - sin(pose->roll) * y, ry = sin(pose->roll) * x + cos(pose->roll) * y;
    const double yx = cos(pose->yaw) * rx - sin(pose->yaw) * z, yz = sin(pose->yaw) * rx + cos(pose->yaw) * z;
    const double py = cos(pose->pitch) * ry + sin(pose->pitch) * yz, pz = -sin(pose->pitch) * ry + cos(pose->pitch) * yz;
    const target_vector p = {pose->centre.x + yx, pose->centre.y + py, pose->centre.z + pz};
    return p;
}

static target_quad *new_quad(target_scene *s, const stad_target *target, int kind, unsigned seed)
{
    static target_quad overflow;
    target_quad *q = s->count < TARGET_MAX_QUADS ? &s->quad[s->count++] : &overflow;
    memset(q, 0, sizeof *q);
    q->target = target;
    q->kind = kind;
    q->seed = seed;
    return q;
}

static double distance(target_vector a, target_vector b)
{
    return sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

static void add_facet(target_scene *s, const stad_target *target, const target_pose *pose, const stad_target_facet *f)
{
    target_quad *q = new_quad(s, target, TARGET_PART, (unsigned)f->part + 1);
    for (int i = 0; i < 4; i++)
        q->p[i] = target_point(target, pose, f->x_mm[i], f->y_mm[i], f->h_mm[i]);
    q->u[1] = q->u[2] = distance(q->p[0], q->p[1]);
    q->v[2] = q->v[3] = distance(q->p[0], q->p[3]);
    for (int i = 0; i < 4; i++) {
        const int k = (i + 1) % 4;
        if (f->h_mm[i] == 0 && f->h_mm[k] == 0)
            continue;
        target_quad *wall = new_quad(s, target, TARGET_WALL, (unsigned)(f->part * 4 + i));
        wall->p[0] = target_point(target, pose, f->x_mm[i], f->y_mm[i], f->h_mm[i]);
        wall->p[1] = target_point(target, pose, f->x_mm[k], f->y_mm[k], f->h_mm[k]);
        wall->p[2] = target_point(target, pose, f->x_mm[k], f->y_mm[k], 0);
        wall->p[3] = target_point(target, pose, f->x_mm[i], f->y_mm[i], 0);
    }
}

void target_scene_add(target_scene *s, const stad_target *target, const target_pose *pose)
{
    const double w = target->width_mm, h = target->height_mm;
    const double x[4] = {0, w, w, 0}, y[4] = {0, 0, h, h};
    target_quad *base = new_quad(s, target, TARGET_SHEET, 0);
    for (int i = 0; i < 4; i++) {
        base->p[i] = target_point(target, pose, x[i], y[i], 0);
        base->u[i] = x[i];
        base->v[i] = y[i];
    }
    for (int i = 0; i < target->facet_count; i++)
        add_facet(s, target, pose, &target->facets[i]);
}

/* A rectangle of w x h mm about a point, turned by yaw and pitch. */
static void add_board(target_scene *s, target_vector centre, double w, double h, double yaw, double pitch, unsigned seed)
{
    const stad_target board = {"", (int16_t)w, (int16_t)h, 8, 0, 0, 0, NULL, NULL, NULL};
    const target_pose pose = {centre, pitch, yaw, 0};
    const double x[4] = {0, board.width_mm, board.width_mm, 0}, y[4] = {0, 0, board.height_mm, board.height_mm};
    target_quad *q = new_quad(s, NULL, TARGET_ROOM, seed);
    for (int i = 0; i < 4; i++) {
        q->p[i] = target_point(&board, &pose, x[i], y[i], 0);
        q->u[i] = x[i];
        q->v[i] = y[i];
    }
}

void target_scene_add_room(target_scene *s, const target_camera *c, double near_mm, double far_mm, int count, unsigned seed)
{
    target_random r;
    target_random_seed(&r, seed);
    const target_vector back = {0, 0, far_mm};
    add_board(s, back, 2.2 * far_mm * c->width / c->f, 2.2 * far_mm * c->height / c->f, 0.15, -0.1, seed * 64u);
    for (int i = 0; i < count; i++) {
        const double z = near_mm + (far_mm - near_mm) * 0.8 * target_random_uniform(&r);
        const double half_w = z * c->width / c->f / 2, half_h = z * c->height / c->f / 2;
        const target_vector p = {half_w * (2 * target_random_uniform(&r) - 1), half_h * (2 * target_random_uniform(&r) - 1), z};
        const double w = half_w * (0.1 + 0.6 * target_random_uniform(&r)), h = half_h * (0.1 + 0.8 * target_random_uniform(&r));
        const double yaw = target_random_uniform(&r) - 0.5, pitch = 0.6 * target_random_uniform(&r) - 0.3;
        add_board(s, p, w, h, yaw, pitch, seed * 64u + 1u + (unsigned)i);
    }
}
