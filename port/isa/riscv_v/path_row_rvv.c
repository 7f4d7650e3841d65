/* SPDX-License-Identifier: MIT
 * slide -> [PATH] -> best
 * port/isa/riscv_v/path_row_rvv.c - path costs, a strip of disparities at once, all lanes of a pixel in turn.
 *
 * With all lanes unsigned and m the previous pixel's least cost, the recurrence of kernel/path_row.c is
 *     L = C - delta + min(p[d], min(p[d-1], p[d+1]) + p1, delta),   delta = m + p2
 * Bounds: costs, fences and p1 are at most 32767, so no unsigned sum wraps; C >= p2 makes L >= 0 whatever wraps on the way. */
#include <riscv_vector.h>

#include "kernel/kernel.h"

enum total_use { TOTAL_NONE, TOTAL_FRESH, TOTAL_ADD };

#define INLINE static inline __attribute__((always_inline))

/* A lane's place: the slot read, the slot written, where the ring turns; m + p2, and the least cost so far. */
typedef struct track {
    uint16_t *base, *from, *to;
    int16_t *least_to, *least;
    int32_t slot, slots; /* slot read */
    uint16_t delta, least_cost;
} track;

INLINE track track_of(const stad_path_job *job, const stad_lane *lane)
{
    const int32_t to = lane->write, from = to + 1 == lane->slots ? 0 : to + 1;
    uint16_t *base = (uint16_t *)lane->cost;
    track t = {base, base + (ptrdiff_t)from * job->stride, base + (ptrdiff_t)to * job->stride, lane->least + to, lane->least,
               from, lane->slots, 0, 0};
    return t;
}

INLINE void leave(track *t, int32_t stride)
{
    *t->least_to = (int16_t)t->least_cost;
    t->to = t->from;
    t->least_to = t->least + t->slot;
    t->from += stride;
    if (++t->slot == t->slots) {
        t->slot = 0;
        t->from = t->base;
    }
}

INLINE vuint16m4_t step(track *t, vuint16m4_t block, size_t at, uint16_t p1, size_t vl)
{
    const vuint16m4_t below = __riscv_vle16_v_u16m4(t->from + at - 1, vl), above = __riscv_vle16_v_u16m4(t->from + at + 1, vl);
    const vuint16m4_t side = __riscv_vadd_vx_u16m4(__riscv_vminu_vv_u16m4(below, above, vl), p1, vl);
    const vuint16m4_t reach = __riscv_vminu_vv_u16m4(__riscv_vle16_v_u16m4(t->from + at, vl), side, vl);
    const vuint16m4_t gain = __riscv_vrsub_vx_u16m4(__riscv_vminu_vx_u16m4(reach, t->delta, vl), t->delta, vl);
    const vuint16m4_t path = __riscv_vsub_vv_u16m4(block, gain, vl);
    const vuint16m1_t start = __riscv_vmv_s_x_u16m1(t->least_cost, 1);
    __riscv_vse16_v_u16m4(t->to + at, path, vl);
    t->least_cost = __riscv_vmv_x_s_u16m1_u16(__riscv_vredminu_vs_u16m4_u16m1(path, start, vl));
    return path;
}

INLINE vuint16m4_t add_sat(vuint16m4_t a, vuint16m4_t b, size_t vl)
{
    const vint16m4_t sum =
        __riscv_vsadd_vv_i16m4(__riscv_vreinterpret_v_u16m4_i16m4(a), __riscv_vreinterpret_v_u16m4_i16m4(b), vl);
    return __riscv_vreinterpret_v_i16m4_u16m4(sum);
}

/* One pixel of `count` lanes; count and use are constants where it is inlined. */
INLINE void pixel(const stad_path_job *job, const uint16_t *block, uint16_t *total, track *t, int count, enum total_use use)
{
    const size_t n = (size_t)job->disparities;
    const uint16_t p1 = (uint16_t)job->p1;
    size_t vl;
#pragma GCC unroll 4
    for (int k = 0; k < count; k++) {
        t[k].delta = (uint16_t)(t[k].least[t[k].slot] + job->p2);
        t[k].least_cost = STAD_COST_MAX;
    }
    for (size_t at = 0; at < n; at += vl) {
        vl = __riscv_vsetvl_e16m4(n - at);
        const vuint16m4_t cost = __riscv_vle16_v_u16m4(block + at, vl);
        vuint16m4_t sum = step(&t[0], cost, at, p1, vl);
#pragma GCC unroll 4
        for (int k = 1; k < count; k++)
            sum = add_sat(sum, step(&t[k], cost, at, p1, vl), vl);
        if (use == TOTAL_ADD)
            sum = add_sat(sum, __riscv_vle16_v_u16m4(total + at, vl), vl);
        if (use != TOTAL_NONE)
            __riscv_vse16_v_u16m4(total + at, sum, vl);
    }
#pragma GCC unroll 4
    for (int k = 0; k < count; k++)
        leave(&t[k], job->stride);
}

INLINE void run_of(const stad_path_job *job, stad_lane *lanes, int count, enum total_use use)
{
    const ptrdiff_t to_next = (ptrdiff_t)job->step * job->disparities;
    const uint16_t *block = (const uint16_t *)job->block;
    uint16_t *total = (uint16_t *)job->total;
    track t[4];
#pragma GCC unroll 4
    for (int k = 0; k < count; k++)
        t[k] = track_of(job, &lanes[k]);
    for (int32_t i = 0; i < job->count; i++, block += to_next) {
        pixel(job, block, total, t, count, use);
        if (use != TOTAL_NONE)
            total += to_next;
    }
#pragma GCC unroll 4
    for (int k = 0; k < count; k++)
        lanes[k].write = (int32_t)(t[k].least_to - t[k].least);
}

#define RUN_OF(count) \
    do { \
        if (!job->total) \
            run_of(job, lanes, count, TOTAL_NONE); \
        else if (job->fresh) \
            run_of(job, lanes, count, TOTAL_FRESH); \
        else \
            run_of(job, lanes, count, TOTAL_ADD); \
    } while (0)

void stad_path_row_rvv(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
{
    switch (lane_count) {
    case 1:
        RUN_OF(1);
        break;
    case 2:
        RUN_OF(2);
        break;
    case 3:
        RUN_OF(3);
        break;
    default:
        RUN_OF(4);
        break;
    }
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
