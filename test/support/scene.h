/* SPDX-License-Identifier: MIT
 * support/scene.h - synthetic stereo pairs, the same bytes on every machine.
 *
 * Every sample is a pure function of (seed, kind, view, row, column, channel) in 32-bit integers. A crop of a scene is
 * therefore the same scene with another origin, which lets a failing case shrink and still fail. */
#ifndef TEST_SCENE_H
#define TEST_SCENE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum scene_kind {
    SCENE_NOISE,   /* two views without relation */
    SCENE_FLAT,    /* one grey value, a step of one here and there */
    SCENE_RAMP,    /* slanted gradient, right view shifted */
    SCENE_REPEAT,  /* short period: many equal minima */
    SCENE_SHIFT,   /* smooth texture on patches of different disparity, a little noise */
    SCENE_BINARY,  /* 0 and 255 only: the dearest costs there are */
    SCENE_TWIN,    /* right view = left view at one exact disparity */
    SCENE_PATCHES, /* a quilt of all of the above */
    SCENE_KINDS
};

typedef struct scene {
    uint32_t seed;
    int kind;
    int x0, y0;   /* origin of the crop */
    int disp_min; /* disparities shown: disp_min .. disp_min + disp_count - 1 */
    int disp_count;
} scene;

/* Name of a kind, and the kind of a name (-1 if none). */
const char *scene_name(int kind);
int scene_kind_of(const char *name);

/* Fills width * height * channels bytes, rows tightly packed. view: 0 left, 1 right. */
void scene_render(const scene *s, int view, int width, int height, int channels, uint8_t *out);

/* A good 32-bit hash of a word, and of a word with a key. */
uint32_t hash_u32(uint32_t v);
uint32_t hash_pair(uint32_t key, uint32_t v);

/* Small generator: the next word, and a number in lo..hi (both included). */
uint32_t rng_next(uint32_t *state);
int rng_range(uint32_t *state, int lo, int hi);

#ifdef __cplusplus
}
#endif

#endif
