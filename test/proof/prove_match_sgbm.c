/* SPDX-License-Identifier: MIT
 * proof/prove_match_sgbm.c - the passes of mode SGBM, whose inputs prove_match.h states.
 * SOURCES: match/match.c match/match_frame.c match/plan.c match/params.c match/lanes.c match/sweep.c match/costs.c match/window.c match/window_block.c match/window_sat.c match/window_sums.c match/row.c match/winners.c match/mode_sgbm.c match/mode_3way.c match/mode_two_pass.c match/speckle.c
 * PRECISION: 0
 * OPTIONS: -eva-slevel 0 -eva-min-loop-unroll 700 -eva-split-return full -eva-slevel-function stad_match_init:20 -eva-slevel-function stad_winners_init:20 -eva-slevel-function frame:200 */
#include "proof/prove_match.h"

int main(void)
{
    frames_of(STAD_MODE_SGBM);
    return 0;
}
