/* SPDX-License-Identifier: MIT
 * test/target/kernels_paths.c - cases of the paths: lanes of both runs start from the same state and must end in the same. */
#include <string.h>

#include "kernel/kernel.h"
#include "kernels.h"

enum { LANES = 4, SLOTS = 6, LANE_CELLS = 32 + SLOTS * STRIDE };
static int16_t lane_mine[LANES][LANE_CELLS], lane_reference[LANES][LANE_CELLS];
static int16_t least_mine[LANES][SLOTS], least_reference[LANES][SLOTS];
static uint8_t byte_mine[LANES][LANE_CELLS], byte_reference[LANES][LANE_CELLS];

/* State as the library leaves it: costs at most 32767, their least at most 32767 - p2, fences drawn. */
static void fill_lane(int k, const stad_path_job *job, int saturating)
{
    int32_t s, d;
    for (d = 0; d < LANE_CELLS; d++)
        lane_mine[k][d] = STAD_COST_MAX;
    for (s = 0; s < SLOTS; s++) {
        int16_t *slot = lane_mine[k] + 16 + s * job->stride;
        fill_i16(slot, job->disparities, saturating ? -32768 : 0, 32767);
        slot[between(0, job->disparities - 1)] = (int16_t)value_to(STAD_COST_MAX - job->p2);
        least_mine[k][s] = STAD_COST_MAX;
        for (d = 0; d < job->disparities; d++)
            least_mine[k][s] = slot[d] < least_mine[k][s] ? slot[d] : least_mine[k][s];
    }
}

static stad_path_job path_job(int32_t p2_top, int32_t block_top)
{
    stad_path_job job = {words_a, mine.i16 + GUARD, 0, 0, 0, 0, 0, 0, 0};
    job.disparities = draw() % 3 == 0 ? 32 : between(1, DISPARITIES / 8) * 8; /* which some ports have a kernel for */
    job.stride = job.disparities + (draw() % 2 ? 16 : 1);                     /* as the plans have it */
    job.count = between(1, 9);
    job.step = draw() % 2 ? 1 : -1;
    job.p2 = between(2, p2_top);
    job.p1 = between(1, job.p2 - 1);
    job.fresh = (int)(draw() % 2);
    fill_i16(words_a, job.count * job.disparities, job.p2, block_top);
    fill_i16(words_b, job.count * job.disparities, 0, 32767);
    memcpy(mine.i16 + GUARD, words_b, 2 * (size_t)(job.count * job.disparities));
    memcpy(reference.i16 + GUARD, words_b, 2 * (size_t)(job.count * job.disparities));
    return job;
}

/* Points a job at its first pixel and at one of the two outputs, or at none. */
static void aim(stad_path_job *job, int16_t *total, int wanted)
{
    const int32_t first = job->step > 0 ? 0 : (job->count - 1) * job->disparities;
    job->block = words_a + first;
    job->total = wanted ? total + GUARD + first : NULL;
}

static int case_path_of(int saturating)
{
    stad_path_job job = path_job(saturating ? 32767 : 9000, 32767);
    const int wanted = draw() % 4 != 0;
    const int32_t count = between(1, LANES), write = between(0, SLOTS - 1), slots = draw() % 3 == 0 ? 2 : SLOTS;
    stad_lane lanes[LANES];
    int k;
    for (k = 0; k < LANES; k++)
        fill_lane(k, &job, saturating);
    memcpy(lane_reference, lane_mine, sizeof lane_mine);
    memcpy(least_reference, least_mine, sizeof least_mine);
    for (k = 0; k < count; k++) {
        const stad_lane lane = {lane_mine[k] + 16, least_mine[k], k == 0 ? slots : SLOTS, k == 0 ? write % slots : write};
        lanes[k] = lane;
    }
    aim(&job, mine.i16, wanted);
    if (saturating)
        stad_path_row_sat(&job, lanes, count);
    else
        stad_path_row(&job, lanes, count);
    for (k = 0; k < count; k++) {
        const stad_lane lane = {lane_reference[k] + 16, least_reference[k], k == 0 ? slots : SLOTS,
                                k == 0 ? write % slots : write};
        if (lanes[k].write != (lane.write + job.count) % lane.slots)
            return 0;
        lanes[k] = lane;
    }
    aim(&job, reference.i16, wanted);
    if (saturating)
        stad_path_row_sat_c(&job, lanes, count);
    else
        stad_path_row_c(&job, lanes, count);
    return same() && memcmp(lane_reference, lane_mine, sizeof lane_mine) == 0 &&
           memcmp(least_reference, least_mine, sizeof least_mine) == 0;
}

int case_path(void)
{
    return case_path_of(0);
}

int case_path_sat(void)
{
    return case_path_of(1);
}

int case_path_u8(void)
{
    stad_path_job job = path_job(255, 32767);
    const int32_t count = between(1, LANES), write = between(0, SLOTS - 1);
    const int wanted = draw() % 4 != 0;
    stad_lane_u8 lanes[LANES];
    int32_t k, s;
    memset(byte_mine, 255, sizeof byte_mine);
    for (k = 0; k < LANES; k++)
        for (s = 0; s < SLOTS; s++)
            fill_u8(byte_mine[k] + 16 + s * job.stride, job.disparities, job.p2);
    memcpy(byte_reference, byte_mine, sizeof byte_mine);
    for (k = 0; k < count; k++) {
        const stad_lane_u8 lane = {byte_mine[k] + 16, SLOTS, write};
        lanes[k] = lane;
    }
    aim(&job, mine.i16, wanted);
    stad_path_row_u8(&job, lanes, count);
    for (k = 0; k < count; k++) {
        const stad_lane_u8 lane = {byte_reference[k] + 16, SLOTS, write};
        lanes[k] = lane;
    }
    aim(&job, reference.i16, wanted);
    stad_path_row_u8_c(&job, lanes, count);
    return same() && memcmp(byte_reference, byte_mine, sizeof byte_mine) == 0;
}

int case_gather(void)
{
    stad_path_job job = path_job(9000, 32767);
    stad_lane lane = {lane_mine[0] + 16, least_mine[0], SLOTS, 0};
    const int32_t slot = between(0, SLOTS - 1);
    fill_lane(0, &job, (int)(draw() % 2));
    job.count = job.count < SLOTS ? job.count : SLOTS;
    stad_gather_row(mine.i16 + GUARD, &lane, slot, &job);
    stad_gather_row_c(reference.i16 + GUARD, &lane, slot, &job);
    return same();
}
