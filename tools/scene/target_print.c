/* SPDX-License-Identifier: MIT
 * target table -> [scene/target_print.c] -> render, sheet - what is printed at a point of a target.
 *
 * The print is 1/f noise: octaves of value noise of equal strength, from cells of 64 mm down to 1 mm, in integers so that
 * every machine prints the same. */
#include "scene/target_scene.h"

/* 0..255 of a lattice point. */
static int32_t lattice(int32_t x, int32_t y, uint32_t seed)
{
    uint32_t h = (uint32_t)x * 0x9E3779B1u ^ (uint32_t)y * 0x85EBCA77u ^ seed * 0xC2B2AE3Du;
    h ^= h >> 15;
    h *= 0x2C1B3C6Du;
    h ^= h >> 12;
    h *= 0x297A2D39u;
    h ^= h >> 15;
    return (int32_t)(h & 255u);
}

static int32_t floor_div(int32_t a, int32_t b)
{
    return a >= 0 ? a / b : -((-a + b - 1) / b);
}

/* Value noise with cells of `cell` units, bilinear, -128..127. */
static int32_t octave(int32_t x, int32_t y, int32_t cell, uint32_t seed)
{
    const int32_t x0 = floor_div(x, cell), y0 = floor_div(y, cell);
    const int32_t fx = x - x0 * cell, fy = y - y0 * cell;
    const int32_t top = lattice(x0, y0, seed) * (cell - fx) + lattice(x0 + 1, y0, seed) * fx;
    const int32_t bottom = lattice(x0, y0 + 1, seed) * (cell - fx) + lattice(x0 + 1, y0 + 1, seed) * fx;
    return (int32_t)(((int64_t)top * (cell - fy) + (int64_t)bottom * fy) / ((int64_t)cell * cell)) - 128;
}

int target_noise(int x_um, int y_um, int finest_um, unsigned seed)
{
    int32_t sum = 0;
    for (int i = 0; i < 7; i++)
        sum += octave(x_um, y_um, finest_um << i, seed * 16u + (uint32_t)i);
    return sum / 2;
}

int target_print(const stad_target *target, int x_um, int y_um)
{
    const int cell_um = target->tag_mm * 125;
    for (int i = 0; i < target->tag_count; i++) {
        const stad_target_tag *tag = &target->tags[i];
        const int dx = x_um - tag->x_mm * 1000, dy = y_um - tag->y_mm * 1000;
        if (dx < -cell_um || dy < -cell_um || dx >= 9 * cell_um || dy >= 9 * cell_um)
            continue;
        return stad_mark_cell(tag->id, floor_div(dy, cell_um), floor_div(dx, cell_um)) ? 255 : 0;
    }
    return target_print_part(0, x_um, y_um);
}

int target_print_part(int part, int x_um, int y_um)
{
    const int grey = 128 + target_noise(x_um, y_um, 1000, 1u + (unsigned)part) / 4;
    return grey < 0 ? 0 : grey > 255 ? 255 : grey;
}
