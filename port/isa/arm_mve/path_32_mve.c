/* SPDX-License-Identifier: MIT
 * slide -> [PATH] -> best
 * port/isa/arm_mve/path_32_mve.c - the path kernel for 32 disparities in slots of 48 cells, as the fast plan has them.
 *
 * The template's recurrence (arm_common/path_row_arm.h), with little to do between pixels: sizes are constants, so that one
 * address serves a ring's slot and the one after it, and least costs are gathered in core registers. Where a ring turns, and
 * for all other sizes, the template serves. Bounds: the template's. */
#include <arm_mve.h>

#include "base/arith.h"
#include "kernel/kernel.h"

enum { CELLS = 32, SLOT = 48 };

#define ALWAYS_INLINE static inline __attribute__((always_inline))

/* A lane at a pixel: the slots read and written, where the least cost read stands (a ring's), the least cost. */
typedef struct place {
    const int16_t *from;
    int16_t *to, *least_to;
    uint32_t least;
} place;

/* Pixels of a run in which no ring turns. */
typedef struct stretch {
    int32_t first, count;
} stretch;

/* Keeps the compiler from mixing groups of 8 disparities: it would run out of its 8 vector registers. */
#define IN_ORDER __asm__ volatile("" ::: "memory")

/* Keeps an address in a register of its own, not made anew from a base and a counter. */
#define KEEP(address) __asm__("" : "+r"(address))

/* Eight disparities of a lane; limit: the previous least cost + p2. */
ALWAYS_INLINE uint16x8_t step(place *t, int32_t d, uint16x8_t cost, uint16x8_t limit, uint16_t p1)
{
    const uint16_t *from = (const uint16_t *)t->from + d;
    const uint16x8_t side = vaddq_n_u16(vminq_u16(vld1q_u16(from - 1), vld1q_u16(from + 1)), p1);
    const uint16x8_t path = vsubq_u16(cost, vqsubq_u16(limit, vminq_u16(vld1q_u16(from), side)));
    vst1q_u16((uint16_t *)t->to + d, path);
    t->least = vminvq_u16((uint16_t)t->least, path);
    return path;
}

ALWAYS_INLINE uint16x8_t add_sat(uint16x8_t a, uint16x8_t b)
{
    return vreinterpretq_u16_s16(vqaddq_s16(vreinterpretq_s16_u16(a), vreinterpretq_s16_u16(b)));
}

/* The lane's least cost + p2; the least cost begins anew. */
ALWAYS_INLINE uint16x8_t enter(place *t, int turns, int32_t p2)
{
    const uint32_t least = turns ? t->least : (uint16_t)t->least_to[1];
    t->least = UINT16_MAX;
    return vdupq_n_u16((uint16_t)(least + (uint32_t)p2));
}

/* On to the next pixel: a lane of two slots exchanges them. */
ALWAYS_INLINE void leave(place *t, int turns)
{
    if (turns) {
        int16_t *read = (int16_t *)(uintptr_t)t->from;
        t->from = t->to;
        t->to = read;
    } else {
        *t->least_to++ = (int16_t)t->least;
        t->to += SLOT;
        t->from = t->to + SLOT;
    }
}

/* The pixels of one or two lanes, the first of two slots if it `turns`; `fresh`: total is written, else added to. */
ALWAYS_INLINE void run_of(const stad_path_job *job, const stretch *s, place *t, int lanes, int turns, int fresh)
{
    const ptrdiff_t next = (ptrdiff_t)job->step * CELLS;
    const uint16_t *block = (const uint16_t *)job->block + s->first * next;
    uint16_t *total = (uint16_t *)job->total + s->first * next;
    const uint16_t p1 = (uint16_t)job->p1;
    const int32_t p2 = job->p2;
    uint32_t left = (uint32_t)s->count;
    do {
        const uint16x8_t limit = enter(&t[0], turns, p2);
        const uint16x8_t second = lanes == 2 ? enter(&t[1], 0, p2) : limit;
#pragma GCC unroll 4
        for (int32_t d = 0; d < CELLS; d += 8) {
            const uint16x8_t cost = vld1q_u16(block + d);
            uint16x8_t sum = step(&t[0], d, cost, limit, p1);
            if (lanes == 2)
                sum = add_sat(sum, step(&t[1], d, cost, second, p1));
            if (!fresh)
                sum = add_sat(sum, vld1q_u16(total + d));
            vst1q_u16(total + d, sum);
            IN_ORDER;
        }
        leave(&t[0], turns);
        if (lanes == 2)
            leave(&t[1], 0);
        block += next;
        total += next;
        KEEP(block);
        KEEP(total);
    } while (--left != 0);
}

/* Where the lane stands; a ring reads the slot after the one it writes. */
static place place_of(const stad_lane *lane, int turns)
{
    const int32_t from = turns ? 1 - lane->write : lane->write + 1;
    const place t = {lane->cost + (ptrdiff_t)from * SLOT, lane->cost + (ptrdiff_t)lane->write * SLOT, lane->least + lane->write,
                     (uint16_t)lane->least[from]};
    return t;
}

/* The least cost of a slot. */
static int16_t least_of(const int16_t *slot)
{
    uint16_t least = UINT16_MAX;
    for (int32_t d = 0; d < CELLS; d += 8)
        least = vminvq_u16(least, vreinterpretq_u16_s16(vld1q_s16(slot + d)));
    return (int16_t)least;
}

/* Leaves the lane `count` pixels further. */
static void put_back(stad_lane *lane, const place *t, int turns, int32_t count)
{
    if (!turns) {
        lane->write += count;
        return;
    }
    lane->write ^= count & 1;
    lane->least[1 - lane->write] = (int16_t)t->least;
    if (count > 1)
        lane->least[lane->write] = least_of(t->to);
}

/* Each form is a function of its own: compilers allot registers by function. */
#define FORM(name, n, turns, fresh)                                                                   \
    static __attribute__((noinline)) void name(const stad_path_job *job, stad_lane *lanes, stretch s) \
    {                                                                                                 \
        place t[2] = {place_of(&lanes[0], turns)};                                                    \
        if (n == 2)                                                                                   \
            t[1] = place_of(&lanes[1], 0);                                                            \
        run_of(job, &s, t, n, turns, fresh);                                                          \
        put_back(&lanes[0], &t[0], turns, s.count);                                                   \
        if (n == 2)                                                                                   \
            put_back(&lanes[1], &t[1], 0, s.count);                                                   \
    }

FORM(two_turning_fresh, 2, 1, 1)
FORM(two_turning_add, 2, 1, 0)
FORM(two_add, 2, 0, 0)
FORM(one_turning_fresh, 1, 1, 1)
FORM(one_turning_add, 1, 1, 0)

/* Pixels by the template. */
static __attribute__((noinline)) void take_any(const stad_path_job *job, stad_lane *lanes, int32_t count, int fresh, stretch s)
{
    const ptrdiff_t done = (ptrdiff_t)s.first * job->step * job->disparities;
    stad_path_job part = *job;
    part.block += done;
    part.total += job->total ? done : 0;
    part.count = s.count;
    part.fresh = fresh;
    stad_path_row_mve(&part, lanes, count);
}

static void take_one(const stad_path_job *job, stad_lane *lane, int fresh)
{
    const stretch all = {0, job->count};
    if (!job->total || lane->slots != 2)
        take_any(job, lane, 1, fresh, all);
    else if (fresh)
        one_turning_fresh(job, lane, all);
    else
        one_turning_add(job, lane, all);
}

static int32_t before_turn(const stad_lane *lane)
{
    return lane->slots - 1 - lane->write;
}

static void take_two(const stad_path_job *job, stad_lane *lanes, int fresh)
{
    const int turns = lanes[0].slots == 2;
    stretch s = {0, job->count};
    if (!job->total || (!turns && fresh)) {
        take_any(job, lanes, 2, fresh, s);
        return;
    }
    for (; s.first < job->count; s.first += s.count) {
        s.count = min_i32(job->count - s.first, before_turn(&lanes[1]));
        if (!turns)
            s.count = min_i32(s.count, before_turn(&lanes[0]));
        if (s.count == 0) {
            s.count = 1;
            take_any(job, lanes, 2, fresh, s);
        } else if (!turns) {
            two_add(job, lanes, s);
        } else if (fresh) {
            two_turning_fresh(job, lanes, s);
        } else {
            two_turning_add(job, lanes, s);
        }
    }
}

void stad_path_row_sized_mve(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
{
    int fresh = job->fresh;
    if (job->disparities != CELLS || job->stride != SLOT) {
        stad_path_row_mve(job, lanes, lane_count);
        return;
    }
    for (; lane_count >= 2; lane_count -= 2, lanes += 2, fresh = 0)
        take_two(job, lanes, fresh);
    if (lane_count > 0)
        take_one(job, lanes, fresh);
}
