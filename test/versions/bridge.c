/* SPDX-License-Identifier: MIT
 * versions/bridge.c - random cases and the library behind four plain functions, for Python's ctypes. */
#include <string.h>

#include "support/subject.h"

void bridge_shape(uint32_t seed, uint32_t index, int mode, int *shape);
void bridge_params(uint32_t seed, uint32_t index, int mode, int *params);
void bridge_images(uint32_t seed, uint32_t index, int mode, uint8_t *left, uint8_t *right);
int bridge_match(uint32_t seed, uint32_t index, int mode, int memory, int form, const uint8_t *left, const uint8_t *right,
                 int16_t *disp, char *text, int text_size);

static test_case at(uint32_t seed, uint32_t index, int mode)
{
    test_case c;
    case_random(&c, seed, index, mode, (int)(index & 1));
    case_settle(&c);
    return c;
}

/* height, width, channels */
void bridge_shape(uint32_t seed, uint32_t index, int mode, int *shape)
{
    test_case c = at(seed, index, mode);
    shape[0] = c.height;
    shape[1] = c.width;
    shape[2] = c.channels;
}

/* In the order of cv::StereoSGBM::create, without the mode. */
void bridge_params(uint32_t seed, uint32_t index, int mode, int *params)
{
    test_case c = at(seed, index, mode);
    const stad_params *p = &c.params;
    int all[10] = {p->min_disparity,
                   p->num_disparities,
                   p->block_size,
                   p->p1,
                   p->p2,
                   p->disp12_max_diff,
                   p->pre_filter_cap,
                   p->uniqueness_ratio,
                   (int)p->speckle_window_size,
                   (int)p->speckle_range};
    memcpy(params, all, sizeof all);
}

void bridge_images(uint32_t seed, uint32_t index, int mode, uint8_t *left, uint8_t *right)
{
    test_case c = at(seed, index, mode);
    case_render(&c, left, right);
}

int bridge_match(uint32_t seed, uint32_t index, int mode, int memory, int form, const uint8_t *left, const uint8_t *right,
                 int16_t *disp, char *text, int text_size)
{
    test_case c = at(seed, index, mode);
    const char *why;
    c.memory = memory;
    case_text(&c, text, (size_t)text_size);
    return subject_run(&c, form, left, right, disp, &why);
}
