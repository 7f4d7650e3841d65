/* SPDX-License-Identifier: MIT
 * proof/prove_reach.c - how far a joint step may reach, octave by octave of slopes and of moves: what prove_step.c takes as given.
 * SOURCES: tune/tune_walk.c tune/tune_lattice.c tune/tune_config.c
 * OPTIONS: -eva-min-loop-unroll 32 -eva-slevel 9 */
#include "proof/prove_tune.h"
#include "tune/tune_step.c"

int stad_tune_look(stad_tune *tune, const stad_point *x, int32_t *cost)
{
    (void)tune, (void)x, (void)cost;
    return 0;
}

int stad_tune_same(const stad_point *a, const stad_point *b)
{
    return a == b;
}

/* A slope over its scale: at most four probing distances. */
static void prove_scale(int octave, int sign)
{
    tune_walk w;
    w.slope[0] = sign * any(1 << octave, (2 << octave) - 1);
    w.curve[0] = any(0, INT32_MAX);
    w.cost = any(0, INT32_MAX);
    w.step = any(TUNE_ONE / 8, 3 * TUNE_ONE / 4);
    const int32_t move = stad_tune_div_q16(w.slope[0], scale_of(&w, 0));
    //@ assert -4 * 65536 <= move <= 4 * 65536;
}

/* The last of a direction's moves in the octave of the longest is `which`. */
static void prove_hold(int octave, int which, int sign)
{
    int32_t move[STAD_TUNE_DIMS];
    t.config.free_mask = 63;
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        t.config.axis[i].scale = STAD_TUNE_LOG2;
        const int32_t most = (i < which ? 2 : 1) * ((int32_t)1 << octave) - 1;
        move[i] = any(-most, most);
    }
    move[which] = sign * any(1 << octave, (2 << octave) - 1);
    hold(&t, move, MAX_MOVE);
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        //@ assert -6 * 65536 <= move[i] <= 6 * 65536;
    }
}

int main(void)
{
    for (int sign = -1; sign <= 1; sign += 2) {
        for (int octave = 0; octave <= 24; octave++)
            prove_scale(octave, sign);
        for (int octave = 0; octave <= 29; octave++)
            for (int which = 0; which < STAD_TUNE_DIMS; which++)
                prove_hold(octave, which, sign);
    }
    return 0;
}
