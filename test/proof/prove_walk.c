/* SPDX-License-Identifier: MIT
 * proof/prove_walk.c - a walk from any state that prove_tune.h gives: axes swept, polls, leaps; the state stays one of these.
 * SOURCES: tune/tune_walk.c tune/tune_lattice.c tune/tune_config.c
 * PRECISION: 1
 * OPTIONS: -eva-min-loop-unroll 6 -eva-slevel 0 -eva-split-return full -eva-slevel-function stad_tune_look:9 -eva-slevel-function probe_at:99 -eva-slevel-function second_probe:99 -eva-slevel-function stad_tune_sweep_axis:999 -eva-slevel-function stad_tune_poll:99 -eva-slevel-function try_there:99 -eva-slevel-function stad_tune_leap:999 -eva-slevel-merge-after-loop stad_tune_leap
 * KNOWN: division by zero. assert b ≢ 0
 * GUARD: tune/tune_walk.c if (b && b->from_q16 != a->from_q16) {
 * A range has no hole: that two probes do not lie at one place is asked just before their distance divides. */
#include "proof/prove_look.h"

static void prove_axis(int stereo, int i, int side)
{
    int moved;
    any_search(stereo, STAD_TUNE_NCG);
    t.config.free_mask |= (uint8_t)(1 << i);
    tune_walk w = any_walk();
    w.side[i] = (int8_t)side;
    if (stad_tune_is_continuous(&t.config, i)) {
        stad_tune_sweep_axis(&t, &w, i);
        //@ assert -WALL <= w.slope[i] <= WALL && 0 <= w.curve[i];
    } else {
        stad_tune_poll(&t, &w, i, &moved);
    }
}

static void prove_leap(int stereo, int parts)
{
    int moved;
    any_search(stereo, STAD_TUNE_NCG);
    tune_walk w = any_walk();
    stad_tune_leap(&t, &w, parts, &moved);
    stad_tune_walk_from(&t, &w, &t.start, any(0, INT32_MAX), any(1, TUNE_ONE));
}

int main(void)
{
    for (int stereo = 0; stereo < 2; stereo++) {
        for (int i = 0; i < STAD_TUNE_DIMS; i++)
            for (int side = -1; side <= 1; side += 2)
                prove_axis(stereo, i, side);
        prove_leap(stereo, 1);
        prove_leap(stereo, 4);
    }
    return 0;
}
