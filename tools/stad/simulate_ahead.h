/* SPDX-License-Identifier: MIT
 * stad/simulate_ahead.h - frames read and matched ahead of their turn, some at a time, for `stad simulate --jobs`.
 *
 * A frame's match depends on the frame and on the setup in use alone, so that it can be done early on another thread; what the
 * monitor and the calibration make of it comes in the frames' order. Where the setup has changed meanwhile, frames are matched again. */
#ifndef STAD_SIMULATE_AHEAD_H
#define STAD_SIMULATE_AHEAD_H

#include <pthread.h>

#include "../common/engine.h"
#include "degrade.h"
#include "recording.h"
#include "stad/store.h"

/* What is the same for every frame; borrowed. */
typedef struct ahead_job {
    const recording *frames;
    const degrade *bad;
    int color, end; /* frames 0..end - 1 */
} ahead_job;

/* A frame that was done. */
typedef struct ahead_frame {
    int number; /* -1: none */
    int status; /* of reading or matching; then `fail` says why */
    tool_fail fail;
    picture left, right; /* raw, spoilt as ordered */
    stad_setup setup;    /* it was matched with */
    stad_match_counts counts;
    const ahead_job *job;
    engine engine;
} ahead_frame;

typedef struct ahead {
    ahead_job job;
    int jobs;
    ahead_frame *frame, **todo;
    pthread_t *thread;
} ahead;

/* So many frames at a time, each with a matcher of that geometry. */
int ahead_open(ahead *a, const ahead_job *job, int jobs, const stad_geometry *g, tool_fail *f);
void ahead_close(ahead *a);

/* Frame i matched with that setup, and those after it in passing. Valid until the next call. */
const ahead_frame *ahead_take(ahead *a, int i, const stad_setup *setup);

#endif
