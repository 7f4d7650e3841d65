/* SPDX-License-Identifier: MIT
 * proof/prove_runs.c - components and contours of dark maps: every map of 3 x 2 px within a white border, one by one.
 * SOURCES: mark/mark_runs.c mark/mark_contour.c
 * OPTIONS: -eva-auto-loop-unroll 5000 -eva-no-results
 * Which slot a run refers to is more than intervals remember. test_mark_maps.c goes through those of 6 x 4 px. */
#include "mark/mark_work.h"
#include "proof/prove.h"

enum { COLUMNS = 3, ROWS = 2, WIDTH = COLUMNS + 2, HEIGHT = ROWS + 2 };

static uint8_t dark[HEIGHT];
static mark_run runs[2 * (WIDTH / 2 + 2)];
static mark_component components[WIDTH + 8];
static int16_t free_slots[WIDTH + 8];
static mark_point contour[3 * (WIDTH + HEIGHT)];

void stad_mark_examine(mark_work *w, const mark_component *c)
{
    int32_t area2;
    //@ assert 1 <= c->left <= c->right <= COLUMNS && 1 <= c->top <= c->bottom <= ROWS;
    stad_mark_contour(w, c, &area2);
}

static void prove_map(unsigned map)
{
    mark_work w = {0};
    w.width = WIDTH;
    w.height = HEIGHT;
    w.dark = dark;
    w.dark_stride = 1;
    w.runs[0] = runs;
    w.runs[1] = runs + WIDTH / 2 + 2;
    w.components = components;
    w.free_slots = free_slots;
    w.contour = contour;
    for (int y = 1; y <= ROWS; y++)
        dark[y] = (uint8_t)((map >> (y - 1) * COLUMNS & 7u) << 1);
    stad_mark_runs_first(&w);
    for (int y = 0; y < HEIGHT; y++)
        stad_mark_runs_row(&w, y);
    //@ assert w.free_count == WIDTH + 8;
}

int main(void)
{
    //@ loop unroll 64;
    for (unsigned map = 0; map < 64; map++)
        prove_map(map);
    return 0;
}
