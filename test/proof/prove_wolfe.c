/* SPDX-License-Identifier: MIT
 * proof/prove_wolfe.c - the textbook methods' line search and differences, octave by octave of the direction's longest coordinate: any
 * slopes, places within 2^27; a search goes at most 32 steps, of which forty stay within 2^28.
 * SOURCES: tune/tune_wolfe_search.c tune/tune_lattice.c tune/tune_config.c
 * PRECISION: 0
 * OPTIONS: -eva-min-loop-unroll 10
 * KNOWN: \initialized(b + i)
 * GUARD: tune/tune_wolfe_search.c if (!stad_tune_wolfe_gradient(t, d, &next))
 * Slopes that were not had are not read: the search returns at once, but both ways out are taken together here. */
#include "proof/prove_tune.h"
#include "tune/tune_wolfe.h"

/* A cost, which is set even where the method must not look at it. */
int stad_tune_look(stad_tune *tune, const stad_point *x, int32_t *cost)
{
    (void)tune, (void)x;
    *cost = any(0, INT32_MAX);
    return any(0, 1);
}

static void prove_search(int stereo, int octave)
{
    wolfe_way d;
    wolfe_spot s;
    int32_t a = any(1, 16 * WOLFE_ONE);
    int moved;
    any_search(stereo, STAD_TUNE_SD);
    s.cost = any(0, INT32_MAX);
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        s.z[i] = any(-(1 << 27), 1 << 27);
        s.slope[i] = any(-WOLFE_SLOPE_MOST, WOLFE_SLOPE_MOST);
        d.way[i] = any(-(2 << octave) + 1, (2 << octave) - 1);
        d.diff[i] = any(TUNE_ONE / 64, 2 * TUNE_ONE);
    }
    d.longest = any(1 << octave, (2 << octave) - 1);
    stad_tune_wolfe_search(&t, &d, &s, &a, &moved);
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        //@ assert -136314880 <= s.z[i] <= 136314880; // 2^27 and 32 steps
        //@ assert 1024 <= d.diff[i] <= 131072;
    }
    //@ assert 1 <= a <= 16 * 4096;
}

int main(void)
{
    for (int stereo = 0; stereo < 2; stereo++)
        //@ loop unroll 25;
        for (int octave = 0; octave <= 24; octave++)
            prove_search(stereo, octave);
    stad_tune_wolfe_from(&t, &t.start, (int32_t[STAD_TUNE_DIMS]){0});
    return 0;
}
