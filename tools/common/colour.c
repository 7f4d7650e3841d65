/* SPDX-License-Identifier: MIT
 * common/colour.c - disparity and error as colours to look at. */
#include "colour.h"

#include <math.h>

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
