/* SPDX-License-Identifier: MIT
 * scene/scene_random.h - private to the scene files: numbers by chance that are the same everywhere. */
#ifndef TOOL_SCENE_RANDOM_H
#define TOOL_SCENE_RANDOM_H

#include "scene_draw.h"

uint32_t scene_hash(uint32_t v);

/* v / by rounded down; by > 0. */
static inline int32_t scene_floor_div(int32_t v, int32_t by)
{
    return v >= 0 ? v / by : -((-v + by - 1) / by);
}

#endif
