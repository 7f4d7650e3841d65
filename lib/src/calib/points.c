/* SPDX-License-Identifier: MIT
 * params <-> [POINT] <-> tune        calib/points.c - parameters as the tuner's points, within what the matcher
 * affords */
#include "calib/calib_parts.h"

#include "base/bytes.h"

stad_point stad_calib_point_of(const stad_params *params)
{
    stad_point x;
    x.v[STAD_TUNE_P1] = params->p1;
    x.v[STAD_TUNE_P2] = params->p2;
    x.v[STAD_TUNE_BLOCK_SIZE] = params->block_size;
    x.v[STAD_TUNE_UNIQUENESS_RATIO] = params->uniqueness_ratio;
    x.v[STAD_TUNE_PRE_FILTER_CAP] = params->pre_filter_cap;
    x.v[STAD_TUNE_DISP12_MAX_DIFF] = params->disp12_max_diff;
    return x;
}

stad_params stad_calib_params_at(const stad_params *base, const stad_point *point)
{
    stad_params p = *base;
    p.p1 = point->v[STAD_TUNE_P1];
    p.p2 = point->v[STAD_TUNE_P2];
    p.block_size = point->v[STAD_TUNE_BLOCK_SIZE];
    p.uniqueness_ratio = point->v[STAD_TUNE_UNIQUENESS_RATIO];
    p.pre_filter_cap = (int16_t)(point->v[STAD_TUNE_PRE_FILTER_CAP] | 1); /* the matcher wants it odd */
    p.disp12_max_diff = point->v[STAD_TUNE_DISP12_MAX_DIFF];
    return p;
}

int stad_calib_point_equal(const stad_point *a, const stad_point *b)
{
    return bytes_equal(a->v, b->v, sizeof a->v);
}

int stad_calib_fits(const stad_geometry *g, const stad_params *params)
{
    if (stad_params_check(params, g->mode, g->width, NULL) != STAD_OK)
        return 0;
    return params->num_disparities <= g->max_disparities && params->block_size <= g->max_block_size && params->p2 <= g->max_p2 &&
           params->pre_filter_cap <= g->max_pre_filter_cap;
}

static int16_t least(int16_t a, int16_t b)
{
    return a < b ? a : b;
}

void stad_calib_tune_config(const stad_calib *c, int budget, stad_tune_config *out)
{
    const stad_geometry *g = &c->config.geometry;
    stad_tune_config_stereo(out, STAD_TUNE_FOR_ANY);
    stad_tune_axis *axis = out->axis;
    axis[STAD_TUNE_BLOCK_SIZE].lo = c->config.min_block_size;
    axis[STAD_TUNE_BLOCK_SIZE].hi = least(axis[STAD_TUNE_BLOCK_SIZE].hi, g->max_block_size);
    axis[STAD_TUNE_P2].hi = least(axis[STAD_TUNE_P2].hi, g->max_p2);
    axis[STAD_TUNE_P1].hi = least(axis[STAD_TUNE_P1].hi, (int16_t)(g->max_p2 - 1));
    axis[STAD_TUNE_PRE_FILTER_CAP].hi = least(axis[STAD_TUNE_PRE_FILTER_CAP].hi, g->max_pre_filter_cap);
    out->method = STAD_TUNE_DESCENT;
    out->budget = (int16_t)budget;
    out->patience = 1;
}
