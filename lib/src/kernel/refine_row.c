/* SPDX-License-Identifier: MIT
 * best -> [REFINE] -> select
 * kernel/refine_row.c - the sub-pixel place of every winner.
 *
 * Bound: index <= 2047 and the parabola moves it by at most half a pixel, 8 units. */
#include "kernel/kernel.h"
#include "base/arith.h"

static int32_t refined(const int16_t *total, int32_t index, int32_t disparities)
{
    if (index <= 0 || index >= disparities - 1)
        return 16 * index;
    const int32_t before = total[index - 1], after = total[index + 1];
    const int32_t curve = max_i32(before + after - 2 * total[index], 1);
    return 16 * index + ((before - after) * 16 + curve) / (2 * curve);
}

void stad_refine_row_c(const int16_t *total, const stad_best *best, int32_t count, int32_t disparities, int16_t *fine)
{
    for (int32_t i = 0; i < count; i++, total += disparities)
        fine[i] = narrow_i16(refined(total, best[i].index, disparities));
}
