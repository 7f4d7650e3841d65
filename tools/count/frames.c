/* SPDX-License-Identifier: MIT
 * tools/count/frames.c - the firmware whose instructions are counted: one frame in each mode and memory plan.
 *
 * The scene is made beforehand; between the marks stands nothing but the matcher and the loop that feeds it rows.
 * 160 x 120 px, 32 disparities, grey, block 5, P1 200, P2 800, cap 63, uniqueness 10, speckle filter off. */
#include "board.h"
#include "scene.h"
#include "stad/stad.h"

enum { WIDTH = 160, HEIGHT = 120, DISPARITIES = 32, BLOCK = 5, P2 = 800, CAP = 63 };

void count_begin_sgbm_fast(void);
void count_begin_sgbm_small(void);
void count_begin_3way_fast(void);
void count_begin_3way_small(void);
void count_end(void);

/* The marks: calls that the compiler must make and that differ from each other. */
#define MARK(name)                            \
    __attribute__((noinline)) void name(void) \
    {                                         \
        __asm__ volatile("" ::: "memory");    \
    }
MARK(count_begin_sgbm_fast)
MARK(count_begin_sgbm_small)
MARK(count_begin_3way_fast)
MARK(count_begin_3way_small)
MARK(count_end)

static STAD_ALIGNED uint8_t
    work[STAD_MATCH_BYTES(WIDTH, HEIGHT, 1, DISPARITIES, BLOCK, P2, CAP, STAD_MODE_SGBM, STAD_MEMORY_FAST)];
static uint8_t left[HEIGHT][WIDTH], right[HEIGHT][WIDTH];
static int16_t disp_q4[WIDTH];
static stad_match matcher;

/* Matches the frame; 0 when all rows came out. */
static int frame(const stad_params *p)
{
    int y, rows = 0;
    if (stad_match_begin(&matcher, p) != STAD_OK)
        return 1;
    for (y = 0; y < HEIGHT; y++) {
        if (stad_match_push(&matcher, left[y], right[y]) != STAD_OK)
            return 1;
        while (stad_match_pull(&matcher, disp_q4) >= 0)
            rows++;
    }
    return rows != HEIGHT;
}

static int counted(void (*begin)(void), uint8_t mode, uint8_t memory)
{
    const stad_geometry g = {WIDTH, HEIGHT, 1, DISPARITIES, BLOCK, P2, CAP, mode, memory};
    stad_params p;
    int bad;
    stad_params_sample(&p, DISPARITIES, BLOCK, 1);
    if (stad_match_init(&matcher, &g, work, sizeof work) != STAD_OK)
        return 1;
    begin();
    bad = frame(&p);
    count_end();
    return bad;
}

int main(void)
{
    const scene s = {WIDTH, HEIGHT, DISPARITIES, 3, 20};
    int y, bad = 0;
    for (y = 0; y < HEIGHT; y++)
        scene_row(&s, y, left[y], right[y], NULL);
    bad |= counted(count_begin_sgbm_fast, STAD_MODE_SGBM, STAD_MEMORY_FAST);
    bad |= counted(count_begin_sgbm_small, STAD_MODE_SGBM, STAD_MEMORY_SMALL);
    bad |= counted(count_begin_3way_fast, STAD_MODE_3WAY, STAD_MEMORY_FAST);
    bad |= counted(count_begin_3way_small, STAD_MODE_3WAY, STAD_MEMORY_SMALL);
    return bad;
}
