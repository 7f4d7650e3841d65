/* SPDX-License-Identifier: MIT
 * port/isa/arm_common/path_row_arm.h - template: the path kernel, VEC_ABREAST lanes at once, as many as registers hold.
 *
 * With all lanes unsigned and m the previous pixel's least cost, the recurrence of kernel/path_row.c is
 *     L = C - floor(delta - min(p[d], min(p[d-1], p[d+1]) + p1)),   delta = m + p2,   floor(v) = max(v, 0)
 * Bounds: costs, fences and p1 are at most 32767, so no unsigned sum wraps; delta is at most 32767 (path_row.c). Every L is
 * >= 0, so S may be summed in any order before it saturates. */

enum total_use { TOTAL_NONE, TOTAL_FRESH, TOTAL_ADD };

/* A lane's place: the slot read, the slot written, and where the ring turns. */
typedef struct track {
    int16_t *base, *from, *to, *least;
    int32_t from_slot, to_slot, slots;
} track;

/* One pixel of a lane: m + p2 in all lanes, and the least cost so far. */
typedef struct state {
    vec delta, least;
} state;

#define ALWAYS_INLINE static inline __attribute__((always_inline))

ALWAYS_INLINE track track_of(const stad_path_job *job, const stad_lane *lane)
{
    const int32_t to = lane->write, from = to + 1 == lane->slots ? 0 : to + 1;
    track t = {lane->cost, lane->cost + (ptrdiff_t)from * job->stride, lane->cost + (ptrdiff_t)to * job->stride,
               lane->least, from, to, lane->slots};
    return t;
}

ALWAYS_INLINE void advance(track *t, int32_t stride)
{
    t->to = t->from;
    t->to_slot = t->from_slot++;
    t->from += stride;
    if (t->from_slot == t->slots) {
        t->from_slot = 0;
        t->from = t->base;
    }
}

/* Eight disparities of a lane; from and to point at the first of them. */
ALWAYS_INLINE vec step(state *s, const int16_t *from, int16_t *to, vec block, int32_t p1)
{
    const vec side = vec_add_scalar(vec_min_u16(vec_load(from - 1), vec_load(from + 1)), p1);
    const vec reach = vec_min_u16(vec_load(from), side);
    const vec path = vec_sub(block, vec_sub_floor(s->delta, reach));
    vec_store(to, path);
    s->least = vec_min_u16(s->least, path);
    return path;
}

/* Eight disparities of all lanes. */
ALWAYS_INLINE void eight(state *s, const track *t, int32_t d, const int16_t *block, int16_t *total, int32_t p1, int count,
                         enum total_use use)
{
    const vec cost = vec_load(block + d);
    vec sum = step(&s[0], t[0].from + d, t[0].to + d, cost, p1);
#pragma GCC unroll 4
    for (int k = 1; k < count; k++)
        sum = vec_add_sat(sum, step(&s[k], t[k].from + d, t[k].to + d, cost, p1));
    if (use == TOTAL_ADD)
        sum = vec_add_sat(sum, vec_load(total + d));
    if (use != TOTAL_NONE)
        vec_store(total + d, sum);
}

/* One pixel of `count` <= VEC_ABREAST lanes; count and use are constants where it is inlined. */
ALWAYS_INLINE void pixel(const stad_path_job *job, const int16_t *block, int16_t *total, track *t, int count,
                         enum total_use use)
{
    const int32_t n = job->disparities, p1 = job->p1;
    state s[VEC_ABREAST];
    int32_t d = 0;
#pragma GCC unroll 4
    for (int k = 0; k < count; k++) {
        s[k].delta = vec_set(t[k].least[t[k].from_slot] + job->p2);
        s[k].least = vec_set(STAD_COST_MAX);
    }
    for (; VEC_UNROLL && d + 16 <= n; d += 16) {
        eight(s, t, d, block, total, p1, count, use);
        eight(s, t, d + 8, block, total, p1, count, use);
    }
    for (; d < n; d += 8)
        eight(s, t, d, block, total, p1, count, use);
#pragma GCC unroll 4
    for (int k = 0; k < count; k++) {
        t[k].least[t[k].to_slot] = (int16_t)vec_least(s[k].least);
        advance(&t[k], job->stride);
    }
}

ALWAYS_INLINE void run_of(const stad_path_job *job, stad_lane *lanes, int count, enum total_use first)
{
    const ptrdiff_t to_next = (ptrdiff_t)job->step * job->disparities;
    const enum total_use later = first == TOTAL_NONE ? TOTAL_NONE : TOTAL_ADD;
    const int one = count < VEC_ABREAST ? count : VEC_ABREAST;
    const int16_t *block = job->block;
    int16_t *total = job->total;
    track t[4];
#pragma GCC unroll 4
    for (int k = 0; k < count; k++)
        t[k] = track_of(job, &lanes[k]);
    for (int32_t i = 0; i < job->count; i++, block += to_next) {
        pixel(job, block, total, t, one, first);
        if (count > one)
            pixel(job, block, total, t + one, count - one, later);
        if (first != TOTAL_NONE)
            total += to_next;
    }
#pragma GCC unroll 4
    for (int k = 0; k < count; k++)
        lanes[k].write = t[k].to_slot;
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

void STAD_TIER(stad_path_row)(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
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

void STAD_TIER(stad_gather_row)(int16_t *total, const stad_lane *lane, int32_t slot, const stad_path_job *job)
{
    const int32_t n = job->disparities;
    for (int32_t i = 0; i < job->count; i++, total += n) {
        const int16_t *path = lane->cost + (ptrdiff_t)slot * job->stride;
        for (int32_t d = 0; d < n; d += 8)
            vec_store(total + d, vec_add_sat(vec_load(total + d), vec_load(path + d)));
        slot = slot + 1 == lane->slots ? 0 : slot + 1;
    }
}
