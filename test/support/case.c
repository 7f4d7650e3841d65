/* SPDX-License-Identifier: MIT
 * support/case.c - random cases over the defined domain. */
#include "case.h"

#include <stdio.h>
#include <string.h>

static const char *const modes[4] = {"sgbm", "hh", "3way", "hh4"};

const char *case_mode_name(int mode)
{
    return modes[mode & 3];
}

int case_mode_of(const char *name)
{
    for (int m = 0; m < 4; m++) {
        if (strcmp(name, modes[m]) == 0) {
            return m;
        }
    }
    return -1;
}

static int maxi(int a, int b)
{
    return a > b ? a : b;
}

static int radius(const test_case *c)
{
    int block = c->params.block_size;
    return (block > 0 ? block : c->mode == STAD_MODE_3WAY ? 3 : 5) / 2;
}

/* Columns that get a disparity are width - lost(). */
static int lost(const test_case *c)
{
    int minD = c->params.min_disparity, maxD = minD + c->params.num_disparities;
    return maxi(maxD, 0) + maxi(-minD, 0);
}

int case_defined(const test_case *c)
{
    const stad_params *p = &c->params;
    int step = c->mode == STAD_MODE_3WAY ? 16 : 8;
    return p->num_disparities > 0 && p->num_disparities % step == 0 && c->width - lost(c) > radius(c) && c->height > 0 &&
           (c->channels == 1 || c->channels == 3) && p->uniqueness_ratio <= 99 && (p->min_disparity - 1) * 16 >= -32768 &&
           (p->min_disparity + p->num_disparities) * 16 <= 32767 && p->p1 <= 32766 && p->speckle_range >= 0;
}

/* One in `chance` draws from lo..hi, else from lo..usual. */
static int16_t mostly(uint32_t *s, int lo, int usual, int chance, int hi)
{
    return (int16_t)rng_range(s, lo, rng_range(s, 1, chance) == 1 ? hi : usual);
}

static void draw_ordinary(stad_params *p, uint32_t *s, int channels)
{
    int area;
    p->block_size = mostly(s, 1, 9, 6, 13);
    area = p->block_size * p->block_size * channels;
    p->p1 = (int16_t)(rng_range(s, 0, 8) * area / 2);
    p->p2 = (int16_t)(rng_range(s, 0, 32) * area);
    p->pre_filter_cap = mostly(s, 1, 80, 6, 127);
    p->uniqueness_ratio = mostly(s, 0, 20, 6, 60);
}

static void draw_stress(stad_params *p, uint32_t *s)
{
    int tail = rng_range(s, 0, 3);
    p->block_size = mostly(s, 1, 37, 8, 61);
    p->p1 = tail == 0 ? (int16_t)rng_range(s, 30000, 32766) : mostly(s, 0, 400, 2, 32766);
    p->p2 = tail == 1 ? (int16_t)rng_range(s, 30000, 32767) : mostly(s, 0, 4000, 2, 32767);
    p->pre_filter_cap = mostly(s, 1, 200, 2, 1001);
    p->uniqueness_ratio = mostly(s, 0, 40, 3, 99);
}

/* P2 where the block cost just fits int16, or just not; or where it just fits a byte. */
static void draw_edge(stad_params *p, uint32_t *s, int channels)
{
    int side, top, room;
    p->block_size = (int16_t)(rng_range(s, 0, 5) * 2 + 1);
    p->pre_filter_cap = mostly(s, 1, 130, 2, 40);
    side = p->block_size;
    top = channels * (maxi(p->pre_filter_cap, 15) > 127 ? 318 : 2 * (maxi(p->pre_filter_cap, 15) | 1) + 63);
    room = 32767 - side * side * top;
    if (room < 100 || rng_range(s, 0, 2) == 0) {
        p->p2 = (int16_t)rng_range(s, 253, 257);
    } else {
        p->p2 = (int16_t)(room - rng_range(s, 0, (side + 1) * top < room ? (side + 1) * top : room - 2));
    }
    p->p1 = (int16_t)rng_range(s, 1, p->p2 - 1);
}

static void draw_odd_values(stad_params *p, uint32_t *s)
{
    switch (rng_range(s, 0, 15)) {
    case 0:
        p->disp12_max_diff = (int16_t)rng_range(s, -2, 0);
        break;
    case 1:
        p->uniqueness_ratio = (int16_t)rng_range(s, -5, -1);
        break;
    case 2: /* not below -3: 3WAY's overlap of stripes must stay positive */
        p->block_size = (int16_t)rng_range(s, -3, 0);
        break;
    case 3:
        p->p1 = (int16_t)rng_range(s, -3, 0);
        break;
    case 4:
        p->p2 = (int16_t)rng_range(s, -3, 0);
        break;
    case 5:
        p->pre_filter_cap = (int16_t)rng_range(s, -3, 14);
        break;
    default:
        break;
    }
}

void case_random(test_case *c, uint32_t seed, uint32_t index, int mode, int stress)
{
    uint32_t s = hash_pair(hash_pair(seed, index), (uint32_t)(mode * 2 + stress));
    stad_params *p = &c->params;
    int step = mode == STAD_MODE_3WAY ? 16 : 8, work;
    memset(c, 0, sizeof *c);
    c->mode = mode;
    c->channels = rng_range(&s, 0, 2) == 0 ? 3 : 1;
    if (stress) {
        draw_stress(p, &s);
        if (rng_range(&s, 0, 3) == 0) {
            draw_edge(p, &s, c->channels);
        }
    } else {
        draw_ordinary(p, &s, c->channels);
    }
    p->num_disparities = (int16_t)(step * mostly(&s, 1, 64 / step, 8, 256 / step));
    p->min_disparity = (int16_t)(rng_range(&s, 0, 2) ? rng_range(&s, -p->num_disparities - 8, 40) : 0);
    if (rng_range(&s, 0, 63) == 0) { /* the far ends */
        p->min_disparity = (int16_t)(rng_range(&s, 0, 1) ? -2047 : 2047 - p->num_disparities);
    }
    p->disp12_max_diff = mostly(&s, 1, 2, 3, 60);
    if (rng_range(&s, 0, 3) == 0) {
        p->speckle_window_size = rng_range(&s, 1, 120);
        p->speckle_range = mostly(&s, 0, 3, 4, 40);
    }
    draw_odd_values(p, &s);
    c->width = lost(c) + radius(c) + 1 + rng_range(&s, 0, mostly(&s, 0, 40, 4, 100));
    work = maxi(1, 150000 / ((c->width - lost(c)) * p->num_disparities));
    c->height = rng_range(&s, 1, mostly(&s, 1, work < 60 ? work : 60, 3, 12));
    c->view.seed = rng_next(&s);
    c->view.kind = rng_range(&s, 0, 4) ? rng_range(&s, 0, SCENE_KINDS - 1) : SCENE_BINARY;
    c->view.disp_min = p->min_disparity;
    c->view.disp_count = p->num_disparities;
    c->interleave = rng_next(&s);
}

void case_settle(test_case *c)
{
    if (c->mode == STAD_MODE_3WAY && c->params.block_size <= 0) {
        c->params.block_size = 3;
    }
}

void case_text(const test_case *c, char *text, size_t size)
{
    const stad_params *p = &c->params;
    snprintf(text, size,
             "--mode %s --memory %s --width %d --height %d --channels %d --scene %s:%lu:%d:%d:%d:%d --interleave %lu "
             "--min-disparity %d --num-disparities %d --block-size %d --p1 %d --p2 %d --disp12-max-diff %d "
             "--pre-filter-cap %d --uniqueness-ratio %d --speckle-window-size %d --speckle-range %d",
             case_mode_name(c->mode), c->memory ? "small" : "fast", c->width, c->height, c->channels, scene_name(c->view.kind),
             (unsigned long)c->view.seed, c->view.x0, c->view.y0, c->view.disp_min, c->view.disp_count,
             (unsigned long)c->interleave, p->min_disparity, p->num_disparities, p->block_size, p->p1, p->p2, p->disp12_max_diff,
             p->pre_filter_cap, p->uniqueness_ratio, (int)p->speckle_window_size, (int)p->speckle_range);
}

void case_render(const test_case *c, uint8_t *left, uint8_t *right)
{
    scene_render(&c->view, 0, c->width, c->height, c->channels, left);
    scene_render(&c->view, 1, c->width, c->height, c->channels, right);
}

uint32_t disparity_crc(const int16_t *disp, size_t count)
{
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < 2 * count; i++) {
        uint32_t v = (uint16_t)disp[i / 2];
        crc ^= i % 2 ? v >> 8 : v & 255u;
        for (int k = 0; k < 8; k++) {
            crc = crc & 1u ? (crc >> 1) ^ 0xedb88320u : crc >> 1;
        }
    }
    return ~crc;
}
