/* SPDX-License-Identifier: MIT
 * proof/prove_mark.c - marks from a quadrilateral on: lines, edges, cells and corners in any image of 16 x 16 px, for any corners of
 * images up to 2048 px; pairs of any marks.
 * SOURCES: mark/mark_line.c mark/mark_edge.c mark/mark_decode.c mark/mark_codes.c mark/mark_pair.c base/log.c
 * KNOWN: division by zero. assert below
 * KNOWN: signed downcast. assert (int)((int)count + 1)
 * GUARD: mark/mark_decode.c != (m->i > 0) || below == 0)
 * GUARD: mark/mark_decode.c for (; v; v &= v - 1)
 * OPTIONS: -eva-min-loop-unroll 12
 * An interval has no hole: that `below` is not 0 was asked just before it divides. A word has 64 bits to count. */
#include "mark/mark_work.h"
#include "proof/prove.h"

enum { WIDTH = 16, HEIGHT = 16, REACH = 2048 * 256 };

static uint8_t pix[WIDTH * HEIGHT], cells[160];

static stad_corner any_corner(void)
{
    const stad_corner c = {any(-REACH / 8, REACH + REACH / 8), any(-REACH / 8, REACH + REACH / 8)};
    return c;
}

static mark_work any_work(const stad_mark_config *config)
{
    mark_work w = {pix, WIDTH, 1, WIDTH, HEIGHT, config};
    w.cells = cells;
    any_u8(pix, sizeof pix);
    return w;
}

static void prove_lines(void)
{
    int32_t ux, uy;
    mark_line a = {any_corner(), any(-16384, 16384), any(-16384, 16384)},
              b = {any_corner(), any(-16384, 16384), any(-16384, 16384)};
    stad_corner at;
    stad_mark_unit_q14(any64(-(1ll << 62), 1ll << 62), any64(-(1ll << 62), 1ll << 62), &ux, &uy);
    stad_mark_line_distance_q8(&a, any(-REACH, REACH), any(-REACH, REACH));
    if (stad_mark_line_meet(&a, &b, REACH, &at)) {
        //@ assert -REACH / 16 <= at.x_q8 <= REACH + REACH / 16 && -REACH / 16 <= at.y_q8 <= REACH + REACH / 16;
    }
}

/* Sums as large as mark_line.h says: of refined edges, of contours. */
static void prove_fit(void)
{
    const int64_t sum = 1 << 29, squares = 1ll << 45;
    const mark_moments m = {any_corner(),      any64(0, 1 << 13),        any64(-sum, sum), any64(-sum, sum),
                            any64(0, squares), any64(-squares, squares), any64(0, squares)};
    mark_line line;
    stad_mark_line_fit(&m, &line);
}

static void prove_edges(void)
{
    stad_mark_config config = {0xFFFFFFFFu, 2, 20};
    const mark_work w = any_work(&config);
    mark_line line;
    stad_mark_sample_q8(&w, any(INT32_MIN, INT32_MAX), any(INT32_MIN, INT32_MAX));
    stad_mark_edge_line(&w, any_corner(), any_corner(), any(1, MARK_MAX_REACH), &line);
}

static void prove_decode(void)
{
    stad_mark_config config = {(uint32_t)any64(0, UINT32_MAX), (uint8_t)any(0, 2), 20};
    const mark_work w = any_work(&config);
    mark_quad quad = {{any_corner(), any_corner(), any_corner(), any_corner()}};
    stad_mark mark;
    int first;
    stad_mark_decode(&w, &quad, &mark, &first);
    stad_mark_cell(any(INT32_MIN, INT32_MAX), any(INT32_MIN, INT32_MAX), any(INT32_MIN, INT32_MAX));
}

static void prove_pairs(void)
{
    stad_mark left[3], right[3];
    stad_pair out[2];
    for (int i = 0; i < 3; i++) {
        left[i].id = (int16_t)any(-32768, 32767);
        right[i].id = (int16_t)any(-32768, 32767);
        for (int k = 0; k < 4; k++) {
            left[i].corner[k] = any_corner();
            right[i].corner[k] = any_corner();
        }
    }
    stad_mark_pair(left, any(0, 3), right, any(0, 3), out, any(0, 2));
}

int main(void)
{
    prove_lines();
    prove_fit();
    prove_edges();
    prove_decode();
    prove_pairs();
    return 0;
}
