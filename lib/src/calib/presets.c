/* SPDX-License-Identifier: MIT
 * [PRESETS] -> pick -> tune        calib/presets.c - where a run may start: one set for each regime a camera gets
 * into
 *
 * Derived by tools/study/presets/run.py: ncg with full truth over seven scenes at once, under one degradation each,
 * and of those nine sets the seven that together leave the least. 72 % of the sample parameters' bad pixels are left,
 * on the mean of the eight degradations, when each gets its best. The handicaps by tools/study/presets/handicap.py:
 * large penalties and blocks help the target more than what stands around it. None is below 5 %: less of a gain on the
 * target says nothing of the rest. */
#include "calib/calib_parts.h"

/* P1, P2, block, uniqueness, cap, disp12 for one channel; and by how much (cost + 1 point) is raised before it is
 * compared */
static const struct preset {
    const char *name;
    stad_point point;
    int32_t handicap_q16;
} presets[STAD_PRESETS] = {
    {"clean", {{48, 185, 3, 0, 41, 8}}, 3277},        {"gain", {{47, 357, 3, 0, 85, 8}}, 3277},
    {"blur", {{152, 625, 7, 0, 127, 8}}, 3277},       {"noise-5", {{328, 1849, 7, 0, 81, 8}}, 15729},
    {"vignette", {{318, 8192, 7, 0, 113, 8}}, 20316}, {"noise-10", {{1372, 8192, 11, 0, 91, 8}}, 19661},
    {"noise-20", {{943, 4613, 11, 0, 15, 8}}, 14418},
};

int32_t stad_calib_handicap_q16(int i)
{
    return i >= 0 && i < STAD_PRESETS ? presets[i].handicap_q16 : 0;
}

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
