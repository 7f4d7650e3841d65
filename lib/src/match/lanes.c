/* SPDX-License-Identifier: MIT
 * sweep -> [LANES] -> path
 * match/lanes.c - where each column's path state lies, so that one row of state a direction is enough.
 *
 * A lane has columns + 1 slots. Row t writes column x into slot x + first(t) and reads the slot after it, so what is read
 * is never what is written, and what is overwritten is dead:
 *     from x - 1:  first(t) = -2t     the slot read, x - 2t + 1, is where row t - 1 put column x - 1
 *     from x:      first(t) = -t      x - t + 1 is where row t - 1 put column x
 *     from x + 1:  first(t) = 0       x + 1 is where row t - 1 put column x + 1
 * (all modulo columns + 1). The one slot that no column of a row writes stands for the pixel outside the image: it holds a
 * fresh path, which stad_lanes_enter() renews where the slot has been used since. */
#include <string.h>

#include "match/frame.h"
#include "base/arith.h"

void stad_lanes_shape(stad_frame *f)
{
    const int32_t lanes = (int32_t)STAD_LANES_DOWN(f->g.mode);
    f->stride = f->p.num_disparities + (int32_t)STAD_LANE_PAD(f->g.memory);
    f->down.count = f->up.count = lanes;
    f->down.mirrored = 0;
    f->up.mirrored = 1;
}

static enum lane_kind kind_of(const lane_set *set, int32_t i)
{
    if (set->count == 1)
        return LANE_VERTICAL;
    return (enum lane_kind)(set->mirrored ? LANE_DOWN_LEFT - i : LANE_DOWN_RIGHT + i);
}

static int32_t first_slot(const stad_frame *f, const lane_set *set, int32_t i)
{
    const int32_t slots = f->columns + 1;
    switch (kind_of(set, i)) {
    case LANE_DOWN_RIGHT:
        return mod_i32(-2 * set->rows, slots);
    case LANE_VERTICAL:
        return mod_i32(-set->rows, slots);
    default:
        return 0;
    }
}

static stad_lane wide_lane(const stad_frame *f, const lane_set *set, int32_t i)
{
    uint8_t *memory = set->memory + (size_t)i * f->lane_bytes;
    stad_lane lane = {NULL, NULL, f->columns + 1, first_slot(f, set, i)};
    lane.cost = (int16_t *)(void *)memory + 16;
    lane.least = (int16_t *)(void *)(memory + f->lane_bytes - STAD_BYTES_UP(2 * ((size_t)f->g.width + 1)));
    return lane;
}

static stad_lane_u8 narrow_lane(const stad_frame *f, const lane_set *set, int32_t i)
{
    stad_lane_u8 lane = {set->memory + (size_t)i * f->lane_bytes + 16, f->columns + 1, first_slot(f, set, i)};
    return lane;
}

static void clear_wide(const stad_frame *f, const stad_lane *lane)
{
    const int32_t d = f->p.num_disparities;
    lane->cost[-1] = STAD_COST_MAX;
    for (int32_t s = 0; s < lane->slots; s++) {
        int16_t *slot = lane->cost + (ptrdiff_t)s * f->stride;
        memset(slot, 0, 2 * (size_t)d);
        for (int32_t i = d; i < f->stride; i++)
            slot[i] = STAD_COST_MAX;
        lane->least[s] = 0;
    }
}

static void clear_narrow(const stad_frame *f, const stad_lane_u8 *lane)
{
    const int32_t d = f->p.num_disparities;
    lane->cost[-1] = UINT8_MAX;
    for (int32_t s = 0; s < lane->slots; s++) {
        uint8_t *slot = lane->cost + (ptrdiff_t)s * f->stride;
        memset(slot, 0, (size_t)d);
        memset(slot + d, UINT8_MAX, (size_t)(f->stride - d));
    }
}

void stad_lanes_reset(const stad_frame *f, lane_set *set)
{
    set->rows = 0;
    for (int32_t i = 0; i < set->count; i++) {
        const stad_lane wide = wide_lane(f, set, i);
        const stad_lane_u8 narrow = narrow_lane(f, set, i);
        if (f->narrow)
            clear_narrow(f, &narrow);
        else
            clear_wide(f, &wide);
    }
}

int32_t stad_lanes_at(const stad_frame *f, const lane_set *set, stad_lane *lanes)
{
    for (int32_t i = 0; i < set->count; i++)
        lanes[i] = wide_lane(f, set, i);
    return set->count;
}

int32_t stad_lanes_enter(const stad_frame *f, const lane_set *set, stad_lane *lanes)
{
    stad_lanes_at(f, set, lanes);
    for (int32_t i = 0; i < set->count; i++) {
        if (kind_of(set, i) == LANE_DOWN_RIGHT) {
            const int32_t outside = (lanes[i].write + 1) % lanes[i].slots;
            memset(lanes[i].cost + (ptrdiff_t)outside * f->stride, 0, 2 * (size_t)f->p.num_disparities);
            lanes[i].least[outside] = 0;
        }
    }
    return set->count;
}

int32_t stad_lanes_enter_u8(const stad_frame *f, const lane_set *set, stad_lane_u8 *lanes)
{
    for (int32_t i = 0; i < set->count; i++) {
        lanes[i] = narrow_lane(f, set, i);
        if (kind_of(set, i) == LANE_DOWN_RIGHT) {
            const int32_t outside = (lanes[i].write + 1) % lanes[i].slots;
            memset(lanes[i].cost + (ptrdiff_t)outside * f->stride, 0, (size_t)f->p.num_disparities);
        }
    }
    return set->count;
}

void stad_lane_restart(const stad_frame *f, stad_lane *across)
{
    const int32_t d = f->p.num_disparities;
    across->write = 0;
    across->cost[-1] = STAD_COST_MAX;
    for (int32_t s = 0; s < 2; s++) {
        int16_t *slot = across->cost + (ptrdiff_t)s * f->stride;
        memset(slot, 0, 2 * (size_t)d);
        for (int32_t i = d; i < f->stride; i++)
            slot[i] = STAD_COST_MAX;
        across->least[s] = 0;
    }
}
