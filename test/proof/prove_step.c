/* SPDX-License-Identifier: MIT
 * proof/prove_step.c - joint steps, and going on along a way, from any walk that prove_tune.h gives.
 * SOURCES: tune/tune_lattice.c tune/tune_config.c
 * PRECISION: 1
 * OPTIONS: -eva-min-loop-unroll 6 -eva-slevel 0 -eva-split-return full -eva-use-spec hold -eva-slevel-function stad_tune_look:9 -eva-slevel-function line_search:99 -eva-slevel-function try_step:99 -eva-slevel-function stad_tune_joint_step:99 -eva-slevel-function stad_tune_follow:99
 *
 * How long the moves are when `hold` has shortened them, and how far a slope over its scale reaches, prove_reach.c shows. */
#include "proof/prove_look.h"

/*@ assigns \result, move[0 .. 5] \from move[0 .. 5], most;
    ensures 0 <= \result <= 3 * 65536;
    ensures -6 * 65536 <= move[0] <= 6 * 65536 && -6 * 65536 <= move[1] <= 6 * 65536 && -6 * 65536 <= move[2] <= 6 * 65536;
    ensures -6 * 65536 <= move[3] <= 6 * 65536 && -6 * 65536 <= move[4] <= 6 * 65536 && -6 * 65536 <= move[5] <= 6 * 65536; */
static int32_t hold(const stad_tune *tune, int32_t *move, int64_t most);

#include "tune/tune_step.c"

int32_t stad_tune_rise(int32_t from, int32_t to)
{
    (void)from, (void)to;
    return any(-WALL, WALL);
}

int32_t stad_tune_div_q16(int64_t a, int64_t b)
{
    //@ assert b >= 104;
    (void)a, (void)b;
    return any(-4 * TUNE_ONE, 4 * TUNE_ONE);
}

void stad_tune_walk_move(const stad_tune *tune, tune_walk *w, const stad_point *x, int32_t cost)
{
    w->x = *x;
    w->cost = cost;
    stad_tune_to_vars(&tune->config, x, &w->at);
}

int main(void)
{
    for (int stereo = 0; stereo < 2; stereo++) {
        any_search(stereo, STAD_TUNE_NCG);
        tune_walk w = any_walk();
        const tune_walk before = any_walk();
        stad_tune_joint_step(&t, &w);
        for (int i = 0; i < STAD_TUNE_DIMS; i++) {
            //@ assert -6 * 65536 <= w.old_move[i] <= 6 * 65536;
        }
        //@ assert -1125899906842624 <= w.old_fall <= 1125899906842624;
        w = any_walk();
        stad_tune_follow(&t, &w, &before.at);
    }
    return 0;
}
