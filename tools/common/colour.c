/* SPDX-License-Identifier: MIT
 * common/colour.c - disparity and error as colours to look at. */
#include "colour.h"

#include <math.h>

#include "stad/score.h"

static uint8_t byte_of(double v)
{
    return (uint8_t)(v <= 0 ? 0 : v >= 1 ? 255 : v * 255 + 0.5);
}

void colour_of(double v, uint8_t rgb[3])
{
    const double start = 2.4, turns = 0.9, saturation = 1.8, darkest = 0.15, brightest = 0.92;
    double light = darkest + (brightest - darkest) * (v < 0 ? 0 : v > 1 ? 1 : v);
    double angle = 6.283185307179586 * (start / 3 + 1 + turns * light);
    double strength = saturation * light * (1 - light) / 2;
    double c = cos(angle), s = sin(angle);
    rgb[0] = byte_of(light + strength * (-0.14861 * c + 1.78277 * s));
    rgb[1] = byte_of(light + strength * (-0.29227 * c - 0.90649 * s));
    rgb[2] = byte_of(light + strength * (1.97294 * c));
}

int colour_disparity(picture *p, const disparity *d, int num_disparities, tool_fail *f)
{
    int status = picture_alloc(p, d->width, d->height, 3, f);
    if (status)
        return status;
    size_t n = (size_t)d->width * (size_t)d->height;
    double from = d->none_q4 + 16, range = num_disparities * 16.0;
    for (size_t i = 0; i < n; i++)
        if (d->q4[i] > d->none_q4)
            colour_of((d->q4[i] - from) / range, p->pix + 3 * i);
    return TOOL_OK;
}

int colour_truth(picture *p, const truth_map *t, int min_disparity, int num_disparities, tool_fail *f)
{
    int status = picture_alloc(p, t->width, t->height, 3, f);
    if (status)
        return status;
    size_t n = (size_t)t->width * (size_t)t->height;
    for (size_t i = 0; i < n; i++)
        if (t->q16[i] != STAD_TRUTH_NONE)
            colour_of((t->q16[i] / 65536.0 - min_disparity) / num_disparities, p->pix + 3 * i);
    return TOOL_OK;
}

void colour_error(enum colour_error_kind kind, double error_in_thresholds, uint8_t rgb[3])
{
    double v = error_in_thresholds, worse = (v - 1) / 15; /* full red at 16 thresholds */
    worse = worse < 0 ? 0 : worse > 1 ? 1 : worse;
    const uint8_t colour[4][3] = {[ERROR_NO_TRUTH] = {58, 58, 58},
                                  [ERROR_MISSING] = {150, 60, 200},
                                  [ERROR_RIGHT] = {byte_of(0.05 + 0.25 * v), byte_of(0.16 + 0.35 * v), byte_of(0.36 + 0.3 * v)},
                                  [ERROR_WRONG] = {byte_of(1 - 0.25 * worse), byte_of(0.85 - 0.8 * worse), byte_of(0.15)}};
    for (int c = 0; c < 3; c++)
        rgb[c] = colour[kind][c];
}

int colour_error_map(picture *p, const disparity *d, const truth_map *t, double threshold, tool_fail *f)
{
    int status = picture_alloc(p, d->width, d->height, 3, f);
    if (status)
        return status;
    size_t n = (size_t)d->width * (size_t)d->height;
    for (size_t i = 0; i < n; i++) {
        uint8_t *rgb = p->pix + 3 * i;
        double error = fabs(d->q4[i] / 16.0 - t->q16[i] / 65536.0) / (threshold > 0 ? threshold : 1.0 / 16);
        enum colour_error_kind kind = error > 1 ? ERROR_WRONG : ERROR_RIGHT;
        if (t->label[i] == STAD_LABEL_IGNORED)
            kind = ERROR_NO_TRUTH;
        else if (d->q4[i] <= d->none_q4)
            kind = ERROR_MISSING;
        colour_error(kind, error, rgb);
        if (t->label[i] == STAD_LABEL_OCCLUDED)
            for (int c = 0; c < 3; c++)
                rgb[c] /= 2;
    }
    return TOOL_OK;
}
