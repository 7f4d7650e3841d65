/* SPDX-License-Identifier: MIT
 * kernel/case_paths.c - cases of the path kernels and of the winners. */
#include <stdio.h>
#include <string.h>

#include "kernel/kernel_case.h"

enum { LANES = 4, SLOTS = 6 };

/* The lanes of one run: their state, and the lanes that point into it. */
typedef struct lane_group {
    int16_t *cost[LANES], *least[LANES];
    stad_lane lane[LANES];
} lane_group;

static size_t lane_cells(const stad_path_job *job)
{
    return (size_t)(1 + SLOTS * job->stride); /* the least that the contract allows: one fence before, one in every slot */
}

/* State as the library leaves it: costs from `low` to 32767, the least of a slot known and at most 32767 - p2. */
static void fill_lane(chance *c, const stad_path_job *job, int32_t low, int16_t *cost, int16_t *least)
{
    int16_t *slot = cost + 1;
    cost[0] = STAD_COST_MAX;
    for (int32_t s = 0; s < SLOTS; s++, slot += job->stride) {
        least[s] = STAD_COST_MAX;
        for (int32_t d = 0; d < job->stride; d++)
            slot[d] = (int16_t)(d < job->disparities ? chance_value(c, low, STAD_COST_MAX) : STAD_COST_MAX);
        slot[chance_between(c, 0, job->disparities - 1)] = (int16_t)chance_value(c, 0, STAD_COST_MAX - job->p2);
        for (int32_t d = 0; d < job->disparities; d++)
            least[s] = slot[d] < least[s] ? slot[d] : least[s];
    }
}

static void take_lanes(chance *c, const stad_path_job *job, int32_t low, int32_t count, lane_group *g)
{
    const int across = (int)(chance_draw(c) % 2); /* the horizontal lane has two slots and is the first (kernel.h) */
    for (int32_t i = 0; i < count; i++) {
        const int32_t slots = i == 0 && across ? 2 : chance_between(c, 3, SLOTS);
        const stad_lane lane = {NULL, NULL, slots, chance_between(c, 0, slots - 1)};
        g->cost[i] = room_take(c, 2 * lane_cells(job), 2);
        g->least[i] = room_take(c, 2 * SLOTS, 2);
        fill_lane(c, job, low, g->cost[i], g->least[i]);
        g->lane[i] = lane;
        g->lane[i].cost = g->cost[i] + 1;
        g->lane[i].least = g->least[i];
    }
}

static void twin_lanes(const lane_group *g, int32_t count, lane_group *twin)
{
    for (int32_t i = 0; i < count; i++) {
        twin->lane[i] = g->lane[i];
        twin->cost[i] = room_twin(g->cost[i]);
        twin->least[i] = room_twin(g->least[i]);
        twin->lane[i].cost = twin->cost[i] + 1;
        twin->lane[i].least = twin->least[i];
    }
}

static int same_lanes(const lane_group *a, const lane_group *b, const stad_path_job *job, int32_t count)
{
    int same = 1;
    for (int32_t i = 0; i < count; i++)
        same = same && a->lane[i].write == b->lane[i].write && memcmp(a->cost[i], b->cost[i], 2 * lane_cells(job)) == 0 &&
               memcmp(a->least[i], b->least[i], 2 * SLOTS) == 0;
    return same;
}

/* A job of 1..9 pixels; total is set by aim(). Block costs include p2, as the contract says. */
static stad_path_job path_job(kernel_case *k, int32_t p2_top)
{
    chance *c = &k->chance;
    stad_path_job job = {NULL, NULL, chance_between(c, 1, 9), k->size, 0, 0, 0, 0, 0};
    job.stride = job.disparities + (chance_draw(c) % 2 ? 16 : 1);
    job.step = chance_draw(c) % 2 ? 1 : -1;
    job.p2 = chance_value(c, 2, p2_top);
    job.p1 = chance_value(c, 1, job.p2 - 1);
    job.fresh = (int)(chance_draw(c) % 2);
    job.block = room_i16(c, job.count * job.disparities, job.p2, STAD_COST_MAX);
    snprintf(k->text, sizeof k->text, "count %d disparities %d stride %d step %d p1 %d p2 %d fresh %d", job.count,
             job.disparities, job.stride, job.step, job.p1, job.p2, job.fresh);
    return job;
}

/* The job from its first pixel on; total may be NULL. */
static stad_path_job aim(stad_path_job job, int16_t *total)
{
    const int32_t first = job.step > 0 ? 0 : (job.count - 1) * job.disparities;
    job.block += first;
    job.total = total ? total + first : NULL;
    return job;
}

static void note_lanes(kernel_case *k, int32_t count, const stad_lane *first, int wanted)
{
    const size_t end = strlen(k->text);
    snprintf(k->text + end, sizeof k->text - end, " lanes %d slots %d write %d total %d", count, first->slots, first->write,
             wanted);
}

static int case_path_of(kernel_case *k, path_kernel *kernel, path_kernel *kernel_c, int32_t low)
{
    chance *c = &k->chance;
    const stad_path_job job = path_job(k, low < 0 ? 32766 : 12000);
    const int32_t count = chance_between(c, 1, LANES);
    const size_t cells = (size_t)(job.count * job.disparities);
    int16_t *mine = chance_draw(c) % 4 ? room_i16(c, (int32_t)cells, 0, STAD_COST_MAX) : NULL;
    int16_t *reference = mine ? room_twin(mine) : NULL;
    stad_path_job to_mine = aim(job, mine), to_reference = aim(job, reference);
    lane_group a, b;
    take_lanes(c, &job, low, count, &a);
    twin_lanes(&a, count, &b);
    note_lanes(k, count, &a.lane[0], mine != NULL);
    kernel(&to_mine, a.lane, count);
    kernel_c(&to_reference, b.lane, count);
    return (!mine || memcmp(mine, reference, 2 * cells) == 0) && same_lanes(&a, &b, &job, count);
}

int case_path(kernel_case *k)
{
    return case_path_of(k, k->set->path, stad_path_row_c, 0);
}

int case_path_sat(kernel_case *k)
{
    return case_path_of(k, k->set->path_sat, stad_path_row_sat_c, INT16_MIN);
}

int case_path_u8(kernel_case *k)
{
    chance *c = &k->chance;
    const stad_path_job job = path_job(k, 255);
    const int32_t count = chance_between(c, 1, LANES);
    const size_t cells = (size_t)(job.count * job.disparities);
    int16_t *mine = chance_draw(c) % 4 ? room_i16(c, (int32_t)cells, 0, STAD_COST_MAX) : NULL;
    int16_t *reference = mine ? room_twin(mine) : NULL;
    stad_path_job to_mine = aim(job, mine), to_reference = aim(job, reference);
    stad_lane_u8 a[LANES], b[LANES];
    const stad_lane note = {NULL, NULL, SLOTS, 0};
    int same;
    for (int32_t i = 0; i < count; i++) {
        const stad_lane_u8 lane = {room_u8(c, (int32_t)lane_cells(&job), 0, job.p2), SLOTS, chance_between(c, 0, SLOTS - 1)};
        a[i] = lane;
        lane.cost[0] = UINT8_MAX;
        for (int32_t s = 0; s < SLOTS; s++)
            memset(lane.cost + 1 + s * job.stride + job.disparities, UINT8_MAX, (size_t)(job.stride - job.disparities));
        b[i] = lane;
        b[i].cost = (uint8_t *)room_twin(lane.cost) + 1;
        a[i].cost++;
    }
    note_lanes(k, count, &note, mine != NULL);
    k->set->path_u8(&to_mine, a, count);
    stad_path_row_u8_c(&to_reference, b, count);
    same = !mine || memcmp(mine, reference, 2 * cells) == 0;
    for (int32_t i = 0; i < count; i++)
        same = same && a[i].write == b[i].write && memcmp(a[i].cost - 1, b[i].cost - 1, lane_cells(&job)) == 0;
    return same;
}

int case_gather(kernel_case *k)
{
    chance *c = &k->chance;
    const stad_path_job job = path_job(k, 9000);
    const int32_t cells = job.count * job.disparities, slot = chance_between(c, 0, 2);
    int16_t *mine = room_i16(c, cells, 0, STAD_COST_MAX), *reference = room_twin(mine);
    lane_group g;
    take_lanes(c, &job, 0, 1, &g);
    g.lane[0].slots = chance_between(c, 3, SLOTS);
    note_lanes(k, 1, &g.lane[0], slot);
    k->set->gather(mine, &g.lane[0], slot, &job);
    stad_gather_row_c(reference, &g.lane[0], slot, &job);
    return memcmp(mine, reference, 2 * (size_t)cells) == 0;
}

/* -- winners: few different totals, so that the least comes up more than once ---------------------------------------------- */

/* Exactly two least totals of a column, a multiple of 8 apart: what the 3WAY rule decides otherwise. */
static void plant_ties(chance *c, int16_t *total, int32_t count, int32_t n, int32_t low)
{
    for (int32_t i = 0; i < count; i++, total += n) {
        const int32_t first = chance_between(c, 0, n - 1), lane = first % 8;
        for (int32_t d = 0; d < n; d++)
            total[d] = (int16_t)(total[d] == low ? low + 1 : total[d]);
        total[first] = total[lane + 8 * chance_between(c, 0, n / 8 - 1)] = (int16_t)low;
    }
}

static int case_best_of(kernel_case *k, best_kernel *kernel, best_kernel *kernel_c)
{
    chance *c = &k->chance;
    const int32_t n = k->size, count = chance_between(c, 1, 16), spread = chance_draw(c) % 3 ? chance_between(c, 0, 12) : 65535;
    const int32_t low = chance_draw(c) % 4 == 0 ? STAD_COST_MAX - 1 : chance_between(c, INT16_MIN, STAD_COST_MAX);
    const int32_t from = spread == 65535 ? INT16_MIN : low, to = low + spread < STAD_COST_MAX ? low + spread : STAD_COST_MAX;
    int16_t *total = room_i16(c, count * n, from, to);
    stad_best *mine = room_take(c, (size_t)count * sizeof *mine, 2), *reference = room_twin(mine);
    snprintf(k->text, sizeof k->text, "count %d disparities %d totals %d..%d", count, n, from, to);
    if (from < STAD_COST_MAX && chance_draw(c) % 2)
        plant_ties(c, total, count, n, from);
    kernel(total, count, n, mine);
    kernel_c(total, count, n, reference);
    return memcmp(mine, reference, (size_t)count * sizeof *mine) == 0;
}

int case_best(kernel_case *k)
{
    return case_best_of(k, k->set->best, stad_best_row_c);
}

int case_best_3way(kernel_case *k)
{
    return case_best_of(k, k->set->best_3way, stad_best_row_3way_c);
}

/* The last path's sums, then winners among them: totals close together, so that the least comes up more than once. */
int case_last(kernel_case *k)
{
    chance *c = &k->chance;
    stad_path_job job = path_job(k, 12000);
    const int32_t cells = job.count * job.disparities, top = chance_draw(c) % 3 ? chance_between(c, 0, 3) : STAD_COST_MAX;
    const int three_way = (int)(chance_draw(c) % 2);
    int16_t *mine = room_i16(c, cells, 0, top), *reference = room_twin(mine);
    stad_best *best = room_take(c, (size_t)job.count * sizeof *best, 2), *best_c = room_twin(best);
    lane_group a, b;
    job.fresh = 0;
    job.step = -1;
    take_lanes(c, &job, 0, 1, &a);
    twin_lanes(&a, 1, &b);
    note_lanes(k, 1, &a.lane[0], three_way);
    const stad_path_job to_mine = aim(job, mine), to_reference = aim(job, reference);
    const int path_left = chance_draw(c) % 4 != 0;
    k->set->last(&to_mine, path_left ? a.lane : NULL, three_way, best);
    if (path_left)
        stad_path_row_c(&to_reference, b.lane, 1);
    (three_way ? stad_best_row_3way_c : stad_best_row_c)(reference, job.count, job.disparities, best_c);
    return memcmp(mine, reference, 2 * (size_t)cells) == 0 && same_lanes(&a, &b, &job, 1) &&
           memcmp(best, best_c, (size_t)job.count * sizeof *best) == 0;
}

int case_refine(kernel_case *k)
{
    chance *c = &k->chance;
    const int32_t n = k->size, count = chance_between(c, 1, 17),
                  top = chance_draw(c) % 2 ? chance_between(c, 0, 40) : STAD_COST_MAX;
    int16_t *total = room_i16(c, count * n, top == STAD_COST_MAX ? INT16_MIN : 0, top);
    stad_best *best = room_take(c, (size_t)count * sizeof *best, 2);
    int16_t *mine = room_i16(c, count, 0, 0), *reference = room_twin(mine);
    snprintf(k->text, sizeof k->text, "count %d disparities %d totals to %d", count, n, top);
    stad_best_row_c(total, count, n, best);
    k->set->refine(total, best, count, n, mine);
    stad_refine_row_c(total, best, count, n, reference);
    return memcmp(mine, reference, 2 * (size_t)count) == 0;
}
