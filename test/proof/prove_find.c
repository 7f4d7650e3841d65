/* SPDX-License-Identifier: MIT
 * proof/prove_find.c - the finder's frame: any call, the workspace carved for images of 16 x 16, 17 x 33 and 2048 x 16 px,
 * any components, 0 to 2 marks.
 * SOURCES: mark/mark_find.c
 * OPTIONS: -eva-min-loop-unroll 10
 * Its steps are stood for by what they touch: prove_dark.c, prove_runs.c, prove_quad.c and prove_mark.c show that it is no more. */
#include "mark/mark_work.h"
#include "proof/prove.h"

enum { SIZE = 2048 };

static uint8_t pix[3 * 16 * 16], work[STAD_MARK_BYTES(SIZE, SIZE)] __attribute__((aligned(16)));

void stad_mark_tiles_first(mark_work *w)
{
    //@ assert w->dark_stride * 8 >= w->width && w->tile_columns * 4 >= w->width;
    w->dark[w->dark_stride * w->height - 1] = 0;
    w->tiles[w->tile_columns * 8 - 1] = 0;
    //@ assert w->dark + w->dark_stride * w->height <= w->tiles;
    //@ assert w->tiles + w->tile_columns * 8 <= (uint8_t *)w->runs[0];
}

void stad_mark_tiles_row(mark_work *w, int32_t tile_y)
{
    //@ assert 0 <= tile_y && tile_y * 4 < w->height;
}

/* Runs of a row, slots, the longest contour. */
void stad_mark_runs_first(mark_work *w)
{
    w->runs[1][w->width / 2 + 1].component = 0;
    w->components[w->width + 7].parent = 0;
    w->free_slots[w->width + 7] = 0;
    w->contour[w->contour_max - 1].x = 0;
    w->cells[159] = 0;
    //@ assert w->runs[0] + w->width / 2 + 2 <= w->runs[1] && (uint8_t *)(w->runs[1] + w->width / 2 + 2) <= (uint8_t *)w->components;
    //@ assert (uint8_t *)(w->components + w->width + 8) <= (uint8_t *)w->free_slots;
    //@ assert (uint8_t *)(w->free_slots + w->width + 8) <= (uint8_t *)w->contour;
    //@ assert (uint8_t *)(w->contour + w->contour_max) <= w->cells;
}

void stad_mark_runs_row(mark_work *w, int32_t y)
{
    const mark_component c = {any(1, SIZE * SIZE),
                              (int16_t)any(0, SIZE - 1),
                              (int16_t)any(0, SIZE - 1),
                              (int16_t)any(0, SIZE - 1),
                              (int16_t)any(0, SIZE - 1),
                              (int16_t)any(0, SIZE - 1),
                              0};
    //@ assert 0 <= y < w->height;
    stad_mark_examine(w, &c);
}

int stad_mark_contour(mark_work *w, const mark_component *c, int32_t *area2)
{
    *area2 = any(0, 2 * SIZE * SIZE);
    return any(0, 1);
}

static mark_quad any_quad(void)
{
    mark_quad quad;
    for (int i = 0; i < 4; i++) {
        quad.p[i].x_q8 = any(-SIZE * 16, SIZE * 272);
        quad.p[i].y_q8 = any(-SIZE * 16, SIZE * 272);
    }
    return quad;
}

int stad_mark_quad(const mark_work *w, int32_t area2, mark_quad *quad)
{
    *quad = any_quad();
    return any(0, 1);
}

int stad_mark_decode(const mark_work *w, const mark_quad *quad, stad_mark *mark, int *first_corner)
{
    mark->id = (int16_t)any(0, STAD_MARK_IDS - 1);
    mark->hamming = (int16_t)any(0, 2);
    *first_corner = any(0, 3);
    return any(0, 1);
}

int stad_mark_refine(const mark_work *w, mark_quad *quad)
{
    *quad = any_quad();
    return any(0, 1);
}

static void prove_size(int width, int height, int channels, int max)
{
    static stad_mark out[2];
    const stad_mark_config config = {(uint32_t)any64(0, UINT32_MAX), (uint8_t)any(0, 255), (uint8_t)any(0, 255)};
    const stad_image image = stad_image_packed(pix, width, height, channels);
    stad_mark_find(&image, any(0, 1) ? &config : 0, out, max, any(0, 1) ? work : 0, sizeof work - (size_t)any(0, 1));
}

int main(void)
{
    prove_size(16, 16, 1, 0);
    prove_size(17, 33, 3, 2);
    prove_size(SIZE, 16, 1, 1);
    prove_size(any(INT32_MIN, 15), any(INT32_MIN, INT32_MAX), 1, 2);
    prove_size(16, any(2049, INT32_MAX), any(INT32_MIN, INT32_MAX), any(INT32_MIN, 2));
    return 0;
}
