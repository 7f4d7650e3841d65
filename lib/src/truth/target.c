/* SPDX-License-Identifier: MIT
 * [truth/target.c] -> truth, renderer, sheet - the calibration targets as tables, and what any table can be used for.
 *
 * Heights and steepness follow what tuning needs at the distance where the marks are 24 to 48 px a side: a step of several
 * pixels of disparity (plate), a steep slope along the rows (wedge), two opposite slopes (tent), narrow bars. The sheet fits
 * the printable part of A4 and Letter, lying. */
#include "stad/target.h"

#include <stddef.h>

#include "truth/target_use.h"

static const stad_target_tag relief_tags[] = {{0, 6, 6}, {1, 202, 6}, {2, 202, 130}, {3, 6, 130}};

static const char *const relief_parts[] = {"plate", "wedge", "tent", "bar-8", "bar-10", "bar-12"};

static const stad_target_facet relief_facets[] = {
    {0, {80, 128, 128, 80}, {16, 16, 64, 64}, {40, 40, 40, 40}},       /* plate */
    {1, {138, 166, 166, 138}, {16, 16, 64, 64}, {0, 44, 44, 0}},       /* wedge: rises to the right */
    {2, {72, 98, 98, 72}, {104, 104, 164, 164}, {0, 28, 28, 0}},       /* tent: left slope */
    {2, {98, 124, 124, 98}, {104, 104, 164, 164}, {28, 0, 0, 28}},     /* tent: right slope */
    {3, {136, 144, 144, 136}, {104, 104, 168, 168}, {20, 20, 20, 20}}, /* bars, upright */
    {4, {153, 163, 163, 153}, {104, 104, 168, 168}, {20, 20, 20, 20}},
    {5, {172, 184, 184, 172}, {104, 104, 168, 168}, {20, 20, 20, 20}},
};

static const stad_target relief = {
    "relief", 256, 184, 48, 4, 6, 7, relief_tags, relief_parts, relief_facets,
};

static const stad_target_tag card_tags[] = {{4, 6, 12}, {5, 66, 12}};

static const stad_target card = {"card", 120, 72, 48, 2, 0, 0, card_tags, NULL, NULL};

const stad_target *stad_target_relief(void)
{
    return &relief;
}

const stad_target *stad_target_card(void)
{
    return &card;
}

static int camera_fits(const stad_camera *c)
{
    const int32_t most = 1 << 20;
    return c->f_q8 >= 16 * 256 && c->f_q8 < most && c->cx_q8 > -most && c->cx_q8 < most && c->cy_q8 > -most && c->cy_q8 < most;
}

int stad_target_fits(const stad_target *target, const stad_camera *camera)
{
    return (camera ? camera_fits(camera) : target->facet_count <= 0) && target->part_count <= 32;
}

uint32_t stad_target_ids(const stad_target *target)
{
    uint32_t ids = 0;
    for (int i = 0; i < target->tag_count; i++)
        ids |= 1u << (target->tags[i].id & 31);
    return ids;
}
