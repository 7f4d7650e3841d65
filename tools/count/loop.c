/* SPDX-License-Identifier: MIT
 * tools/count/loop.c - the firmware whose calibration is counted: a frame with marks, and one evaluation on the target's crop.
 *
 * 320 x 240 px, 64 disparities, grey, room for every set that the tuner may ask for. The target is drawn head on before noise: its marks
 * are found, its raised parts are not there, so costs mean nothing; the matcher's work does not depend on it. */
#include <string.h>

#include "board.h"
#include "scene.h"
#include "stad/stad.h"

enum { WIDTH = 320, HEIGHT = 240, DISPARITIES = 64, BLOCK = 11, P2 = 8192, CAP = 127, CELL = 4, SIDE = 8 * CELL };
enum {
    BLACK = 30,
    WHITE = 220,
    MATCH_BYTES = STAD_MATCH_BYTES(WIDTH, HEIGHT, 1, DISPARITIES, BLOCK, P2, CAP, STAD_MODE_SGBM, STAD_MEMORY_SMALL)
};

void count_begin_marks(void);
void count_begin_block_3(void);
void count_begin_block_11(void);
void count_end(void);

#define MARK(name)                            \
    __attribute__((noinline)) void name(void) \
    {                                         \
        __asm__ volatile("" ::: "memory");    \
    }
MARK(count_begin_marks)
MARK(count_begin_block_3)
MARK(count_begin_block_11)
MARK(count_end)

static STAD_ALIGNED uint8_t work[MATCH_BYTES + 16384];
static uint8_t view[2][HEIGHT * WIDTH];
static stad_calib calib;
static stad_evaluator evaluator;

/* A mark with a white surround of one cell. */
static void draw_mark(uint8_t *image, int id, int x, int y)
{
    for (int row = -CELL; row < SIDE + CELL; row++)
        for (int column = -CELL; column < SIDE + CELL; column++) {
            const int inside = row >= 0 && row < SIDE && column >= 0 && column < SIDE;
            const int white = !inside || stad_mark_cell(id, row / CELL, column / CELL);
            image[(y + row) * WIDTH + x + column] = white ? WHITE : BLACK;
        }
}

/* The relief's marks, 32 px a side, the sheet's corner at x, y, at a disparity. */
static void draw_pair(int x, int y, int disparity)
{
    const scene s = {WIDTH, HEIGHT, DISPARITIES, 3, 20};
    const stad_target *target = stad_target_relief();
    for (int i = 0; i < HEIGHT; i++)
        scene_row(&s, i, view[0] + i * WIDTH, view[1] + i * WIDTH, NULL);
    for (int i = 0; i < target->tag_count; i++) {
        const int dx = (target->tags[i].x_mm * SIDE + 24) / 48, dy = (target->tags[i].y_mm * SIDE + 24) / 48;
        draw_mark(view[0], target->tags[i].id, x + dx, y + dy);
        draw_mark(view[1], target->tags[i].id, x + dx - disparity, y + dy);
    }
}

static int show(void (*begin)(void), int x, int y, int disparity)
{
    const stad_image left = stad_image_packed(view[0], WIDTH, HEIGHT, 1), right = stad_image_packed(view[1], WIDTH, HEIGHT, 1);
    int held;
    draw_pair(x, y, disparity);
    if (begin != NULL)
        begin();
    held = stad_calib_frame(&calib, &left, &right, work, sizeof work);
    count_end();
    return held != 1;
}

static int evaluate(void (*begin)(void), stad_request *r, int block)
{
    const stad_image left = stad_image_packed(view[0], WIDTH, HEIGHT, 1), right = stad_image_packed(view[1], WIDTH, HEIGHT, 1);
    int32_t cost;
    stad_params_sample(&r->params, DISPARITIES, block, 1);
    begin();
    cost = stad_calib_evaluate(&calib, r, &evaluator, &left, &right, work, sizeof work);
    count_end();
    return cost == STAD_COST_FAILED;
}

int main(void)
{
    const stad_geometry g = {WIDTH, HEIGHT, 1, DISPARITIES, BLOCK, P2, CAP, STAD_MODE_SGBM, STAD_MEMORY_SMALL};
    const stad_camera camera = {192 * 256, (WIDTH - 1) * 128, (HEIGHT - 1) * 128};
    stad_calib_config config;
    stad_setup setup;
    stad_request r;
    int bad;
    memset(&setup, 0, sizeof setup);
    setup.width = WIDTH;
    setup.height = HEIGHT;
    setup.channels = 1;
    stad_params_sample(&setup.params, DISPARITIES, 3, 1);
    stad_rig_identity(&setup.rig, WIDTH, HEIGHT);
    stad_calib_config_default(&config, &g, stad_target_relief(), &camera);
    bad = sizeof work < stad_calib_evaluate_bytes(&g) || sizeof work < stad_calib_frame_bytes(WIDTH, HEIGHT);
    bad = bad || stad_calib_init(&calib, &config, &setup) != STAD_OK || stad_calib_start(&calib) != STAD_OK;
    bad = bad || show(count_begin_marks, 120, 60, 30) || show(NULL, 132, 60, 32);
    bad = bad || stad_calib_want(&calib, &r) != STAD_WANT_MATCH;
    if (bad)
        return 1;
    draw_pair(120, 60, 30);
    return evaluate(count_begin_block_3, &r, 3) || evaluate(count_begin_block_11, &r, 11);
}
