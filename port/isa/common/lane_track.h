/* SPDX-License-Identifier: MIT
 * port/isa/common/lane_track.h - where the lanes of a path kernel stand, with little to do at every pixel.
 *
 * A run is cut into stretches in which no lane's ring turns: within one, every lane goes on by one slot a pixel. A lane of
 * two slots ("turns") exchanges them at every pixel instead and keeps its least costs at hand. */
#ifndef STAD_LANE_TRACK_H
#define STAD_LANE_TRACK_H

#include <stddef.h>

#include "kernel/kernel.h"

#define TRACK_INLINE static inline __attribute__((always_inline))

/* The cells read and written, and the least costs of their slots. */
typedef struct track {
    const int16_t *from, *least_from;
    int16_t *to, *least_to;
    int32_t least, least_before; /* of a lane that turns */
} track;

/* Finds the lane's place; shortens the stretch to where the ring turns. */
TRACK_INLINE void track_enter(track *t, const stad_path_job *job, const stad_lane *lane, int turns, int32_t *stretch)
{
    const int32_t to = lane->write, from = to + 1 == lane->slots ? 0 : to + 1, left = lane->slots - (from > to ? from : to);
    t->from = lane->cost + (ptrdiff_t)from * job->stride;
    t->to = lane->cost + (ptrdiff_t)to * job->stride;
    t->least_from = lane->least + from;
    t->least_to = lane->least + to;
    t->least = t->least_before = *t->least_from;
    if (!turns && left < *stretch)
        *stretch = left;
}

/* The least cost of the slot read. */
TRACK_INLINE int32_t track_least(const track *t, int turns)
{
    return turns ? t->least : *t->least_from;
}

/* Takes the least cost of the slot written and goes on to the next pixel. from and to stand `done` cells behind their slots'
 * beginnings; `stride` of them make a slot. */
TRACK_INLINE void track_next(track *t, int turns, int32_t least, ptrdiff_t done, ptrdiff_t stride)
{
    if (turns) {
        const int16_t *read = t->from - done;
        t->from = t->to - done;
        t->to = (int16_t *)read;
        t->least_before = t->least;
        t->least = least;
    } else {
        *t->least_to++ = (int16_t)least;
        t->least_from++;
        t->from += stride - done;
        t->to += stride - done;
    }
}

/* Leaves the lane `stretch` pixels further. */
TRACK_INLINE void track_leave(const track *t, stad_lane *lane, int turns, int32_t stretch)
{
    if (turns) {
        lane->write ^= stretch & 1;
        lane->least[lane->write] = (int16_t)t->least_before;
        lane->least[1 - lane->write] = (int16_t)t->least;
    } else {
        lane->write += stretch;
        if (lane->write == lane->slots)
            lane->write = 0;
    }
}

#endif
