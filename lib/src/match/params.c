/* SPDX-License-Identifier: MIT
 * [PARAMS] -> match
 * match/params.c - parameters: the two starting sets, OpenCV's silent repairs done openly, and the defined domain. */
#include <stddef.h>

#include "stad/params.h"
#include "stad/status.h"
#include "base/arith.h"

static void fill(stad_params *p, int num_disparities, int block_size, int32_t p1, int32_t p2)
{
    p->min_disparity = 0;
    p->num_disparities = sat_i16(num_disparities);
    p->block_size = sat_i16(block_size);
    p->p1 = (int16_t)min_i32(p1, INT16_MAX - 1);
    p->p2 = (int16_t)min_i32(p2, INT16_MAX);
    p->disp12_max_diff = 1;
    p->speckle_window_size = 0;
    p->speckle_range = 0;
}

void stad_params_sample(stad_params *p, int num_disparities, int block_size, int channels)
{
    /* The block is cut to 181 first: beyond it 32 b^2 is above int16 for one channel already. */
    const int32_t block = clamp_i32(block_size, 1, 181), area = channels * block * block;
    fill(p, num_disparities, block_size, 8 * area, 32 * area);
    p->pre_filter_cap = 63;
    p->uniqueness_ratio = 10;
}

void stad_params_default(stad_params *p, int num_disparities)
{
    fill(p, num_disparities, 3, 2, 5);
    p->pre_filter_cap = 15;
    p->uniqueness_ratio = 0;
}

static int set_i16(int16_t *field, int32_t value)
{
    const int changed = *field != value;
    *field = (int16_t)value;
    return changed;
}

int stad_params_normalize(stad_params *p, int mode)
{
    const int32_t block = p->block_size > 0 ? p->block_size : mode == STAD_MODE_3WAY ? 3 : 5;
    const int32_t p1 = p->p1 > 0 ? min_i32(p->p1, INT16_MAX - 1) : 2;
    int changed = 0;
    changed += set_i16(&p->block_size, block | 1);
    changed += set_i16(&p->p1, p1);
    changed += set_i16(&p->p2, max_i32(p->p2 > 0 ? p->p2 : 5, p1 + 1));
    changed += set_i16(&p->uniqueness_ratio, p->uniqueness_ratio >= 0 ? p->uniqueness_ratio : 10);
    changed += set_i16(&p->disp12_max_diff, p->disp12_max_diff > 0 ? p->disp12_max_diff : 1);
    changed += set_i16(&p->pre_filter_cap, max_i32(p->pre_filter_cap, 15) | 1);
    if (p->speckle_window_size < 0) {
        p->speckle_window_size = 0;
        changed++;
    }
    return changed;
}

static int refuse(const char **culprit, const char *field)
{
    if (culprit)
        *culprit = field;
    return STAD_E_PARAM;
}

/* Which of the two makes the range too long or too far away: the count, unless it would do from disparity 0 on. */
static const char *range_culprit(const stad_params *p, int32_t most)
{
    return p->num_disparities > most ? "num_disparities" : "min_disparity";
}

/* int16 disparities * 16 must hold both (min_disparity - 1) * 16 and (min_disparity + num_disparities) * 16, and at least one
 * column, and half a block of them, must have all its right pixels in the image. */
static int check_range(const stad_params *p, int mode, int width, const char **culprit)
{
    const int32_t multiple = mode == STAD_MODE_3WAY ? 16 : 8;
    const int32_t end = p->min_disparity + p->num_disparities;
    if (p->num_disparities <= 0 || p->num_disparities % multiple != 0)
        return refuse(culprit, "num_disparities");
    if (p->min_disparity < -2047 || end > 2047)
        return refuse(culprit, range_culprit(p, 2047));
    const int32_t columns = width + min_i32(p->min_disparity, 0) - max_i32(end, 0);
    if (columns < 1)
        return refuse(culprit, range_culprit(p, width - 1));
    if (p->block_size < 1 || p->block_size % 2 == 0 || columns <= p->block_size / 2)
        return refuse(culprit, "block_size");
    return STAD_OK;
}

int stad_params_check(const stad_params *p, int mode, int width, const char **culprit)
{
    if (mode < STAD_MODE_SGBM || mode > STAD_MODE_HH4)
        return refuse(culprit, "mode");
    const int status = check_range(p, mode, width, culprit);
    if (status != STAD_OK)
        return status;
    if (p->p1 < 1 || p->p1 == INT16_MAX)
        return refuse(culprit, "p1");
    if (p->p2 <= p->p1)
        return refuse(culprit, "p2");
    if (p->disp12_max_diff < 1)
        return refuse(culprit, "disp12_max_diff");
    if (p->pre_filter_cap < 15 || p->pre_filter_cap % 2 == 0)
        return refuse(culprit, "pre_filter_cap");
    if (p->uniqueness_ratio < 0 || p->uniqueness_ratio > 99)
        return refuse(culprit, "uniqueness_ratio");
    if (p->speckle_window_size < 0)
        return refuse(culprit, "speckle_window_size");
    /* 16 * speckle_range must fit an int32, as it must in OpenCV */
    if (p->speckle_range < 0 || p->speckle_range > INT32_MAX / 16)
        return refuse(culprit, "speckle_range");
    if (culprit)
        *culprit = NULL;
    return STAD_OK;
}
