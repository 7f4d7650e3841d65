/* SPDX-License-Identifier: MIT
 * stad/degrade.c - makes good recordings bad, to rehearse what a board would do. */
#include "degrade.h"

#include <stdlib.h>

#include "../scene/target_scene.h"

int degrade_any(const degrade *d)
{
    return d->noise > 0 || d->gain != 100 || d->blur > 0 || d->vignette > 0 || d->dim > 0;
}

/* Less light towards the corners, by the square of the distance from the middle. */
static void shade(float *grey, const picture *p, double corner, double all)
{
    double cx = (p->width - 1) / 2.0, cy = (p->height - 1) / 2.0, far = cx * cx + cy * cy;
    for (int y = 0; y < p->height; y++)
        for (int x = 0; x < p->width; x++) {
            double r2 = ((x - cx) * (x - cx) + (y - cy) * (y - cy)) / (far > 0 ? far : 1);
            grey[(size_t)y * (size_t)p->width + (size_t)x] *= (float)((1 - all / 100) * (1 - corner / 100 * r2));
        }
}

static int degrade_view(const degrade *d, picture *p, double gain, uint64_t seed, tool_fail *f)
{
    int count = p->width * p->height;
    target_random random;
    float *grey = malloc((size_t)count * sizeof *grey);
    if (!grey)
        return tool_fail_set(f, TOOL_FILE, "not enough memory to degrade a frame");
    for (int i = 0; i < count; i++)
        grey[i] = (float)(p->pix[i] * gain / 100);
    if (d->blur > 0)
        target_blur(grey, p->width, p->height, d->blur);
    shade(grey, p, d->vignette, d->dim);
    target_random_seed(&random, seed);
    if (d->noise > 0)
        target_add_noise(grey, count, d->noise, &random);
    target_quantise(grey, count, p->pix);
    free(grey);
    return TOOL_OK;
}

int degrade_pair(const degrade *d, int i, picture *left, picture *right, tool_fail *f)
{
    if (i < d->from || !degrade_any(d))
        return TOOL_OK;
    int status = degrade_view(d, left, 100, 2 * (uint64_t)i, f);
    return status ? status : degrade_view(d, right, d->gain, 2 * (uint64_t)i + 1, f);
}
