/* SPDX-License-Identifier: MIT
 * target, marks -> [truth/truth_target.c] -> layers - the base plane, and the raised parts from far to near. */
#include "stad/truth.h"

#include "base/arith.h"
#include "truth/plane_fit.h"
#include "truth/sheet_pose.h"
#include "truth/target_use.h"
#include "truth/truth_part.h"

/* Disparity of the base under a part's first corner: how near it is. */
static int32_t nearness(const sheet_pose *pose, const stad_target *target, int part)
{
    sheet_sight sight;
    for (int f = 0; f < target->facet_count; f++) {
        const stad_target_facet *facet = &target->facets[f];
        if (facet->part == part && stad_sheet_see(pose, facet->x_mm[0], facet->y_mm[0], 0, &sight))
            return sight.d_q16;
    }
    return 0;
}

/* The farthest part that is not among the `done`, a set of bits. */
static int next_part(const sheet_pose *pose, const stad_target *target, uint32_t done)
{
    int best = -1;
    int32_t least = INT32_MAX;
    for (int part = 0; part < target->part_count; part++) {
        const int32_t d = nearness(pose, target, part);
        if (!(done >> part & 1u) && d < least) {
            least = d;
            best = part;
        }
    }
    return best;
}

static int add_base(stad_truth *t, const sheet_pose *pose, const stad_target *target, const stad_plane *base)
{
    stad_polygon where;
    sheet_sight sight;
    where.count = 4;
    for (int i = 0; i < 4; i++) {
        if (!stad_sheet_see(pose, i == 1 || i == 2 ? target->width_mm : 0, i >= 2 ? target->height_mm : 0, 0, &sight))
            return STAD_E_NO_MARK;
        where.p[i] = sight.p;
    }
    return stad_truth_add_plane(t, base, &where);
}

/* Masks and facets of all parts. Returns the number of facets added, or a status. */
static int add_parts(stad_truth *t, const sheet_pose *pose, const stad_target *target)
{
    int added = 0;
    uint32_t done = 0;
    for (int part = next_part(pose, target, done); part >= 0; part = next_part(pose, target, done)) {
        done |= 1u << part;
        int status = stad_truth_add_outline(t, pose, target, part);
        for (int f = 0; f < target->facet_count && status >= 0; f++)
            if (target->facets[f].part == part) {
                status = stad_truth_add_facet(t, pose, &target->facets[f]);
                added += status > 0;
            }
        if (status < 0)
            return status;
    }
    return added;
}

/* Pairs of marks that the pose rests on. */
static int count_marks(const stad_pair *pairs, int n, uint32_t ids)
{
    int count = 0;
    for (int i = 0; i < n; i++)
        count += pairs[i].id < 32 && (ids >> (pairs[i].id & 31) & 1u);
    return count;
}

int stad_truth_from_target(stad_truth *t, const stad_target *target, const stad_pair *pairs, int n, const stad_camera *camera)
{
    STAD_ASSERT(t && target && t->width > 0 && (pairs || n <= 0)); /* initialised */
    /* Points of the base alone come out the same with any camera. */
    const stad_camera any = {t->width * 256, t->width * 128, t->height * 128};
    stad_plane base;
    stad_plane_report report;
    sheet_pose pose;
    uint32_t ids = stad_target_ids(target);
    if (!stad_target_fits(target, camera))
        return STAD_E_PARAM;
    const int fit = stad_plane_fit_ids(&base, &report, pairs, n, ids);
    if (fit < 0)
        return fit;
    if (report.dropped >= 0)
        ids &= ~(1u << (report.dropped & 31));
    if (!stad_sheet_pose(&pose, target, camera ? camera : &any, &base, pairs, n, ids))
        return STAD_E_NO_MARK;
    if (camera && count_marks(pairs, n, ids) >= 3 && !stad_sheet_is_square(&pose))
        return STAD_E_RIG;
    const int status = add_base(t, &pose, target, &base);
    const int added = status < 0 ? status : add_parts(t, &pose, target);
    if (added < 0)
        return added;
    return stad_truth_pixels(t) < t->width * t->height / 192 * 5 ? STAD_E_NO_MARK : added + 1;
}
