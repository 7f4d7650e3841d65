/* SPDX-License-Identifier: MIT
 * slide -> [PATH] -> best
 * port/isa/riscv_v/path_row_rvv.c - path costs, a strip of disparities at once, all lanes of a pixel in turn.
 *
 * With all lanes unsigned and m the previous pixel's least cost, the recurrence of kernel/path_row.c is
 *     L = C + 1 + sat(min(p[d], min(p[d-1], p[d+1]) + p1) + room),   room = 65535 - (m + p2)
 * modulo 65536, because what saturates is min(..., m + p2). Bounds: costs, fences and p1 are at most 32767, so no unsigned
 * sum wraps but the one that is meant to. */
#include <riscv_vector.h>

#include "../common/lane_track.h"

enum total_use { TOTAL_NONE, TOTAL_FRESH, TOTAL_ADD };

#define INLINE static inline __attribute__((always_inline))

/* What a run needs of its job, in registers: stores through vectors might alias the job itself. */
typedef struct run {
    size_t n;
    ptrdiff_t stride, to_next; /* cells from a pixel to the next one, in block and total */
    uint16_t p1;
    int32_t p2;
} run;

/* A strip of a lane: `after` is the block cost + 1. */
INLINE vuint16m4_t step(uint16_t room, vuint16m1_t *least, const uint16_t *from, uint16_t *to, vuint16m4_t after, uint16_t p1,
                        size_t vl)
{
    const vuint16m4_t below = __riscv_vle16_v_u16m4(from - 1, vl), above = __riscv_vle16_v_u16m4(from + 1, vl);
    const vuint16m4_t side = __riscv_vadd_vx_u16m4(__riscv_vminu_vv_u16m4(below, above, vl), p1, vl);
    const vuint16m4_t reach = __riscv_vminu_vv_u16m4(__riscv_vle16_v_u16m4(from, vl), side, vl);
    const vuint16m4_t path = __riscv_vadd_vv_u16m4(after, __riscv_vsaddu_vx_u16m4(reach, room, vl), vl);
    __riscv_vse16_v_u16m4(to, path, vl);
    *least = __riscv_vredminu_vs_u16m4_u16m1(path, *least, vl);
    return path;
}

INLINE vuint16m4_t add_sat(vuint16m4_t a, vuint16m4_t b, size_t vl)
{
    const vint16m4_t sum =
        __riscv_vsadd_vv_i16m4(__riscv_vreinterpret_v_u16m4_i16m4(a), __riscv_vreinterpret_v_u16m4_i16m4(b), vl);
    return __riscv_vreinterpret_v_i16m4_u16m4(sum);
}

/* One pixel of `count` lanes; count, turns and use are constants where it is inlined. */
INLINE void pixel(const run *r, const uint16_t *block, uint16_t *total, track *t, int count, int turns, enum total_use use)
{
    const vuint16m1_t most = __riscv_vmv_v_x_u16m1(STAD_COST_MAX, 1);
    vuint16m1_t least_0 = most, least_1 = most, least_2 = most, least_3 = most;
    uint16_t room[4];
#pragma GCC unroll 4
    for (int k = 0; k < count; k++)
        room[k] = (uint16_t)(65535 - r->p2 - track_least(&t[k], turns && k == 0));
    for (size_t at = 0, vl; at < r->n; at += vl) {
        vl = __riscv_vsetvl_e16m4(r->n - at);
        const vuint16m4_t after = __riscv_vadd_vx_u16m4(__riscv_vle16_v_u16m4(block + at, vl), 1, vl);
#define LANE(k) step(room[k], &least_##k, (const uint16_t *)t[k].from + at, (uint16_t *)t[k].to + at, after, r->p1, vl)
        vuint16m4_t sum = LANE(0);
        if (count > 1)
            sum = add_sat(sum, LANE(1), vl);
        if (count > 2)
            sum = add_sat(sum, LANE(2), vl);
        if (count > 3)
            sum = add_sat(sum, LANE(3), vl);
        if (use == TOTAL_ADD)
            sum = add_sat(sum, __riscv_vle16_v_u16m4(total + at, vl), vl);
        if (use != TOTAL_NONE)
            __riscv_vse16_v_u16m4(total + at, sum, vl);
    }
#define NEXT(k)    \
    if (count > k) \
    track_next(&t[k], turns && (k) == 0, __riscv_vmv_x_s_u16m1_u16(least_##k), 0, r->stride)
    NEXT(0);
    NEXT(1);
    NEXT(2);
    NEXT(3);
}

/* The whole run of `count` lanes, the first of two slots if it `turns`. */
INLINE void run_of(const stad_path_job *job, stad_lane *lanes, int count, int turns, enum total_use use)
{
    const run r = {(size_t)job->disparities, job->stride, (ptrdiff_t)job->step * job->disparities, (uint16_t)job->p1, job->p2};
    const uint16_t *block = (const uint16_t *)job->block;
    uint16_t *total = (uint16_t *)job->total;
    track t[4];
    for (int32_t left = job->count; left > 0;) {
        int32_t stretch = left;
#pragma GCC unroll 4
        for (int k = 0; k < count; k++)
            track_enter(&t[k], job, &lanes[k], turns && k == 0, &stretch);
        left -= stretch;
        for (int32_t i = stretch; i > 0; i--, block += r.to_next) {
            pixel(&r, block, total, t, count, turns, use);
            if (use != TOTAL_NONE)
                total += r.to_next;
        }
#pragma GCC unroll 4
        for (int k = 0; k < count; k++)
            track_leave(&t[k], &lanes[k], turns && k == 0, stretch);
    }
}

#define FORM(name, count, turns, use)                                                      \
    static __attribute__((noinline)) void name(const stad_path_job *job, stad_lane *lanes) \
    {                                                                                      \
        run_of(job, lanes, count, turns, use);                                             \
    }

#define FORMS(name, count, turns)                                           \
    FORM(name##_none, count, turns, TOTAL_NONE)                             \
    FORM(name##_fresh, count, turns, TOTAL_FRESH)                           \
    FORM(name##_add, count, turns, TOTAL_ADD)                               \
    static void name(const stad_path_job *job, stad_lane *lanes, int fresh) \
    {                                                                       \
        if (!job->total)                                                    \
            name##_none(job, lanes);                                        \
        else if (fresh)                                                     \
            name##_fresh(job, lanes);                                       \
        else                                                                \
            name##_add(job, lanes);                                         \
    }

FORMS(one, 1, 0)
FORMS(one_turning, 1, 1)
FORMS(two_turning, 2, 1)
FORMS(four_turning, 4, 1)

/* Takes the first lanes together, as many as there is a form for; returns how many. */
static int32_t take_lanes(const stad_path_job *job, stad_lane *lanes, int32_t count, int fresh)
{
    if (lanes[0].slots > 2) {
        one(job, lanes, fresh);
        return 1;
    }
    if (count >= 4) {
        four_turning(job, lanes, fresh);
        return 4;
    }
    if (count >= 2) {
        two_turning(job, lanes, fresh);
        return 2;
    }
    one_turning(job, lanes, fresh);
    return 1;
}

void stad_path_row_rvv(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
{
    for (int32_t k = 0; k < lane_count;)
        k += take_lanes(job, lanes + k, lane_count - k, job->fresh && k == 0);
}

void stad_gather_row_rvv(int16_t *total, const stad_lane *lane, int32_t slot, const stad_path_job *job)
{
    const size_t n = (size_t)job->disparities;
    size_t vl;
    for (int32_t i = 0; i < job->count; i++, total += n) {
        const int16_t *path = lane->cost + (ptrdiff_t)slot * job->stride;
        for (size_t at = 0; at < n; at += vl) {
            vl = __riscv_vsetvl_e16m8(n - at);
            const vint16m8_t more = __riscv_vle16_v_i16m8(path + at, vl);
            __riscv_vse16_v_i16m8(total + at, __riscv_vsadd_vv_i16m8(__riscv_vle16_v_i16m8(total + at, vl), more, vl), vl);
        }
        slot = slot + 1 == lane->slots ? 0 : slot + 1;
    }
}
