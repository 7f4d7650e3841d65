/* SPDX-License-Identifier: MIT
 * proof/prove_costs.c - pixel costs, saturating block costs and paths of any cost, sub-pixel places: in bounds, no overflow.
 * SOURCES: kernel/box_sat_row.c kernel/path_row_sat.c kernel/cost_row.c kernel/refine_row.c */
#include "kernel/kernel.h"
#include "proof/prove.h"

enum { WIDTH = 24, D = 8, COLUMNS = 6, STRIDE = D + 1, P2 = 20000 };

static uint8_t left[6 * WIDTH], right[6 * WIDTH];
static uint16_t in[COLUMNS * D], out[COLUMNS * D];
static int16_t hs[2 * D], block[COLUMNS * D], total[COLUMNS * D], cost[1 + 2 * STRIDE], least[2];

static void prove_pixel_costs(void)
{
    any_u8(left, 6 * WIDTH);
    any_u8(right, 6 * WIDTH);
    stad_cost_job job = {left, right, WIDTH, 1, any(D, WIDTH - COLUMNS), COLUMNS, 0, D};
    stad_cost_row_u16_c(&job, in);
}

static void prove_block_costs(void)
{
    for (int i = 0; i < COLUMNS * D; i++) {
        in[i] = (uint16_t)any(0, 954);
        out[i] = (uint16_t)any(0, 954);
    }
    any_i16(block, COLUMNS * D, -32768, 32767);
    stad_box_sat_job job = {in, out,       hs,        hs + D,    COLUMNS,   D,        any(0, COLUMNS - 1), any(1, 16384),
                            1,  any(0, 1), any(0, 1), any(0, 1), any(0, 1), any(0, 1)};
    stad_box_sat_row_c(&job, block);
}

static void prove_paths(void)
{
    any_i16(cost, 1 + 2 * STRIDE, -32768, 32767);
    any_i16(least, 2, -32768, 32767 - P2); /* SPEC 5: a relation of every step, taken for one */
    any_i16(block, COLUMNS * D, -32768, 32767);
    any_i16(total, COLUMNS * D, -32768, 32767);
    stad_lane lane = {cost + 1, least, 2, 0};
    stad_path_job job = {block, total, 1, D, STRIDE, 1, any(1, P2 - 1), P2, any(0, 1)};
    stad_path_row_sat_c(&job, &lane, 1);
}

/* Sums up to 4000: that the winner's is the least of three, so that a place is within half a pixel, ranges cannot tell. */
static void prove_places(void)
{
    stad_best best[COLUMNS];
    int16_t fine[COLUMNS];
    for (int i = 0; i < COLUMNS; i++)
        best[i].index = (int16_t)any(-1, D - 1);
    any_i16(total, COLUMNS * D, 0, 4000);
    stad_refine_row_c(total, best, any(0, COLUMNS), D, fine);
}

int main(void)
{
    prove_pixel_costs();
    prove_block_costs();
    prove_paths();
    prove_places();
    return 0;
}
