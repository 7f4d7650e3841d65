/* SPDX-License-Identifier: MIT
 * port/isa/wide/cost_column_wide.c - Birchfield-Tomasi cost, as kernel/cost_row.c has it. */
#include "base/arith.h"
#include "cost_column_wide.h"
#include "wide.h"

static inline uint8_t distance(const wide_plane *p, int32_t d)
{
    const uint8_t to_right = max_u8(sub_floor_u8(p->value, p->right_high[d]), sub_floor_u8(p->right_low[d], p->value));
    const uint8_t to_left = max_u8(sub_floor_u8(p->right_value[d], p->high), sub_floor_u8(p->low, p->right_value[d]));
    return min_u8(to_right, to_left);
}

void stad_cost_column_wide(const wide_column *restrict column)
{
    const wide_column c = *column;
    const int32_t n = whole_16(c.disparities);
    for (int32_t d = 0; d < n; d++)
        c.cost[d] = (uint8_t)(distance(&c.gradient, d) + (distance(&c.intensity, d) >> 2));
}

void stad_cost_column_add_wide(const wide_column *restrict column)
{
    const wide_column c = *column;
    const int32_t n = whole_16(c.disparities);
    for (int32_t d = 0; d < n; d++)
        c.cost[d] = (uint8_t)(c.cost[d] + distance(&c.gradient, d) + (distance(&c.intensity, d) >> 2));
}
