/* SPDX-License-Identifier: MIT
 * common/grid.c - what the two formats share: memory, and numbers in either byte order. */
#include "grid.h"

#include <stdlib.h>
#include <string.h>

#include "grid_bytes.h"
#include "picture.h"

void grid_free(grid *g)
{
    free(g->v);
    memset(g, 0, sizeof *g);
}

uint64_t grid_word(const uint8_t *at, int bytes, int big_endian)
{
    uint64_t v = 0;
    for (int i = 0; i < bytes; i++)
        v = v << 8 | at[big_endian ? i : bytes - 1 - i];
    return v;
}

static float as_float32(uint64_t word)
{
    uint32_t bits = (uint32_t)word;
    float v;
    memcpy(&v, &bits, sizeof v);
    return v;
}

static float as_float64(uint64_t word)
{
    double v;
    memcpy(&v, &word, sizeof v);
    return (float)v;
}

float grid_number(const uint8_t *at, enum grid_kind kind, int big_endian)
{
    switch (kind) {
    case GRID_I16:
        return (float)(int16_t)(uint16_t)grid_word(at, 2, big_endian);
    case GRID_F32:
        return as_float32(grid_word(at, 4, big_endian));
    default:
        return as_float64(grid_word(at, 8, big_endian));
    }
}

int grid_alloc(grid *g, long width, long height, const char *path, tool_fail *f)
{
    if (width < 1 || height < 1 || width > PICTURE_SIDE_MAX || height > PICTURE_SIDE_MAX)
        return tool_fail_set(f, TOOL_FILE, "%s: %ld x %ld numbers; each side must lie in 1..%d", path, width, height,
                             PICTURE_SIDE_MAX);
    g->width = (int)width;
    g->height = (int)height;
    g->v = malloc((size_t)width * (size_t)height * sizeof *g->v);
    if (!g->v)
        return tool_fail_set(f, TOOL_FILE, "%s: not enough memory", path);
    return TOOL_OK;
}
