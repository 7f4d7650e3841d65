/* SPDX-License-Identifier: MIT
 * marks -> [PAIRS] -> collect        calib/pairs.c - what the pairs of a frame say: does the rig hold, has the target
 * moved */
#include <string.h>

#include "calib/calib_parts.h"

#define STILL_Q10 256 /* a quarter of a pixel */

int stad_calib_rig_verdict(const stad_rig *rig, const stad_pair *pairs, int count, stad_pair *room, stad_rig_report *report)
{
    stad_rig rest;
    memcpy(room, pairs, (size_t)count * sizeof *room);
    stad_rig_straighten(rig, room, count);
    return stad_rig_fit(&rest, report, room, count, rig->width, rig->height);
}

static int32_t distance_q8(stad_corner a, stad_corner b)
{
    int32_t dx = a.x_q8 - b.x_q8, dy = a.y_q8 - b.y_q8;
    dx = dx < 0 ? -dx : dx;
    dy = dy < 0 ? -dy : dy;
    return dx > dy ? dx : dy;
}

int stad_calib_is_another_pose(const stad_calib *c, const stad_pair *pairs, int count)
{
    const stad_calib_pose *was = &c->pose[0];
    int32_t sum = 0, n = 0;
    for (int i = 0; i < count; i++)
        for (int j = 0; j < was->count; j++)
            for (int k = 0; k < 4 && pairs[i].id == was->pairs[j].id; k++, n++)
                sum += distance_q8(pairs[i].left[k], was->pairs[j].left[k]);
    return sum >= 256 * c->config.pose_px * n;
}

static int mark_is_still(const stad_pair *was, const stad_pair *now)
{
    int32_t dx = 0, dy = 0; /* of four corners, Q8: their mean is a quarter */
    for (int k = 0; k < 4; k++) {
        dx += now->left[k].x_q8 - was->left[k].x_q8;
        dy += now->left[k].y_q8 - was->left[k].y_q8;
    }
    return dx > -STILL_Q10 && dx < STILL_Q10 && dy > -STILL_Q10 && dy < STILL_Q10;
}

int stad_calib_is_still(const stad_calib *c, const stad_pair *pairs, int count)
{
    int shared = 0;
    for (int i = 0; i < count; i++) {
        int j = c->pooled - 1; /* the latest of that name */
        while (j >= 0 && c->pool[j].id != pairs[i].id)
            j--;
        if (j >= 0 && !mark_is_still(&c->pool[j], &pairs[i]))
            return 0;
        shared += j >= 0;
    }
    return shared > 0;
}
