/* SPDX-License-Identifier: MIT
 * kernel/case_rows.c - cases of the kernels before the paths, and of the median. */
#include <stdio.h>
#include <string.h>

#include "kernel/kernel_case.h"

static int32_t least_i32(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

static int32_t most_i32(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

int case_prefilter(kernel_case *k)
{
    chance *c = &k->chance;
    const int32_t width = k->size, channels = chance_draw(c) % 3 ? 1 : 3;
    const int32_t cap = (chance_draw(c) % 4 ? chance_between(c, 7, 63) : chance_between(c, 0, 16383)) * 2 + 1;
    const uint8_t *above = room_u8(c, width * channels, 0, 255), *row = room_u8(c, width * channels, 0, 255);
    const uint8_t *below = room_u8(c, width * channels, 0, 255);
    uint8_t *mine = room_u8(c, 2 * channels * width, 0, 255), *reference = room_twin(mine);
    snprintf(k->text, sizeof k->text, "width %d channels %d cap %d", width, channels, cap);
    k->set->prefilter(above, row, below, width, channels, cap, mine);
    stad_prefilter_row_c(above, row, below, width, channels, cap, reference);
    return memcmp(mine, reference, 2 * (size_t)(channels * width)) == 0;
}

int case_range(kernel_case *k)
{
    chance *c = &k->chance;
    const int32_t width = k->size;
    const int reverse = (int)(chance_draw(c) % 2);
    const uint8_t *plane = room_u8(c, width, 0, 255);
    uint8_t *mine = room_u8(c, 3 * width, 0, 255), *reference = room_twin(mine);
    snprintf(k->text, sizeof k->text, "width %d reverse %d", width, reverse);
    k->set->range(plane, width, reverse, mine);
    stad_range_row_c(plane, width, reverse, reference);
    return memcmp(mine, reference, 3 * (size_t)width) == 0;
}

/* Feature rows as the range kernel makes them: low <= value <= high. */
static uint8_t *features(chance *c, int32_t width, int32_t channels, int32_t gradient_top, int reverse)
{
    uint8_t *out = room_take(c, 6 * (size_t)(channels * width), 1);
    for (int32_t p = 0; p < 2 * channels; p++)
        stad_range_row_c(room_u8(c, width, 0, p < channels ? gradient_top : 255), width, reverse, out + 3 * width * p);
    return out;
}

/* A run of up to 16 columns anywhere in a row that is just wide enough, or wider. */
static stad_cost_job cost_job(kernel_case *k, int32_t channels, int32_t gradient_top)
{
    chance *c = &k->chance;
    const int32_t n = k->size, least = chance_between(c, -20, 20), width = n + 20 + chance_between(c, 0, 40);
    const int32_t first = most_i32(least + n - 1, 0), last = least_i32(width - 1 + least, width - 1);
    stad_cost_job job = {NULL, NULL, width, channels, 0, 0, least, n};
    job.x = chance_draw(c) % 3 ? chance_between(c, first, last) : first;
    job.count = chance_between(c, 1, least_i32(last - job.x + 1, 16));
    job.left = features(c, width, channels, gradient_top, 0);
    job.right = features(c, width, channels, gradient_top, 1);
    snprintf(k->text, sizeof k->text, "width %d channels %d x %d count %d min_disparity %d disparities %d", width, channels,
             job.x, job.count, least, n);
    return job;
}

int case_cost_u8(kernel_case *k)
{
    const int32_t channels = chance_draw(&k->chance) % 3 ? 1 : 3;
    const stad_cost_job job = cost_job(k, channels, channels == 1 ? 192 : 22); /* channels * (top + 63) <= 255 */
    uint8_t *mine = room_u8(&k->chance, job.count * job.disparities, 0, 255), *reference = room_twin(mine);
    k->set->cost_u8(&job, mine);
    stad_cost_row_u8_c(&job, reference);
    return memcmp(mine, reference, (size_t)(job.count * job.disparities)) == 0;
}

int case_cost_u16(kernel_case *k)
{
    const stad_cost_job job = cost_job(k, chance_draw(&k->chance) % 2 ? 1 : 3, 255);
    uint16_t *mine = room_u16(&k->chance, job.count * job.disparities, 0, 65535), *reference = room_twin(mine);
    k->set->cost_u16(&job, mine);
    stad_cost_row_u16_c(&job, reference);
    return memcmp(mine, reference, 2 * (size_t)(job.count * job.disparities)) == 0;
}

/* -- box: sums begin and end anywhere in 0..32767 ------------------------------------------------------------------------ */

/* Sums that `weight` times the costs takes to at most 32767. */
static int16_t *sums_for(chance *c, int32_t n, const uint16_t *cost, int32_t weight)
{
    int16_t *sum = room_take(c, 2 * (size_t)n, 2);
    for (int32_t i = 0; i < n; i++)
        sum[i] = (int16_t)chance_value(c, 0, STAD_COST_MAX - cost[i] * weight);
    return sum;
}

/* The costs as bytes. */
static const uint8_t *narrowed(chance *c, const uint16_t *wide, int32_t n)
{
    uint8_t *out = room_take(c, (size_t)n, 1);
    for (int32_t i = 0; i < n; i++)
        out[i] = (uint8_t)wide[i];
    return out;
}

static int case_box_add(kernel_case *k, int wide)
{
    chance *c = &k->chance;
    const int32_t n = k->size, top = wide ? 954 : 255, weight = chance_between(c, 1, wide ? 34 : 128);
    const uint16_t *cost = room_u16(c, n, 0, top);
    const uint8_t *bytes = narrowed(c, cost, n);
    int16_t *mine = sums_for(c, n, cost, weight), *reference = room_twin(mine);
    snprintf(k->text, sizeof k->text, "n %d weight %d", n, weight);
    if (wide) {
        k->set->box_add_u16(mine, cost, n, weight);
        stad_box_add_row_u16_c(reference, cost, n, weight);
    } else {
        k->set->box_add_u8(mine, bytes, n, weight);
        stad_box_add_row_u8_c(reference, bytes, n, weight);
    }
    return memcmp(mine, reference, 2 * (size_t)n) == 0;
}

int case_box_add_u8(kernel_case *k)
{
    return case_box_add(k, 0);
}

int case_box_add_u16(kernel_case *k)
{
    return case_box_add(k, 1);
}

/* -- block: costs that a move takes to at most 32767 and at least 0 -------------------------------------------------------- */

/* Any such costs for the move of `job`, whose effect on a row of zeros tells how far each may go. */
static int16_t *blocks_for(chance *c, const stad_block_job *job)
{
    const int32_t n = job->columns * job->disparities;
    int16_t *block = room_i16(c, n, 0, 0);
    stad_block_row_c(job, block);
    for (int32_t i = 0; i < n; i++)
        block[i] = (int16_t)chance_value(c, most_i32(-block[i], 0), least_i32(STAD_COST_MAX - block[i], STAD_COST_MAX));
    return block;
}

int case_block(kernel_case *k)
{
    chance *c = &k->chance;
    const int wide = (int)(chance_draw(c) % 2);
    const int32_t n = k->size, columns = chance_between(c, 1, 40), top = wide ? 954 : 255;
    const uint16_t *in = room_u16(c, columns * n, 0, top), *out = room_u16(c, columns * n, 0, top);
    stad_block_job job = {in, out, room_i16(c, n, 0, 9), columns, n, chance_between(c, 0, 6), wide};
    if (!wide) {
        job.in = narrowed(c, in, columns * n);
        job.out = narrowed(c, out, columns * n);
    }
    int16_t *mine = blocks_for(c, &job), *reference = room_twin(mine);
    snprintf(k->text, sizeof k->text, "columns %d disparities %d radius %d wide %d", columns, n, job.radius, wide);
    k->set->block(&job, mine);
    stad_block_row_c(&job, reference);
    return memcmp(mine, reference, 2 * (size_t)(columns * n)) == 0;
}

int case_slide(kernel_case *k)
{
    chance *c = &k->chance;
    const int32_t n = k->size, columns = chance_between(c, 1, 40), radius = chance_between(c, 0, 6);
    stad_slide_job job = {NULL, columns, n, radius, chance_between(c, 2, 9000), 0, 0};
    int16_t *mine, *reference;
    job.x = chance_between(c, 0, columns - 1);
    job.count = chance_between(c, 1, least_i32(columns - job.x, 16));
    job.sum = room_i16(c, columns * n, 0, (STAD_COST_MAX - job.p2) / (2 * radius + 1));
    mine = room_i16(c, job.count * n, 0, 9);
    reference = room_twin(mine);
    snprintf(k->text, sizeof k->text, "columns %d disparities %d radius %d p2 %d x %d count %d", columns, n, radius, job.p2,
             job.x, job.count);
    k->set->slide(&job, mine);
    stad_slide_row_c(&job, reference);
    return memcmp(mine, reference, 2 * (size_t)(job.count * n)) == 0;
}

int case_median(kernel_case *k)
{
    chance *c = &k->chance;
    const int32_t width = k->size;
    const int16_t *above = room_i16(c, width, INT16_MIN, INT16_MAX), *row = room_i16(c, width, -16, 1008);
    const int16_t *below = room_i16(c, width, INT16_MIN, INT16_MAX);
    int16_t *mine = room_i16(c, width, 0, 9), *reference = room_twin(mine);
    snprintf(k->text, sizeof k->text, "width %d", width);
    k->set->median(above, row, below, width, mine);
    stad_median_row_c(above, row, below, width, reference);
    return memcmp(mine, reference, 2 * (size_t)width) == 0;
}

/* Winners; half of the rows have stretches of one disparity, as surfaces have. */
static const stad_best *draw_winners(chance *c, int32_t count)
{
    int16_t *cell = room_i16(c, 3 * count, -32, STAD_COST_MAX);
    const int32_t stretch = chance_draw(c) % 2 ? 1 : chance_between(c, 8, 40);
    for (int32_t i = 0; i < count; i++) {
        cell[3 * i] = (int16_t)(i % stretch ? cell[3 * i - 3] : chance_between(c, 0, 40));
        if (chance_draw(c) % 2) /* a close rival */
            cell[3 * i + 2] =
                (int16_t)least_i32(cell[3 * i + 1] + chance_between(c, 0, most_i32(cell[3 * i + 1], 0) / 4 + 1), STAD_COST_MAX);
    }
    return (const stad_best *)(void *)cell;
}

int case_select(kernel_case *k)
{
    chance *c = &k->chance;
    const int32_t count = k->size, x = chance_between(c, 0, 40), width = x + count + chance_between(c, 0, 9);
    const int32_t min_disparity = chance_between(c, -20, 20), uniqueness = chance_draw(c) % 3 ? chance_between(c, 0, 99) : 0;
    const int16_t none = (int16_t)((min_disparity - 1) * 16);
    uint8_t *sure[2] = {NULL, NULL};
    int16_t *row[2][3];
    stad_select_job job = {draw_winners(c, count),
                           room_i16(c, count, -8, 700),
                           x,
                           count,
                           width,
                           min_disparity,
                           uniqueness,
                           chance_draw(c) % 4 == 0,
                           NULL,
                           NULL,
                           NULL,
                           NULL,
                           5,
                           7};
    for (int i = 0; i < 3; i++) {
        row[0][i] = room_i16(c, width, i < 2 ? none : STAD_COST_MAX, i < 2 ? none : STAD_COST_MAX);
        row[1][i] = room_twin(row[0][i]);
    }
    if (chance_draw(c) % 4 == 0) {
        sure[0] = room_u8(c, width, 0, 0);
        sure[1] = room_twin(sure[0]);
    }
    snprintf(k->text, sizeof k->text, "x %d count %d width %d min %d uniqueness %d 3way %d confidence %d", x, count, width,
             min_disparity, uniqueness, job.floor_rule, sure[0] != NULL);
    stad_select_job jobs[2] = {job, job};
    for (int i = 0; i < 2; i++) {
        jobs[i].disp = row[i][0];
        jobs[i].vote_disp = row[i][1];
        jobs[i].vote_cost = row[i][2];
        jobs[i].confidence = sure[i];
    }
    k->set->select(&jobs[0]);
    stad_select_row_c(&jobs[1]);
    int same = jobs[0].firm == jobs[1].firm && jobs[0].rejected == jobs[1].rejected;
    for (int i = 0; i < 3; i++)
        same = same && memcmp(row[0][i], row[1][i], 2 * (size_t)width) == 0;
    return same && (!sure[0] || memcmp(sure[0], sure[1], (size_t)width) == 0);
}

/* Votes near the disparities, so that either, both or none agree; disparities that lead outside the row. */
int case_check(kernel_case *k)
{
    chance *c = &k->chance;
    const int32_t width = k->size, low = chance_draw(c) % 2 ? chance_between(c, -30, 30) : chance_between(c, -2047, 2007);
    const int32_t most = chance_draw(c) % 8 ? chance_between(c, 1, 3) : chance_between(c, 1, 32767),
                  range = chance_between(c, 1, 40);
    const int32_t x0 = chance_between(c, 0, width), none = (low - 1) * 16;
    int16_t *votes = room_i16(c, width, low, low + range), *mine = room_i16(c, width, 16 * low, 16 * (low + range));
    for (int32_t x = 0; x < width; x++) {
        votes[x] = (int16_t)(chance_draw(c) % 6 ? votes[x] : none);
        mine[x] = (int16_t)(chance_draw(c) % 6 ? mine[x] : none);
    }
    int16_t *reference = room_twin(mine);
    stad_check_job job = {mine, votes, x0, chance_between(c, x0, width), width, low, most}, job_c = job;
    job_c.disp = reference;
    snprintf(k->text, sizeof k->text, "x %d..%d width %d min %d most %d", job.x0, job.x1, width, low, most);
    return k->set->check(&job) == stad_check_row_c(&job_c) && memcmp(mine, reference, 2 * (size_t)width) == 0;
}
