/* SPDX-License-Identifier: MIT
 * examples/mcu/chain_marks.c - watch -> [MARKS] -> tune -> store
 *
 * Someone holds four marks before a camera that has been knocked: the right view stands two pixels low. Marks are found
 * in both views, paired, and tell the correction; the corrected rows agree again. */
#include <string.h>

#include "chain.h"
#include "expected.h"
#include "hash.h"
#include "say.h"
#include "scene.h"
#include "stad/mark.h"
#include "stad/rig.h"
#include "stad/stad.h"

enum { WIDTH = 160, HEIGHT = 120, CELL = 4, SIDE = 8 * CELL, MARKS = 4, KNOCK = 2, DISPARITY = 9 };
enum { BLACK = 30, WHITE = 220 };

static uint8_t left[HEIGHT * WIDTH], right[HEIGHT * WIDTH];

/* A mark with its top left corner at x, y, and a white surround of one cell. */
static void draw(uint8_t *image, int id, int x, int y)
{
    int row, column;
    for (row = -CELL; row < SIDE + CELL; row++)
        for (column = -CELL; column < SIDE + CELL; column++) {
            const int inside = row >= 0 && row < SIDE && column >= 0 && column < SIDE;
            const int white = !inside || stad_mark_cell(id, row / CELL, column / CELL);
            image[(y + row) * WIDTH + x + column] = white ? WHITE : BLACK;
        }
}

static void take_frames(void)
{
    static const int8_t place[MARKS][2] = {{20, 10}, {110, 14}, {24, 76}, {112, 74}};
    const scene view = {WIDTH, HEIGHT, 32, 3, 77};
    int i;
    for (i = 0; i < HEIGHT; i++)
        scene_row(&view, i, left + i * WIDTH, right + i * WIDTH, NULL);
    for (i = 0; i < MARKS; i++) {
        draw(left, i, place[i][0], place[i][1]);
        draw(right, i, place[i][0] - DISPARITY, place[i][1] + KNOCK);
    }
}

static uint32_t hash_corners(uint32_t hash, const stad_pair *pair)
{
    int i;
    hash = hash_add(hash, (uint32_t)pair->id, 2);
    for (i = 0; i < 4; i++) {
        hash = hash_add(hash, (uint32_t)pair->left[i].x_q8, 4);
        hash = hash_add(hash, (uint32_t)pair->left[i].y_q8, 4);
        hash = hash_add(hash, (uint32_t)pair->right[i].x_q8, 4);
        hash = hash_add(hash, (uint32_t)pair->right[i].y_q8, 4);
    }
    return hash;
}

int chain_marks(stad_rig *rig)
{
    static stad_mark seen_left[MARKS], seen_right[MARKS];
    static stad_pair pairs[MARKS];
    const stad_image l = stad_image_packed(left, WIDTH, HEIGHT, 1), r = stad_image_packed(right, WIDTH, HEIGHT, 1);
    stad_rig_report report;
    uint32_t hash = HASH_START;
    int n_left, n_right, n, i, verdict;
    take_frames();
    n_left = stad_mark_find(&l, NULL, seen_left, MARKS, work, work_bytes);
    n_right = stad_mark_find(&r, NULL, seen_right, MARKS, work, work_bytes);
    n = n_left > 0 && n_right > 0 ? stad_mark_pair(seen_left, n_left, seen_right, n_right, pairs, MARKS) : 0;
    for (i = 0; i < n; i++)
        hash = hash_corners(hash, &pairs[i]);
    verdict = stad_rig_fit(rig, &report, pairs, n, WIDTH, HEIGHT);
    hash = hash_add(hash_add(hash, (uint32_t)rig->a_q16, 4), (uint32_t)rig->b_q24, 4);
    say("marks: ");
    say_dec(n);
    say(" pairs, right view low by ");
    say_dec(rig->a_q16 * 100 / 65536);
    say("/100 px\n");
    return chain_agrees("marks", hash, EXPECT_MARKS) && verdict == STAD_RIG_CORRECT;
}
