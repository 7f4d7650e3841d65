/* SPDX-License-Identifier: MIT
 * examples/02_rows_streamed.c - rows in, rows out: no frame is ever stored.
 *
 * As on a board whose cameras deliver line by line. Disparity rows lag a few rows behind; after the last push the loop
 * drains what is left. The 3-way mode has the least memory. */
#include <stad/stad.h>
#include <stdio.h>

#include "dots.h"

enum { W = 320, H = 120, D = 32, BLOCK = 5, P2 = 32 * BLOCK * BLOCK, CAP = 63 };

static uint8_t work[STAD_MATCH_BYTES(W, H, 1, D, BLOCK, P2, CAP, STAD_MODE_3WAY, STAD_MEMORY_SMALL)] STAD_ALIGNED;
static stad_match matcher;
static int right_answers, rows_out;

/* What the application does with a row: here, it counts pixels with the disparity they should have. */
static void use_row(const int16_t *disp_q4)
{
    for (int x = W / 2 + 32; x < W - 16; x++)
        right_answers += disp_q4[x] >= 11 * 16 - 8 && disp_q4[x] <= 11 * 16 + 8;
    rows_out++;
}

int main(void)
{
    const stad_geometry geometry = {W, H, 1, D, BLOCK, P2, CAP, STAD_MODE_3WAY, STAD_MEMORY_SMALL};
    uint8_t left[W], right[W];
    int16_t disp_q4[W];
    stad_params params;
    stad_params_sample(&params, D, BLOCK, 1);
    if (stad_match_init(&matcher, &geometry, work, sizeof work) != STAD_OK || stad_match_begin(&matcher, &params) != STAD_OK)
        return 1;

    for (int y = 0; y < H; y++) {
        dots_row(y, W, 4, left, right);
        if (stad_match_push(&matcher, left, right) != STAD_OK)
            return 1;
        while (stad_match_pull(&matcher, disp_q4) >= 0)
            use_row(disp_q4);
    }

    const stad_match_counts *counts = stad_match_counts_of(&matcher);
    int of = H * (W / 2 - 48);
    printf("%zu bytes of workspace, %d rows, %d of %d pixels right, %d rejected by the left-right check\n", sizeof work, rows_out,
           right_answers, of, (int)counts->rejected_check);
    return rows_out == H && right_answers > of * 9 / 10 ? 0 : 1;
}
