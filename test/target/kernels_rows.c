/* SPDX-License-Identifier: MIT
 * test/target/kernels_rows.c - cases of the kernels before and after the paths. */
#include <string.h>

#include "kernel/kernel.h"
#include "kernels.h"

int case_prefilter(void)
{
    const int32_t channels = draw() % 4 == 0 ? 3 : 1, width = between(3, WIDTH), cap = between(0, 70) * 2 + 15;
    const uint8_t *row = bytes_a;
    fill_u8(bytes_a, 3 * WIDTH * 3, 255);
    stad_prefilter_row(row, row + width * channels, row + 2 * width * channels, width, channels, cap, mine.u8 + GUARD);
    stad_prefilter_row_c(row, row + width * channels, row + 2 * width * channels, width, channels, cap, reference.u8 + GUARD);
    return same();
}

int case_range(void)
{
    const int32_t width = between(3, WIDTH);
    const int reverse = (int)(draw() % 2);
    fill_u8(bytes_a, WIDTH, 255);
    stad_range_row(bytes_a, width, reverse, mine.u8 + GUARD);
    stad_range_row_c(bytes_a, width, reverse, reference.u8 + GUARD);
    return same();
}

static stad_cost_job cost_job(int32_t channels)
{
    stad_cost_job job = {bytes_a, bytes_b, WIDTH, channels, 0, 0, between(-20, 20), between(1, DISPARITIES / 8) * 8};
    const int32_t end = job.min_disparity + job.disparities, first = end > 1 ? end - 1 : 0;
    const int32_t last = job.min_disparity < 0 ? WIDTH - 1 + job.min_disparity : WIDTH - 1;
    job.x = between(first, last);
    job.count = between(1, last - job.x + 1 < 16 ? last - job.x + 1 : 16);
    return job;
}

/* Feature rows as range_row makes them: low <= value <= high. */
static void fill_features(uint8_t *out, int32_t channels, int32_t gradient_top, int reverse)
{
    static uint8_t plane[WIDTH];
    int32_t p;
    for (p = 0; p < 2 * channels; p++) {
        fill_u8(plane, WIDTH, p < channels ? gradient_top : 255);
        stad_range_row_c(plane, WIDTH, reverse, out + 3 * WIDTH * p);
    }
}

int case_cost_u8(void)
{
    const stad_cost_job job = cost_job(1);
    fill_features(bytes_a, 1, 192, 0);
    fill_features(bytes_b, 1, 192, 1);
    stad_cost_row_u8(&job, mine.u8 + GUARD);
    stad_cost_row_u8_c(&job, reference.u8 + GUARD);
    return same();
}

int case_cost_u16(void)
{
    const stad_cost_job job = cost_job(draw() % 2 ? 3 : 1);
    fill_features(bytes_a, job.channels, 255, 0);
    fill_features(bytes_b, job.channels, 255, 1);
    stad_cost_row_u16(&job, mine.u16 + GUARD);
    stad_cost_row_u16_c(&job, reference.u16 + GUARD);
    return same();
}

static int case_box_add(int wide)
{
    const int32_t n = between(1, CELLS / 4), weight = between(-7, 7);
    const uint16_t *costs = (const uint16_t *)words_a;
    fill_u8(bytes_a, n, 255);
    fill_i16(words_a, n, 0, 954);
    fill_i16(words_c, n, 7000, 20000);
    memcpy(mine.i16 + GUARD, words_c, 2 * (size_t)n);
    memcpy(reference.i16 + GUARD, words_c, 2 * (size_t)n);
    if (wide) {
        stad_box_add_row_u16(mine.i16 + GUARD, costs, n, weight);
        stad_box_add_row_u16_c(reference.i16 + GUARD, costs, n, weight);
    } else {
        stad_box_add_row_u8(mine.i16 + GUARD, bytes_a, n, weight);
        stad_box_add_row_u8_c(reference.i16 + GUARD, bytes_a, n, weight);
    }
    return same();
}

int case_box_add_u8(void)
{
    return case_box_add(0);
}

int case_box_add_u16(void)
{
    return case_box_add(1);
}

/* Block costs that no move of these takes below 0 or above 32767. */
int case_block(void)
{
    static int16_t hs[DISPARITIES];
    const int wide = (int)(draw() % 2);
    const stad_block_job job = {wide ? (void *)words_a : bytes_a, wide ? (void *)words_b : bytes_b, hs,  between(1, COLUMNS - 1),
                                between(1, DISPARITIES / 8) * 8,  between(0, wide ? 3 : 5),         wide};
    const int32_t n = job.columns * job.disparities;
    fill_u8(bytes_a, n, 255);
    fill_u8(bytes_b, n, 255);
    fill_i16(words_a, n, 0, 954);
    fill_i16(words_b, n, 0, 954);
    fill_i16(words_c, n, 7000, 20000);
    memcpy(mine.i16 + GUARD, words_c, 2 * (size_t)n);
    memcpy(reference.i16 + GUARD, words_c, 2 * (size_t)n);
    stad_block_row(&job, mine.i16 + GUARD);
    stad_block_row_c(&job, reference.i16 + GUARD);
    return same();
}

/* Block costs anywhere, so that they saturate often and the order of every sum shows. */
int case_box_sat(void)
{
    static int16_t hs[2][DISPARITIES];
    const int32_t columns = between(6, COLUMNS - 1), d = between(1, DISPARITIES / 8) * 8, radius = between(0, 5);
    const int wide = (int)(draw() % 2);
    stad_box_sat_job job = {wide ? (void *)words_a : bytes_a,
                            wide ? (void *)words_b : bytes_b,
                            hs[0],
                            hs[1],
                            columns,
                            d,
                            radius,
                            between(1, 40),
                            wide,
                            draw() % 4 == 0,
                            (int)(draw() % 2),
                            (int)(draw() % 2),
                            (int)(draw() % 2),
                            (int)(draw() % 2)};
    fill_u8(bytes_a, columns * d, 255);
    fill_u8(bytes_b, columns * d, 255);
    fill_i16(words_a, columns * d, 0, 954);
    fill_i16(words_b, columns * d, 0, 954);
    fill_i16(words_c, columns * d, -32768, 32767);
    memcpy(mine.i16 + GUARD, words_c, 2 * (size_t)(columns * d));
    memcpy(reference.i16 + GUARD, words_c, 2 * (size_t)(columns * d));
    stad_box_sat_row(&job, mine.i16 + GUARD);
    stad_box_sat_row_c(&job, reference.i16 + GUARD);
    return same();
}

int case_slide(void)
{
    stad_slide_job job = {words_a, between(8, COLUMNS), between(1, DISPARITIES / 8) * 8, between(0, 5), between(2, 9000), 0, 0};
    job.x = between(0, job.columns - 1);
    job.count = between(1, job.columns - job.x < 16 ? job.columns - job.x : 16);
    fill_i16(words_a, job.columns * job.disparities, 0, 23000 / (2 * job.radius + 1));
    stad_slide_row(&job, mine.i16 + GUARD);
    stad_slide_row_c(&job, reference.i16 + GUARD);
    return same();
}

/* Few different costs, so that the least comes up often; sometimes nothing but the largest. */
static void fill_totals(int32_t n)
{
    const int32_t low = between(-32768, 32767), spread = between(0, 12);
    fill_i16(words_a, n, low, low + spread > 32767 ? 32767 : low + spread);
    if (draw() % 8 == 0)
        fill_i16(words_a, n, 32767, 32767);
}

static int case_best_of(int three_way)
{
    const int32_t count = between(1, 16), n = between(1, DISPARITIES / 8) * 8;
    stad_best *best = (stad_best *)(void *)(mine.u8 + GUARD), *best_c = (stad_best *)(void *)(reference.u8 + GUARD);
    fill_totals(count * n);
    if (three_way) {
        stad_best_row_3way(words_a, count, n, best);
        stad_best_row_3way_c(words_a, count, n, best_c);
    } else {
        stad_best_row(words_a, count, n, best);
        stad_best_row_c(words_a, count, n, best_c);
    }
    return same();
}

int case_best(void)
{
    return case_best_of(0);
}

int case_best_3way(void)
{
    return case_best_of(1);
}

int case_median(void)
{
    const int32_t width = between(3, WIDTH);
    fill_i16(words_a, width, -32768, 32767);
    fill_i16(words_b, width, -20, 20);
    fill_i16(words_c, width, -32768, 32767);
    stad_median_row(words_a, words_b, words_c, width, mine.i16 + GUARD);
    stad_median_row_c(words_a, words_b, words_c, width, reference.i16 + GUARD);
    return same();
}

/* Winners as the C kernel finds them, of either mode. */
int case_refine(void)
{
    static stad_best best[16];
    const int32_t count = between(1, 16), n = between(1, DISPARITIES / 8) * 8;
    fill_totals(count * n);
    if (draw() % 2)
        stad_best_row_3way_c(words_a, count, n, best);
    else
        stad_best_row_c(words_a, count, n, best);
    stad_refine_row(words_a, best, count, n, mine.i16 + GUARD);
    stad_refine_row_c(words_a, best, count, n, reference.i16 + GUARD);
    return same();
}

/* Runs of winners whose votes meet, of either rule. */
int case_select(void)
{
    static stad_best best[16];
    static int16_t fine[16], votes[2][2][WIDTH];
    static uint8_t confidence[2][WIDTH];
    const int32_t width = between(16, WIDTH), count = between(1, 16), low = between(-20, 20),
                  top = draw() % 2 ? between(1, 20) * 1600 : 9;
    stad_select_job job = {best,
                           fine,
                           between(0, width - count),
                           count,
                           width,
                           low,
                           between(0, 99),
                           draw() % 4 == 0,
                           mine.i16 + GUARD,
                           votes[0][0],
                           votes[0][1],
                           draw() % 4 == 0 ? confidence[0] : NULL,
                           3,
                           5};
    stad_select_job job_c = job;
    int32_t i;
    for (i = 0; i < count; i++) {
        best[i].index = (int16_t)between(0, 20);
        best[i].least = (int16_t)between(0, top);
        best[i].runner_up = (int16_t)between(best[i].least, 32767 - (32767 - top) * (int32_t)(draw() % 2));
        fine[i] = (int16_t)(16 * best[i].index + between(-7, 8));
    }
    for (i = 0; i < width; i++) {
        votes[0][0][i] = votes[1][0][i] = (int16_t)between(-20, 40);
        votes[0][1][i] = votes[1][1][i] = (int16_t)(draw() % 2 ? 32767 : between(0, top));
        confidence[0][i] = confidence[1][i] = 0;
    }
    job_c.disp = reference.i16 + GUARD;
    job_c.vote_disp = votes[1][0];
    job_c.vote_cost = votes[1][1];
    job_c.confidence = job.confidence ? confidence[1] : NULL;
    stad_select_row(&job);
    stad_select_row_c(&job_c);
    return same() && job.firm == job_c.firm && job.rejected == job_c.rejected &&
           memcmp(votes[0], votes[1], sizeof votes[0]) == 0 && memcmp(confidence[0], confidence[1], WIDTH) == 0;
}

/* Disparities around those voted for, some of them none; a vote may be missing. */
int case_check(void)
{
    const int32_t width = between(3, WIDTH), low = between(-20, 20), x0 = between(0, width - 1);
    const stad_check_job job = {mine.i16 + GUARD, words_b, x0, between(x0, width), width, low, between(0, 3)};
    stad_check_job job_c = job;
    int32_t i, rejected;
    job_c.disp = reference.i16 + GUARD;
    for (i = 0; i < width; i++) {
        words_b[i] = (int16_t)(draw() % 8 == 0 ? (low - 1) * 16 : low + between(0, 15));
        mine.i16[GUARD + i] = (int16_t)(draw() % 4 == 0 ? (low - 1) * 16 : low * 16 + between(0, 255));
        reference.i16[GUARD + i] = mine.i16[GUARD + i];
    }
    rejected = stad_check_row(&job);
    return rejected == stad_check_row_c(&job_c) && same();
}
