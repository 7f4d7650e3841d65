/* SPDX-License-Identifier: MIT
 * proof/prove_target.c - truth from targets: the tables of the relief and of the card, a plane as any fit gives it, any two pairs in
 * images of up to 2048 px, any camera or none; any pose, any point, facet and outline.
 * SOURCES: truth/truth_target.c truth/truth_part.c truth/sheet_pose.c truth/target.c base/log.c
 * PRECISION: 1
 * KNOWN: signed overflow. assert added +
 * GUARD: truth/truth_target.c done |= 1u << part;
 * OPTIONS: -eva-min-loop-unroll 9 -eva-interprocedural-splits -eva-split-return-function set_up_vector:0,stad_sheet_pose:0 -eva-slevel-function component_q13:50,fit_component:5000,stad_sheet_pose:5000,set_up_vector:5000,stad_truth_from_target:3000
 * Each part is taken once, so no more is added than there are facets.
 * Fits, hulls and layers are taken at their widest; prove_base.c, prove_truth.c and prove_polygon.c show that they are no wider. */
#include "base/affine.h"
#include "proof/prove.h"
#include "stad/truth.h"
#include "truth/plane_fit.h"
#include "truth/polygon.h"
#include "truth/sheet_pose.h"
#include "truth/truth_part.h"

enum { PAIRS = 2, REACH = 2048 * 256, SLOPE = 65535, HEIGHT = (1 << 30) + 2 * 65535 * 2048 };

static stad_truth t;

/* -- the other files --------------------------------------------------------------------------------------------- */

int stad_plane_fit_ids(stad_plane *plane, stad_plane_report *report, const stad_pair *pairs, int n, uint32_t ids)
{
    plane->a_q16 = any(-SLOPE, SLOPE);
    plane->b_q16 = any(-SLOPE, SLOPE);
    plane->c_q16 = any(-HEIGHT, HEIGHT);
    report->rms_q8 = any(0, INT32_MAX);
    report->corners = (int16_t)any(0, 4 * PAIRS);
    report->dropped = (int16_t)any(-32768, 32767);
    return any(-8, 0);
}

void stad_affine_add(stad_affine_sums *s, int32_t x, int32_t y, int32_t v)
{
    //@ assert -(1 << 17) <= x <= (1 << 17) && -(1 << 17) <= y <= (1 << 17) && -(1 << 22) <= v <= (1 << 22);
}

int stad_affine_solve(const stad_affine_sums *s, stad_affine *fit)
{
    if (any(0, 1))
        return 0;
    fit->b_q20 = any(-(1 << 29), 1 << 29);
    fit->c_q20 = any(-(1 << 29), 1 << 29);
    fit->a_q8 = any(-(1 << 30), 1 << 30);
    return 1;
}

int64_t stad_polygon_turn(stad_corner a, stad_corner b, stad_corner c)
{
    return any64(-(1ll << 48), 1ll << 48);
}

int stad_polygon_hull(stad_corner *points, int32_t count, stad_polygon *hull)
{
    //@ assert 0 <= count <= 12;
    return any(0, 1);
}

int stad_truth_add_plane(stad_truth *u, const stad_plane *plane, const stad_polygon *where)
{
    return any(-8, 0);
}

int stad_truth_add_mask(stad_truth *u, const stad_polygon *where)
{
    return any(-8, 0);
}

int32_t stad_truth_pixels(const stad_truth *u)
{
    return any(0, 2048 * 2048);
}

/* -- the caller -------------------------------------------------------------------------------------------------- */

static void prove_target(const stad_target *target)
{
    stad_pair pairs[PAIRS];
    const stad_camera camera = {any(INT32_MIN, INT32_MAX), any(INT32_MIN, INT32_MAX), any(INT32_MIN, INT32_MAX)};
    for (int i = 0; i < PAIRS; i++) {
        pairs[i].id = (int16_t)any(-32768, 32767);
        for (int k = 0; k < 4; k++) {
            pairs[i].left[k].x_q8 = any(0, REACH);
            pairs[i].left[k].y_q8 = any(0, REACH);
        }
    }
    stad_truth_from_target(&t, target, pairs, any(0, PAIRS), any(0, 1) ? &camera : 0);
}

static void prove_pose(void)
{
    sheet_pose pose;
    sheet_sight sight[4];
    stad_plane plane;
    stad_target_facet facet;
    const int32_t along = 1 << 23, most = (1 << 20) - 1;
    for (int k = 0; k < 3; k++) {
        pose.origin[k] = any64(-(1ll << 33), 1ll << 33);
        pose.along_x[k] = any(-along, along);
        pose.along_y[k] = any(-along, along);
        pose.up[k] = any(-(1 << 24), 1 << 24);
    }
    pose.camera.f_q8 = any(16 * 256, most);
    pose.camera.cx_q8 = any(-most, most);
    pose.camera.cy_q8 = any(-most, most);
    stad_sheet_is_square(&pose);
    for (int i = 0; i < 4; i++) {
        facet.x_mm[i] = (int16_t)any(-32768, 32767);
        facet.y_mm[i] = (int16_t)any(-32768, 32767);
        facet.h_mm[i] = (int16_t)any(-32768, 32767);
        if (!stad_sheet_see(&pose, facet.x_mm[i], facet.y_mm[i], facet.h_mm[i], &sight[i]))
            return;
    }
    stad_plane_through(sight, &plane);
    stad_truth_add_facet(&t, &pose, &facet);
}

int main(void)
{
    t.width = (int16_t)any(16, 2048);
    t.height = (int16_t)any(16, 2048);
    prove_target(stad_target_card());
    prove_target(stad_target_relief());
    prove_pose();
    return 0;
}
