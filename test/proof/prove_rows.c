/* SPDX-License-Identifier: MIT
 * proof/prove_rows.c - kernels that bound themselves: any samples, any width to 24, in bounds and without overflow.
 * SOURCES: kernel/prefilter_row.c kernel/range_row.c kernel/median_row.c kernel/check_row.c kernel/best_row.c */
#include "kernel/kernel.h"
#include "proof/prove.h"

enum { WIDTH = 24, D = 16 };

static uint8_t above[3 * WIDTH], here[3 * WIDTH], below[3 * WIDTH], planes[6 * WIDTH], left[3 * WIDTH], right[3 * WIDTH];
static int16_t disp[WIDTH], votes[WIDTH], other[WIDTH], out[WIDTH], total[WIDTH * D];
static stad_best best[WIDTH];

static void prove_features(void)
{
    int width = any(1, WIDTH), channels = any(0, 1) ? 3 : 1;
    any_u8(above, 3 * WIDTH);
    any_u8(here, 3 * WIDTH);
    any_u8(below, 3 * WIDTH);
    stad_prefilter_row_c(above, here, below, width, channels, any(15, 32767), planes);
    for (width = 1; width <= WIDTH; width++) {
        stad_range_row_c(planes, width, 0, left);
        stad_range_row_c(planes, width, 1, right);
    }
}

static void prove_filters(void)
{
    int width = any(1, WIDTH);
    any_i16(disp, WIDTH, -32768, 32767);
    any_i16(other, WIDTH, -32768, 32767);
    any_i16(votes, WIDTH, -32768, 2047);
    stad_median_row_c(disp, votes, other, width, out);
    stad_check_job job = {disp, votes, any(0, WIDTH), width, width, any(-2047, 2047), any(1, 32767)};
    stad_check_row_c(&job);
}

static void prove_best(void)
{
    any_i16(total, WIDTH * D, -32768, 32767);
    stad_best_row_c(total, any(1, WIDTH), D, best);
    stad_best_row_3way_c(total, any(1, WIDTH), D, best);
}

int main(void)
{
    prove_features();
    prove_filters();
    prove_best();
    return 0;
}
