/* SPDX-License-Identifier: MIT
 * base plane, marks -> [truth/sheet_pose.c] -> facets - the target's place in space, up to scale. */
#include "truth/sheet_pose.h"

#include "base/affine.h"
#include "base/arith.h"
#include "base/log.h"

/* The root of the longest product, 3 * 2^46 in Q48: nothing is cut there, it says so to the analysis. */
enum { FAR_Q8 = 3000 * 256, MAX_UP_Q24 = 1 << 24 };

static int32_t plane_at_q16(const stad_plane *plane, stad_corner p)
{
    const int64_t slope = (int64_t)plane->a_q16 * p.x_q8 + (int64_t)plane->b_q16 * p.y_q8;
    return (int32_t)(slope / 256 + plane->c_q16);
}

/* Component k of P at a point of the base, Q13; INT32_MAX when it is out of range. */
static int32_t component_q13(const stad_camera *camera, const stad_plane *base, stad_corner p, int k)
{
    const int32_t d_q16 = plane_at_q16(base, p);
    if (d_q16 < 1 << 16)
        return INT32_MAX;
    const int64_t over_q8 = k == 0 ? p.x_q8 - camera->cx_q8 : k == 1 ? p.y_q8 - camera->cy_q8 : camera->f_q8;
    const int64_t value = over_q8 * (1 << 21) / d_q16;
    return value < 1 << 22 && value > -(1 << 22) ? (int32_t)value : INT32_MAX;
}

static const stad_target_tag *tag_of(const stad_target *target, int16_t id)
{
    for (int i = 0; i < target->tag_count; i++)
        if (target->tags[i].id == id)
            return &target->tags[i];
    return NULL;
}

/* Component k of P as an affine function of eighths of a millimetre. */
static int fit_component(const stad_target *target, const stad_camera *camera, const stad_plane *base, const stad_pair *pairs,
                         const stad_pair *end, uint32_t ids, stad_affine fit[3])
{
    for (int k = 0; k < 3; k++) {
        stad_affine_sums sums = {0, 0, 0, 0, 0, 0, 0, 0, 0};
        for (const stad_pair *pair = pairs; pair < end; pair++) {
            const stad_target_tag *tag = tag_of(target, pair->id);
            for (int i = 0; tag && (ids >> (pair->id & 31) & 1u) && i < 4; i++) {
                const int32_t x_mm = tag->x_mm + (i == 1 || i == 2 ? target->tag_mm : 0);
                const int32_t y_mm = tag->y_mm + (i >= 2 ? target->tag_mm : 0);
                const int32_t value = component_q13(camera, base, pair->left[i], k);
                if (value == INT32_MAX)
                    return 0;
                stad_affine_add(&sums, x_mm * 8, y_mm * 8, value);
            }
        }
        if (!stad_affine_solve(&sums, &fit[k]))
            return 0;
    }
    return 1;
}

/* up = - (along_x x along_y) / scale, towards the camera; scale = the root of the product's length, that of a millimetre.
 * |along| < 2^23 in Q24, so the product is below 2^47 in Q48; kept in Q32. */
static int set_up_vector(sheet_pose *pose)
{
    int64_t cross_q32[3];
    uint64_t squares = 0;
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        cross_q32[k] = ((int64_t)pose->along_x[i] * pose->along_y[j] - (int64_t)pose->along_x[j] * pose->along_y[i]) / 65536;
        squares += (uint64_t)(cross_q32[k] * cross_q32[k]);
    }
    const int64_t scale_q20 = stad_isqrt((uint64_t)stad_isqrt(squares) * 256);
    if (scale_q20 == 0)
        return 0;
    for (int k = 0; k < 3; k++)
        pose->up[k] = clamp_i64(-cross_q32[k] * 4096 / scale_q20, -MAX_UP_Q24, MAX_UP_Q24);
    return 1;
}

int stad_sheet_pose(sheet_pose *pose, const stad_target *target, const stad_camera *camera, const stad_plane *base,
                    const stad_pair *pairs, int n, uint32_t ids)
{
    stad_affine fit[3];
    if (!fit_component(target, camera, base, pairs, pairs + n, ids, fit))
        return 0;
    for (int k = 0; k < 3; k++) {
        pose->origin[k] = (int64_t)fit[k].a_q8 * 8; /* Q13 + 8 -> Q24 */
        pose->along_x[k] = fit[k].b_q20 / 64;       /* Q13 + 20 an eighth of a mm -> Q24 a mm */
        pose->along_y[k] = fit[k].c_q20 / 64;
    }
    pose->camera = *camera;
    return set_up_vector(pose);
}

int stad_sheet_is_square(const sheet_pose *pose)
{
    int64_t xx = 0, yy = 0, xy = 0; /* |along| < 2^23: each below 2^48 */
    for (int k = 0; k < 3; k++) {
        xx += (int64_t)pose->along_x[k] * pose->along_x[k];
        yy += (int64_t)pose->along_y[k] * pose->along_y[k];
        xy += (int64_t)pose->along_x[k] * pose->along_y[k];
    }
    const int64_t unlike = xx > yy ? xx - yy : yy - xx, leaning = xy < 0 ? -2 * xy : 2 * xy;
    return 32 * (unlike > leaning ? unlike : leaning) <= xx + yy;
}

int stad_sheet_see(const sheet_pose *pose, int32_t x_mm, int32_t y_mm, int32_t h_mm, sheet_sight *sight)
{
    int64_t p[3]; /* Q24, below 2^34 + 3 * 2^23 * 2^12 < 2^37 */
    for (int k = 0; k < 3; k++)
        p[k] =
            pose->origin[k] + (int64_t)x_mm * pose->along_x[k] + (int64_t)y_mm * pose->along_y[k] + (int64_t)h_mm * pose->up[k];
    if (p[2] < 1 << 16)
        return 0;
    const int64_t x = pose->camera.cx_q8 + p[0] * pose->camera.f_q8 / p[2];
    const int64_t y = pose->camera.cy_q8 + p[1] * pose->camera.f_q8 / p[2];
    const int64_t d_q16 = (int64_t)pose->camera.f_q8 * ((int64_t)1 << 32) / p[2];
    if (x > FAR_Q8 || x < -FAR_Q8 || y > FAR_Q8 || y < -FAR_Q8 || d_q16 >= 1 << 27)
        return 0;
    sight->p.x_q8 = (int32_t)x;
    sight->p.y_q8 = (int32_t)y;
    sight->d_q16 = (int32_t)d_q16;
    return 1;
}

int stad_plane_through(const sheet_sight sight[4], stad_plane *plane)
{
    const int32_t x0 = sight[0].p.x_q8 / 256, y0 = sight[0].p.y_q8 / 256;
    stad_affine_sums sums = {0, 0, 0, 0, 0, 0, 0, 0, 0};
    stad_affine fit; /* v in Q10 over x in Q4 */
    for (int i = 0; i < 4; i++)
        stad_affine_add(&sums, (sight[i].p.x_q8 - x0 * 256) / 16, (sight[i].p.y_q8 - y0 * 256) / 16, sight[i].d_q16 / 64);
    if (!stad_affine_solve(&sums, &fit))
        return 0;
    plane->a_q16 = fit.b_q20 / 1024;
    plane->b_q16 = fit.c_q20 / 1024;
    if (plane->a_q16 <= -65536 || plane->a_q16 >= 65536 || plane->b_q16 <= -65536 || plane->b_q16 >= 65536)
        return 0;
    plane->c_q16 = fit.a_q8 / 4 - plane->a_q16 * x0 - plane->b_q16 * y0; /* |x0| < 2^12: below 2^29 */
    return 1;
}
