/* SPDX-License-Identifier: MIT
 * [PRESETS] -> pick -> tune        calib/presets.c - where a run may start: one set for each regime a camera gets into
 *
 * Starting values by hand from what noise, blur and low light are known to want; not derived by a study yet. */
#include "calib/calib_parts.h"

/* P1, P2, block, uniqueness, cap, disp12; for one channel */
static const struct preset {
    const char *name;
    stad_point point;
} presets[STAD_PRESETS] = {
    {"sample", {{72, 288, 3, 10, 63, 1}}},   {"clean", {{24, 160, 3, 0, 63, 2}}},     {"noise", {{400, 1100, 7, 0, 63, 4}}},
    {"lowlight", {{300, 900, 7, 0, 31, 4}}}, {"gain", {{40, 200, 3, 0, 31, 2}}},      {"blur", {{100, 400, 5, 0, 63, 2}}},
    {"all", {{130, 500, 5, 0, 47, 2}}},
};

static int16_t times(int16_t value, int channels)
{
    int32_t product = (int32_t)value * channels;
    return (int16_t)(product < INT16_MAX ? product : INT16_MAX);
}

int stad_calib_preset(int i, int channels, stad_point *point, const char **name)
{
    if (i < 0 || i >= STAD_PRESETS || (channels != 1 && channels != 3))
        return STAD_E_PARAM;
    *point = presets[i].point;
    point->v[STAD_TUNE_P1] = times(point->v[STAD_TUNE_P1], channels);
    point->v[STAD_TUNE_P2] = times(point->v[STAD_TUNE_P2], channels);
    if (name)
        *name = presets[i].name;
    return STAD_OK;
}
