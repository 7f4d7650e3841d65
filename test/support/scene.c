/* SPDX-License-Identifier: MIT
 * support/scene.c - synthetic stereo pairs from a hash of the coordinates. */
#include "scene.h"

#include <stddef.h>
#include <string.h>

#define PATCH_W 13
#define PATCH_H 7
#define GRID    4 /* px between the knots of smooth texture */

static const char *const names[SCENE_KINDS] = {"noise", "flat", "ramp", "repeat", "shift", "binary", "twin", "patches"};

const char *scene_name(int kind)
{
    return kind >= 0 && kind < SCENE_KINDS ? names[kind] : "unknown";
}

int scene_kind_of(const char *name)
{
    for (int k = 0; k < SCENE_KINDS; k++) {
        if (strcmp(name, names[k]) == 0) {
            return k;
        }
    }
    return -1;
}

uint32_t hash_u32(uint32_t v)
{
    v ^= v >> 16;
    v *= 0x45d9f3b5u;
    v ^= v >> 15;
    v *= 0x2c1b3c6du;
    v ^= v >> 16;
    return v;
}

uint32_t hash_pair(uint32_t key, uint32_t v)
{
    return hash_u32(hash_u32(key + 0x9e3779b9u) ^ (v * 0x85ebca77u + 0x165667b1u));
}

uint32_t rng_next(uint32_t *state)
{
    *state += 0x9e3779b9u;
    return hash_u32(*state);
}

int rng_range(uint32_t *state, int lo, int hi)
{
    return lo + (int)(rng_next(state) % (uint32_t)(hi - lo + 1));
}

static uint32_t at(uint32_t key, int y, int x, int c)
{
    return hash_pair(hash_pair(hash_pair(key, (uint32_t)y), (uint32_t)x), (uint32_t)c);
}

/* Rounds towards minus infinity, so that patches do not double their size at zero. */
static int floor_div(int a, int b)
{
    int q = a / b;
    return a % b < 0 ? q - 1 : q;
}

/* Bilinear between random knots: what a lens makes of noise. */
static int smooth(uint32_t key, int y, int x, int c)
{
    int ky = floor_div(y, GRID), kx = floor_div(x, GRID), fy = y - ky * GRID, fx = x - kx * GRID;
    int a = (int)(at(key, ky, kx, c) & 255), b = (int)(at(key, ky, kx + 1, c) & 255);
    int d = (int)(at(key, ky + 1, kx, c) & 255), e = (int)(at(key, ky + 1, kx + 1, c) & 255);
    int top = a * (GRID - fx) + b * fx, bottom = d * (GRID - fx) + e * fx;
    return (top * (GRID - fy) + bottom * fy) / (GRID * GRID);
}

static int disparity_in(const scene *s, uint32_t h)
{
    return s->disp_min + (s->disp_count > 1 ? (int)(h % (uint32_t)s->disp_count) : 0);
}

static int clip(int v)
{
    return v < 0 ? 0 : v > 255 ? 255 : v;
}

static int sample(const scene *s, int kind, int view, int y, int x, int c)
{
    uint32_t seed = s->seed, own = hash_pair(seed, (uint32_t)(view + 77));
    uint32_t patch = at(seed + 5, floor_div(y, PATCH_H), floor_div(x, PATCH_W), 0);
    int twin = disparity_in(s, hash_u32(seed + 9));
    int xs = view ? x + twin : x; /* the left column that this one shows */
    switch (kind) {
    case SCENE_NOISE:
        return (int)(at(own, y, x, c) & 255);
    case SCENE_FLAT:
        return clip((int)(seed & 255) + (at(own, y, x, c) % 64 == 0));
    case SCENE_RAMP:
        return ((int)(seed % 7 + 1) * xs + (int)(seed % 5) * y + 16 * c) & 255;
    case SCENE_REPEAT:
        return (int)(at(seed, y / 4, (xs + 4096) % (2 + (int)(seed % 6)), c) & 255);
    case SCENE_SHIFT:
        xs = view ? x + disparity_in(s, patch) : x;
        return clip(smooth(seed, y, xs, c) + (int)(at(own, y, x, c) % 7) - 3);
    case SCENE_BINARY:
        return at(view ? own : seed, y, view ? xs : x, c) & 1 ? 255 : 0;
    case SCENE_TWIN:
        return (int)(at(seed, y, xs, c) & 255);
    default:
        return sample(s, (int)(hash_u32(patch) % SCENE_PATCHES), view, y, x, c);
    }
}

void scene_render(const scene *s, int view, int width, int height, int channels, uint8_t *out)
{
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            for (int c = 0; c < channels; c++) {
                *out++ = (uint8_t)sample(s, s->kind, view, y + s->y0, x + s->x0, c);
            }
        }
    }
}
