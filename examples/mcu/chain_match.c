/* SPDX-License-Identifier: MIT
 * examples/mcu/chain_match.c - camera rows -> [MATCH] -> tune -> store
 *
 * One frame in every mode and memory plan, a row in, a row out: nothing here holds a frame but the workspace of HH and HH4,
 * which need one. */
#include "chain.h"
#include "expected.h"
#include "hash.h"
#include "say.h"
#include "scene.h"
#include "stad/stad.h"

enum { MAX_WIDTH = 160 };

typedef struct job {
    const char *name;
    uint8_t mode, memory;
    int16_t width, height, disparities, block_size;
    uint32_t expected;
} job;

static const job jobs[] = {
    {"sgbm, fast", STAD_MODE_SGBM, STAD_MEMORY_FAST, 160, 120, 32, 5, EXPECT_SGBM},
    {"sgbm, small", STAD_MODE_SGBM, STAD_MEMORY_SMALL, 160, 120, 32, 5, EXPECT_SGBM},
    {"3way, fast", STAD_MODE_3WAY, STAD_MEMORY_FAST, 160, 120, 32, 5, EXPECT_3WAY},
    {"3way, small", STAD_MODE_3WAY, STAD_MEMORY_SMALL, 160, 120, 32, 5, EXPECT_3WAY},
    {"hh, small", STAD_MODE_HH, STAD_MEMORY_SMALL, 96, 64, 16, 5, EXPECT_HH},
    {"hh4, small", STAD_MODE_HH4, STAD_MEMORY_SMALL, 96, 64, 16, 5, EXPECT_HH4},
    {"sgbm in bytes, small", STAD_MODE_SGBM, STAD_MEMORY_SMALL, 96, 64, 16, 1, EXPECT_BYTES},
    {"sgbm, saturating", STAD_MODE_SGBM, STAD_MEMORY_FAST, 96, 64, 16, 15, EXPECT_SATURATING},
};

static stad_match matcher;

/* Hash of a frame's rows, in the order they come; 0 when a call fails. */
static uint32_t match_frame(const scene *s, const stad_params *p)
{
    static uint8_t left[MAX_WIDTH], right[MAX_WIDTH];
    static int16_t disp_q4[MAX_WIDTH];
    uint32_t hash = HASH_START;
    int y, row, rows = 0;
    if (stad_match_begin(&matcher, p) != STAD_OK)
        return 0;
    for (y = 0; y < s->height; y++) {
        scene_row(s, y, left, right, NULL);
        if (stad_match_push(&matcher, left, right) != STAD_OK)
            return 0;
        while ((row = stad_match_pull(&matcher, disp_q4)) >= 0) {
            hash = hash_row(hash_add(hash, (uint32_t)row, 2), disp_q4, s->width);
            rows++;
        }
    }
    return rows == s->height ? hash : 0;
}

static int run(const job *j)
{
    const scene s = {j->width, j->height, j->disparities, 3, 20};
    stad_params p;
    stad_geometry g = {0};
    uint32_t hash = 0;
    stad_params_sample(&p, j->disparities, j->block_size, 1);
    g.width = j->width;
    g.height = j->height;
    g.channels = 1;
    g.max_disparities = j->disparities;
    g.max_block_size = j->block_size;
    g.max_p2 = p.p2;
    g.max_pre_filter_cap = p.pre_filter_cap;
    g.mode = j->mode;
    g.memory = j->memory;
    if (stad_match_init(&matcher, &g, work, work_bytes) == STAD_OK)
        hash = match_frame(&s, &p);
    say("match ");
    return chain_agrees(j->name, hash, j->expected);
}

int chain_match(void)
{
    size_t i;
    int good = 1;
    for (i = 0; i < sizeof jobs / sizeof jobs[0]; i++)
        good &= run(&jobs[i]);
    return good;
}
