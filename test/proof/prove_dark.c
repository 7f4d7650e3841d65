/* SPDX-License-Identifier: MIT
 * proof/prove_dark.c - the dark map: images of 16 x 16 and 21 x 18 px of any pixels, 1 or 3 channels, rows upwards or downwards, any
 * contrast.
 * SOURCES: mark/mark_tiles.c
 * OPTIONS: -eva-min-loop-unroll 8 */
#include "mark/mark_work.h"
#include "proof/prove.h"

enum { WIDTH = 21, HEIGHT = 18 };

static void prove_map(int width, int height, int channels, int upwards)
{
    static uint8_t pix[WIDTH * HEIGHT * 3], dark[(WIDTH + 7) / 8 * HEIGHT], tiles[(WIDTH + 3) / 4 * 8];
    const stad_mark_config config = {0, 0, (uint8_t)any(8, 128)};
    const int stride = width * channels;
    mark_work w = {pix + (upwards ? (height - 1) * stride : 0), upwards ? -stride : stride, channels, width, height, &config};
    any_u8(pix, sizeof pix);
    w.dark = dark;
    w.dark_stride = (width + 7) / 8;
    w.tiles = tiles;
    w.tile_columns = (width + 3) / 4;
    stad_mark_tiles_first(&w);
    for (int y = 0; y * 4 < height; y++)
        stad_mark_tiles_row(&w, y);
}

int main(void)
{
    prove_map(16, 16, 1, 0);
    prove_map(WIDTH, HEIGHT, 1, 1);
    prove_map(WIDTH, HEIGHT, 3, 0);
    return 0;
}
