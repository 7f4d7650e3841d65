/* SPDX-License-Identifier: MIT
 * proof/prove_truth_rows.c - rows and pixels of truths: frames of 24 px and up to 2048 rows, two layers in any order, each a plane of
 * any slopes that is in range at corners within 4096 px, or a mask; any row, margin and range of
 * disparities; pixels of 24 rows.
 * SOURCES: truth/truth.c truth/truth_row.c
 * PRECISION: 1
 * OPTIONS: -eva-min-loop-unroll 25
 * KNOWN: signed overflow. assert (int32_t)(x * 65536) - *(truth + x)
 * GUARD: truth/truth_row.c truth[x] = d;
 * GUARD: truth/truth_row.c if (label[x] != STAD_LABEL_VISIBLE)
 * A pixel that is visible has a truth, which is none but of a plane: draw_plane() sets both. Where a row cuts the polygons is taken at its widest; prove_polygon.c shows that it is no wider. */
#include "proof/prove.h"
#include "stad/truth.h"
#include "truth/polygon.h"

enum { WIDTH = 24, HEIGHT = 2048, LOW = -4096 * 256, HIGH = (4096 + 2048) * 256, MARGIN = 16 };

static stad_truth t;

int stad_polygon_cut(const stad_polygon *p, int32_t y, int32_t *low_q8, int32_t *high_q8)
{
    *low_q8 = any(LOW, HIGH);
    *high_q8 = any(LOW, HIGH);
    return any(0, 1);
}

int stad_polygon_inner(const stad_polygon *p, int32_t y, int32_t margin, int32_t *first, int32_t *last)
{
    *first = any(LOW / 256 - MARGIN, HIGH / 256 + MARGIN);
    *last = any(LOW / 256 - MARGIN, HIGH / 256 + MARGIN);
    return any(0, 1);
}

int stad_polygon_outer(const stad_polygon *p, int32_t y, int32_t margin, int32_t *first, int32_t *last)
{
    return stad_polygon_inner(p, y, margin, first, last);
}

int64_t stad_polygon_turn(stad_corner a, stad_corner b, stad_corner c)
{
    return any64(-(1ll << 48), 1ll << 48);
}

static void any_layer(stad_truth_layer *layer)
{
    layer->is_mask = any(0, 1);
    layer->plane.a_q16 = any(-65535, 65535);
    layer->plane.b_q16 = any(-65535, 65535);
    /* |d| < 2048 px at corners at most 6144 px off in x and y, slopes below 1. */
    layer->plane.c_q16 = any(-(14336 << 16), 14336 << 16);
    layer->where.count = 3;
}

int main(void)
{
    static int32_t truth[WIDTH];
    static uint8_t label[WIDTH];
    if (stad_truth_init(&t, WIDTH, HEIGHT, any(-2048, 2048), any(1, 2048), any(0, MARGIN)) != STAD_OK)
        return 1;
    t.height = (int16_t)any(16, HEIGHT);
    t.count = 2;
    any_layer(&t.layer[0]);
    any_layer(&t.layer[1]);
    stad_truth_row(&t, any(INT32_MIN, INT32_MAX), any(0, 1) ? WIDTH : any(INT32_MIN, INT32_MAX), truth, label);
    t.height = WIDTH;
    stad_truth_pixels(&t);
    return 0;
}
