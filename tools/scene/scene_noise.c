/* SPDX-License-Identifier: MIT
 * scene/scene_noise.c - paint: value noise on lattices of 2, 4, 8 ... px, one over the other. */
#include "scene_random.h"

/* Two rounds of xorshift and an odd multiplier: every input bit reaches every output bit. */
uint32_t scene_hash(uint32_t v)
{
    v ^= v >> 16;
    v *= 0x45d9f3bu;
    v ^= v >> 15;
    v *= 0x2c1b3c6du;
    v ^= v >> 16;
    return v;
}

static int lattice(uint32_t seed, int32_t ix, int32_t iy)
{
    return (int)(scene_hash(seed + scene_hash((uint32_t)ix * 0x9e3779b1u + scene_hash((uint32_t)iy))) & 255);
}

/* -128..127 at (u, v), bilinear between lattice points 2^grain px apart. */
static int octave(uint32_t seed, int grain, int32_t u_q8, int32_t v_q8)
{
    int cell = 256 << grain;
    int32_t ix = scene_floor_div(u_q8, cell), iy = scene_floor_div(v_q8, cell);
    int fx = (int)((u_q8 - ix * cell) >> grain), fy = (int)((v_q8 - iy * cell) >> grain); /* 0..255 */
    int top = lattice(seed, ix, iy) * (256 - fx) + lattice(seed, ix + 1, iy) * fx;
    int low = lattice(seed, ix, iy + 1) * (256 - fx) + lattice(seed, ix + 1, iy + 1) * fx;
    return (top * (256 - fy) + low * fy) / 65536 - 128;
}

int scene_paint_noise(const void *what, int32_t u_q8, int32_t v_q8)
{
    const scene_noise *n = what;
    int sum = 0, weights = 0;
    if (n->stripes)
        u_q8 -= scene_floor_div(u_q8, n->stripes * 256) * n->stripes * 256;
    for (int grain = n->finest; grain <= n->coarsest; grain++) {
        int weight = 2 + grain; /* coarse grain is a little stronger, as in most things one sees */
        sum += weight * octave(n->seed + (uint32_t)grain, grain, u_q8, v_q8);
        weights += weight;
    }
    return n->grey + 2 * n->contrast * sum / (128 * weights);
}
