/* SPDX-License-Identifier: MIT
 * proof/prove_paths.c - pixel costs of one channel and three, block costs, paths and selection for any values that kernel.h allows:
 * in bounds, no overflow. Eight disparities, runs of up to 5 columns taken either way, 1 to 4 lanes; several penalties, each with
 * several least costs of the pixels before (every penalty, least cost and number of disparities: wp_path.c).
 * SOURCES: kernel/cost_row.c kernel/block_row.c kernel/slide_row.c kernel/box_row.c kernel/path_row.c kernel/path_pair.c kernel/path_row_u8.c kernel/select_row.c
 * OPTIONS: -eva-min-loop-unroll 40
 * KNOWN: (int)total_0 + (int)tmp) ≤ 32767
 * GUARD: kernel/path_step.h min_i16((int16_t)(STAD_COST_MAX - total), path)
 * A sum, and the lesser of a path and what is left to 32767: proved by wp_path.c, but nothing that ranges can tell. */
#include "kernel/kernel.h"
#include "proof/prove.h"

enum {
    WIDTH = 24,
    D = 8,
    COLUMNS = 5,
    COUNT = 3,
    SLOTS = COUNT + 1,
    STRIDE = D + 1,
    LANES = 4,
    MOST = 3 * 954 + 2 * 954 * COLUMNS
};

static uint8_t left[3 * 6 * WIDTH], right[3 * 6 * WIDTH], bytes_in[COLUMNS * D], bytes_out[COLUMNS * D];
static uint16_t words_in[COLUMNS * D], words_out[COLUMNS * D];
static int16_t hs[D], block[COLUMNS * D], sums[COLUMNS * D], total[COUNT * D];

static void prove_pixel_costs(int channels)
{
    stad_cost_job job = {left, right, WIDTH, channels, any(D + 3, WIDTH - COLUMNS - 3), COLUMNS, any(-3, 3), D};
    any_u8(left, sizeof left);
    any_u8(right, sizeof right);
    stad_cost_row_u8_c(&job, bytes_in);
    stad_cost_row_u16_c(&job, words_in);
}

/* Blocks of 3; MOST: what the sums of a row that comes in and one that goes out can differ by, as far as ranges tell. */
static void prove_block_costs(int wide)
{
    stad_block_job job = {wide ? (void *)words_in : bytes_in, wide ? (void *)words_out : bytes_out, hs, COLUMNS, D, 1, wide};
    stad_slide_job slide = {sums, COLUMNS, D, 1, any(2, 10000), any(0, 2), COUNT};
    any_u8(bytes_in, COLUMNS * D);
    any_u8(bytes_out, COLUMNS * D);
    for (int i = 0; i < COLUMNS * D; i++) {
        words_in[i] = (uint16_t)any(0, 954);
        words_out[i] = (uint16_t)any(0, 954);
    }
    any_i16(block, COLUMNS * D, MOST, 32767 - MOST);
    stad_block_row_c(&job, block);
    any_i16(sums, COLUMNS * D, 0, 3 * 954);
    stad_slide_row_c(&slide, block);
    stad_box_add_row_u8_c(sums, bytes_in, COLUMNS * D, any(-1, 1));
    stad_box_add_row_u16_c(sums, words_in, COLUMNS * D, any(-1, 1));
}

static stad_path_job path_job(int p1, int p2, int step, int sum)
{
    const int first = step > 0 ? 0 : (COUNT - 1) * D;
    stad_path_job job = {block + first, sum ? total + first : 0, COUNT, D, STRIDE, step, p1, p2, any(0, 1)};
    any_i16(block, COUNT * D, p2, 32767);
    any_i16(total, COUNT * D, 0, 32767);
    return job;
}

/* Every pixel finds the path's previous one in the slot after its own, of which `m` is the least cost. */
static void prove_paths(int p1, int p2, int m, int step, int sum)
{
    int16_t cost[LANES][1 + SLOTS * STRIDE], least[LANES][SLOTS];
    stad_lane lanes[LANES];
    stad_path_job job = path_job(p1, p2, step, sum);
    for (int k = 0; k < LANES; k++) {
        any_i16(cost[k], 1 + SLOTS * STRIDE, m, 32767);
        any_i16(least[k], SLOTS, m, m);
        lanes[k].cost = cost[k] + 1;
        lanes[k].least = least[k];
        lanes[k].slots = SLOTS;
        lanes[k].write = 0;
    }
    stad_path_row_c(&job, lanes, step > 0 ? LANES : LANES - 1);
    stad_gather_row_c(total, &lanes[0], any(0, SLOTS - 1), &job);
}

static void prove_narrow_paths(int p1, int p2, int step, int sum)
{
    uint8_t cost[LANES][1 + SLOTS * STRIDE];
    stad_lane_u8 lanes[LANES];
    stad_path_job job = path_job(p1, p2, step, sum);
    for (int k = 0; k < LANES; k++) {
        any_u8(cost[k], 1 + SLOTS * STRIDE);
        lanes[k].cost = cost[k] + 1;
        lanes[k].slots = SLOTS;
        lanes[k].write = any(0, SLOTS - 1);
    }
    stad_path_row_u8_c(&job, lanes, any(1, 3));
}

static void prove_selection(void)
{
    stad_best best[COLUMNS];
    int16_t fine[COLUMNS], disp[WIDTH], vote_disp[WIDTH], vote_cost[WIDTH];
    uint8_t confidence[WIDTH];
    stad_select_job job = {best,
                           fine,
                           any(0, WIDTH - COLUMNS),
                           any(0, COLUMNS),
                           WIDTH,
                           any(-2047, 2047 - D),
                           any(0, 99),
                           any(0, 1),
                           disp,
                           vote_disp,
                           vote_cost,
                           any(0, 1) ? confidence : 0,
                           any(0, 1 << 30),
                           any(0, 1 << 30)};
    for (int i = 0; i < COLUMNS; i++) {
        best[i].index = (int16_t)any(-1, D - 1);
        best[i].least = (int16_t)any(-32768, 32767);
        best[i].runner_up = (int16_t)any(-32768, 32767);
    }
    any_i16(fine, COLUMNS, -32768, 32767);
    any_i16(disp, WIDTH, -32768, 32767);
    any_i16(vote_disp, WIDTH, -2048, 2047);
    any_i16(vote_cost, WIDTH, -32768, 32767);
    any_u8(confidence, WIDTH);
    stad_select_row_c(&job);
}

int main(void)
{
    static const int penalty[4][3] = {{1, 2, 0}, {10, 200, 5000}, {8000, 32000, 767}, {32766, 32767, 0}}; /* p1, p2, m */
    prove_pixel_costs(1);
    prove_pixel_costs(3);
    prove_block_costs(0);
    prove_block_costs(1);
    for (int i = 0; i < 4; i++)
        for (int step = -1; step <= 1; step += 2)
            for (int sum = 0; sum < 2; sum++) {
                const int p1 = penalty[i][0], p2 = penalty[i][1];
                prove_paths(p1, p2, penalty[i][2], step, sum);
                prove_paths(p1, p2, 32767 - p2, step, sum);
                if (p2 <= 255)
                    prove_narrow_paths(p1, p2, step, sum);
            }
    prove_selection();
    return 0;
}
