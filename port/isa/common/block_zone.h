/* SPDX-License-Identifier: MIT
 * port/isa/common/block_zone.h - where, along a row, the columns that a block gains and loses stand still: near the borders,
 * which repeat. */
#ifndef STAD_BLOCK_ZONE_H
#define STAD_BLOCK_ZONE_H

#include "kernel/kernel.h"

/* Columns up to `end` alike: cells from one column gained to the next, from one lost to the next; either may be 0. */
typedef struct block_zone {
    int32_t end;
    ptrdiff_t plus, minus;
} block_zone;

/* The zone that column x begins in. */
static inline block_zone block_zone_at(const stad_block_job *job, int32_t x)
{
    const int32_t stops = job->columns - 1 - job->radius, starts = job->radius + 1;
    block_zone zone = {job->columns, x < stops ? job->disparities : 0, x < starts ? 0 : job->disparities};
    if (x < stops)
        zone.end = stops;
    if (x < starts && starts < zone.end)
        zone.end = starts;
    return zone;
}

/* The first cell of column x; columns outside repeat the border. */
static inline ptrdiff_t block_column(const stad_block_job *job, int32_t x)
{
    const int32_t last = job->columns - 1;
    return (ptrdiff_t)(x < 0 ? 0 : x < last ? x : last) * job->disparities;
}

#endif
