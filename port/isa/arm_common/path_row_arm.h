/* SPDX-License-Identifier: MIT
 * port/isa/arm_common/path_row_arm.h - template: the path kernel, VEC_ABREAST lanes at once, as many as registers hold.
 *
 * With all lanes unsigned and m the previous pixel's least cost, the recurrence of kernel/path_row.c is
 *     L = C - floor(delta - min(p[d], min(p[d-1], p[d+1]) + p1)),   delta = m + p2,   floor(v) = max(v, 0)
 * Bounds: costs, fences and p1 are at most 32767, so no unsigned sum wraps; delta is at most 32767 (path_row.c). Every L is
 * >= 0, so S may be summed in any order before it saturates. */

enum total_use { TOTAL_NONE, TOTAL_FRESH, TOTAL_ADD };

typedef struct walker {
    const int16_t *from;
    int16_t *to, *least_to;
    vec delta, least;
} walker;

#define ALWAYS_INLINE static inline __attribute__((always_inline))

ALWAYS_INLINE walker walk(const stad_path_job *job, stad_lane *lane)
{
    const int32_t to = lane->write, from = to + 1 == lane->slots ? 0 : to + 1;
    walker w = {lane->cost + (ptrdiff_t)from * job->stride, lane->cost + (ptrdiff_t)to * job->stride, lane->least + to,
                vec_set(lane->least[from] + job->p2), vec_set(STAD_COST_MAX)};
    lane->write = from;
    return w;
}

ALWAYS_INLINE vec step(walker *w, int32_t d, vec block, int32_t p1)
{
    const vec side = vec_add_scalar(vec_min_u16(vec_load(w->from + d - 1), vec_load(w->from + d + 1)), p1);
    const vec reach = vec_min_u16(vec_load(w->from + d), side);
    const vec path = vec_sub(block, vec_sub_floor(w->delta, reach));
    vec_store(w->to + d, path);
    w->least = vec_min_u16(w->least, path);
    return path;
}

/* One pixel of `count` <= VEC_ABREAST lanes; count and use are constants where it is inlined. */
ALWAYS_INLINE void pixel(const stad_path_job *job, const int16_t *block, int16_t *total, stad_lane *lanes, int count,
                         enum total_use use)
{
    const int32_t n = job->disparities, p1 = job->p1;
    walker w[VEC_ABREAST];
#pragma GCC unroll 4
    for (int k = 0; k < count; k++)
        w[k] = walk(job, &lanes[k]);
    for (int32_t d = 0; d < n; d += 8) {
        const vec cost = vec_load(block + d);
        vec sum = step(&w[0], d, cost, p1);
#pragma GCC unroll 4
        for (int k = 1; k < count; k++)
            sum = vec_add_sat(sum, step(&w[k], d, cost, p1));
        if (use == TOTAL_ADD)
            sum = vec_add_sat(sum, vec_load(total + d));
        if (use != TOTAL_NONE)
            vec_store(total + d, sum);
    }
#pragma GCC unroll 4
    for (int k = 0; k < count; k++)
        *w[k].least_to = (int16_t)vec_least(w[k].least);
}

ALWAYS_INLINE void run_of(const stad_path_job *job, stad_lane *lanes, int count, enum total_use first)
{
    const ptrdiff_t to_next = (ptrdiff_t)job->step * job->disparities;
    const enum total_use later = first == TOTAL_NONE ? TOTAL_NONE : TOTAL_ADD;
    const int one = count < VEC_ABREAST ? count : VEC_ABREAST;
    const int16_t *block = job->block;
    int16_t *total = job->total;
    for (int32_t i = 0; i < job->count; i++, block += to_next) {
        pixel(job, block, total, lanes, one, first);
        if (count > one)
            pixel(job, block, total, lanes + one, count - one, later);
        if (first != TOTAL_NONE)
            total += to_next;
    }
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
