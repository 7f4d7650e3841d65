/* SPDX-License-Identifier: MIT
 * target, pose -> [truth/truth_part.c] -> layers - a raised part: its outline masked, its facets on top.
 *
 * The outline is the hull of the facets and their shadow on the base. It holds the part's walls, about which nothing is known.
 * What walls alone hide from the right camera is neglected: two pixels in ten thousand. */
#include "truth/truth_part.h"

#include "truth/polygon.h"

enum { MAX_OUTLINE = 12, MIN_FACET_AREA2_Q16 = 16 << 16 };

int stad_truth_add_facet(stad_truth *t, const sheet_pose *pose, const stad_target_facet *facet)
{
    sheet_sight sight[4];
    stad_polygon where;
    stad_plane plane;
    where.count = 4;
    for (int i = 0; i < 4; i++) {
        if (!stad_sheet_see(pose, facet->x_mm[i], facet->y_mm[i], facet->h_mm[i], &sight[i]))
            return STAD_E_NO_MARK;
        where.p[i] = sight[i].p;
    }
    const int64_t area2 =
        stad_polygon_turn(where.p[0], where.p[1], where.p[2]) + stad_polygon_turn(where.p[0], where.p[2], where.p[3]);
    if (area2 < MIN_FACET_AREA2_Q16 || !stad_plane_through(sight, &plane))
        return 0;
    const int status = stad_truth_add_plane(t, &plane, &where);
    return status < 0 ? status : 1;
}

int stad_truth_add_outline(stad_truth *t, const sheet_pose *pose, const stad_target *target, int part)
{
    stad_corner points[MAX_OUTLINE];
    stad_polygon hull;
    int32_t count = 0;
    for (int f = 0; f < target->facet_count; f++) {
        const stad_target_facet *facet = &target->facets[f];
        for (int i = 0; i < 4 && facet->part == part; i++) {
            sheet_sight top, foot;
            if (count + 2 > MAX_OUTLINE)
                return STAD_E_LIMIT;
            if (!stad_sheet_see(pose, facet->x_mm[i], facet->y_mm[i], facet->h_mm[i], &top) ||
                !stad_sheet_see(pose, facet->x_mm[i], facet->y_mm[i], 0, &foot))
                return STAD_E_NO_MARK;
            points[count++] = top.p;
            if (facet->h_mm[i] != 0)
                points[count++] = foot.p;
        }
    }
    if (!stad_polygon_hull(points, count, &hull))
        return STAD_E_LIMIT;
    return stad_truth_add_mask(t, &hull);
}
