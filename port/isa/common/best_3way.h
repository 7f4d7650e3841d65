/* SPDX-License-Identifier: MIT
 * path -> [BEST] -> select
 * port/isa/common/best_3way.h - SPEC 8's rule for 3WAY differs from the plain one only in ties: those few are left to C. */
#ifndef STAD_BEST_3WAY_H
#define STAD_BEST_3WAY_H

#include "kernel/kernel.h"

/* best: winners by the plain rule, the first place of the least. */
static inline void best_ties_3way(const int16_t *total, int32_t count, int32_t disparities, stad_best *best)
{
    for (int32_t i = 0; i < count; i++, total += disparities) {
        const int32_t next = best[i].index + 1;
        if (best[i].runner_up == best[i].least || (next < disparities && total[next] == best[i].least))
            stad_best_row_3way_c(total, 1, disparities, &best[i]);
    }
}

#endif
