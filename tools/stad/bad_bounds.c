/* SPDX-License-Identifier: MIT
 * stad/bad_bounds.c - two comparisons of 16 bits a pixel in place of a whole score. */
#include "bad_bounds.h"

#include <stdlib.h>
#include <string.h>

static int32_t floor_q4(int32_t q16)
{
    return q16 >= 0 ? q16 / 4096 : -((4095 - q16) / 4096);
}

static int16_t held(int32_t q4)
{
    return (int16_t)(q4 < INT16_MIN ? INT16_MIN : q4 > INT16_MAX ? INT16_MAX : q4);
}

/* |d - truth| <= threshold, and there is a disparity. */
static void bound(bad_bounds *b, size_t i, int32_t truth_q16, const stad_score_config *c)
{
    const int32_t none_q4 = (c->min_disparity - 1) * 16;
    const int32_t least = -floor_q4(c->threshold_q16 - truth_q16), most = floor_q4(truth_q16 + c->threshold_q16);
    b->least[i] = held(least > none_q4 ? least : none_q4 + 1);
    b->most[i] = held(least > INT16_MAX ? INT16_MAX - 1 : most); /* no disparity is as large */
    b->visible++;
}

int bad_bounds_make(bad_bounds *b, const truth_map *t, const stad_score_config *c, tool_fail *f)
{
    const size_t width = (size_t)t->width, n = width * (size_t)t->height;
    const int end = c->min_disparity + c->num_disparities;
    b->visible = 0;
    b->least = malloc(n * sizeof *b->least);
    b->most = malloc(n * sizeof *b->most);
    if (!b->least || !b->most) {
        bad_bounds_free(b);
        return tool_fail_set(f, TOOL_FILE, "not enough memory for the truth of %zu pixels", n);
    }
    for (size_t i = 0; i < n; i++) {
        const int counted = (int)(i % width) >= end && t->label[i] == STAD_LABEL_VISIBLE && t->q16[i] != STAD_TRUTH_NONE;
        b->least[i] = INT16_MIN;
        b->most[i] = INT16_MAX;
        if (counted)
            bound(b, i, t->q16[i], c);
    }
    return TOOL_OK;
}

void bad_bounds_free(bad_bounds *b)
{
    free(b->least);
    free(b->most);
    memset(b, 0, sizeof *b);
}

int32_t bad_bounds_count(const bad_bounds *b, const disparity *d)
{
    int32_t bad = 0;
    for (int y = 0; y < d->height; y++) {
        const size_t row = (size_t)y * (size_t)d->width;
        const int16_t *at = d->q4 + row, *least = b->least + row, *most = b->most + row;
        uint16_t of_row = 0; /* as wide as what is compared */
        for (int x = 0; x < d->width; x++)
            of_row = (uint16_t)(of_row + ((at[x] < least[x]) | (at[x] > most[x])));
        bad += of_row;
    }
    return bad;
}
