/* SPDX-License-Identifier: MIT
 * proof/prove_tune.c - the tuner's way between variables and points, and its log, with the config for stereo: any start, any
 * variables within 2^29, any cost told.
 * SOURCES: tune/tune_lattice.c tune/tune_log.c tune/tune_config.c base/log.c base/divide.c */
#include "proof/prove.h"
#include "tune/tune_core.h"

static stad_tune t;

int main(void)
{
    stad_tune_config c;
    stad_point x, start;
    tune_vars v;
    int32_t cost;
    stad_tune_config_stereo(&c, STAD_TUNE_FOR_BAD);
    any_i16(start.v, STAD_TUNE_DIMS, -32768, 32767);
    if (stad_tune_core_init(&t, &c, &start, STAD_TUNE_NCG) != STAD_OK)
        return 0;
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        v.v[i] = any(-(1 << 29), 1 << 29);
    stad_tune_to_point(&t, &v, &x);
    stad_tune_to_vars(&t.config, &x, &v);
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        stad_tune_room(&t, &v, i, any(0, 1) ? 1 : -1);
    for (int i = 0; i < 4; i++) {
        stad_tune_core_turn(&t, any(INT32_MIN, INT32_MAX));
        stad_tune_look(&t, &x, &cost);
    }
    stad_tune_best(&t, &x, &cost);
    stad_tune_trace(&t, any(INT32_MIN, INT32_MAX), &x, &cost);
    return 0;
}
