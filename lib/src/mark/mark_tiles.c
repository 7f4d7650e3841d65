/* SPDX-License-Identifier: MIT
 * image -> [mark/mark_tiles.c] -> dark map - local threshold from the extremes of 4 x 4 tiles.
 *
 * Three rows of tiles are live: above, this, below. Their extremes are joined down the columns into a scratch row, then over
 * three columns, so that a threshold looks at 12 x 12 pixels round the tile: wider than a cell of any mark whose border must
 * come out closed, narrower than shading. Inside a larger black area nothing is dark; the contour does not care. */
#include "mark/mark_work.h"

#include "base/arith.h"

static uint8_t *tile_row(const mark_work *w, int32_t tile_y)
{
    return w->tiles + (size_t)(tile_y % 3) * (size_t)w->tile_columns * 2;
}

static int32_t tile_rows(const mark_work *w)
{
    return (w->height + 3) / 4;
}

/* The extremes of each tile of a row of tiles. */
static void measure(const mark_work *w, int32_t tile_y)
{
    uint8_t *extremes = tile_row(w, tile_y);
    const int32_t y0 = tile_y * 4, y1 = min_i32(y0 + 4, w->height);
    for (int32_t tile_x = 0; tile_x < w->tile_columns; tile_x++) {
        const int32_t x0 = tile_x * 4, x1 = min_i32(x0 + 4, w->width);
        uint8_t low = 255, high = 0;
        for (int32_t y = y0; y < y1; y++) {
            const uint8_t *p = w->pix + y * w->row_stride + x0 * w->pixel_stride;
            for (int32_t x = x0; x < x1; x++, p += w->pixel_stride) {
                low = min_u8(low, *p);
                high = max_u8(high, *p);
            }
        }
        extremes[2 * tile_x] = low;
        extremes[2 * tile_x + 1] = high;
    }
}

/* Joins the extremes of rows tile_y - 1 .. tile_y + 1, column by column, into the scratch row. */
static uint8_t *join_rows(const mark_work *w, int32_t tile_y)
{
    const uint8_t *above = tile_row(w, max_i32(tile_y - 1, 0));
    const uint8_t *here = tile_row(w, tile_y);
    const uint8_t *below = tile_row(w, min_i32(tile_y + 1, tile_rows(w) - 1));
    uint8_t *joined = w->tiles + (size_t)w->tile_columns * 6;
    for (int32_t i = 0; i < 2 * w->tile_columns; i += 2) {
        joined[i] = min_u8(min_u8(above[i], here[i]), below[i]);
        joined[i + 1] = max_u8(max_u8(above[i + 1], here[i + 1]), below[i + 1]);
    }
    return joined;
}

/* The threshold of a tile: pixels below it are dark. 0, so that none is, where there is too little contrast. */
static uint8_t threshold(const mark_work *w, const uint8_t *joined, int32_t tile_x)
{
    const uint8_t *left = joined + 2 * max_i32(tile_x - 1, 0);
    const uint8_t *here = joined + 2 * tile_x;
    const uint8_t *right = joined + 2 * min_i32(tile_x + 1, w->tile_columns - 1);
    const uint8_t low = min_u8(min_u8(left[0], here[0]), right[0]);
    const uint8_t high = max_u8(max_u8(left[1], here[1]), right[1]);
    return (uint8_t)(high - low < w->config->min_contrast ? 0 : (low + high + 1) / 2);
}

/* Writes the dark bits of one tile: half a byte in each of its rows. */
static void binarize(const mark_work *w, int32_t tile_x, int32_t tile_y, uint8_t limit)
{
    const int32_t x0 = tile_x * 4, count = min_i32(4, w->width - x0);
    const int32_t y0 = tile_y * 4, y1 = min_i32(y0 + 4, w->height);
    for (int32_t y = y0; y < y1; y++) {
        const uint8_t *p = w->pix + y * w->row_stride + x0 * w->pixel_stride;
        unsigned bits = 0;
        for (int32_t i = 0; i < count; i++, p += w->pixel_stride)
            bits |= (unsigned)(*p < limit) << i;
        uint8_t *byte = w->dark + y * w->dark_stride + tile_x / 2;
        *byte = (uint8_t)(tile_x % 2 ? *byte | bits << 4 : bits);
    }
}

void stad_mark_tiles_first(mark_work *w)
{
    measure(w, 0);
}

void stad_mark_tiles_row(mark_work *w, int32_t tile_y)
{
    if (tile_y + 1 < tile_rows(w))
        measure(w, tile_y + 1);
    const uint8_t *joined = join_rows(w, tile_y);
    for (int32_t tile_x = 0; tile_x < w->tile_columns; tile_x++)
        binarize(w, tile_x, tile_y, threshold(w, joined, tile_x));
}
