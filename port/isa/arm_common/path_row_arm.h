/* SPDX-License-Identifier: MIT
 * port/isa/arm_common/path_row_arm.h - template: the path kernel, VEC_ABREAST lanes at once, as many as registers hold.
 *
 * With all lanes unsigned and m the previous pixel's least cost, the recurrence of kernel/path_row.c is
 *     L = C - floor(delta - min(p[d], min(p[d-1], p[d+1]) + p1)),   delta = m + p2,   floor(v) = max(v, 0)
 * Bounds: costs, fences and p1 are at most 32767, so no unsigned sum wraps; delta is at most 32767 (path_row.c). Every L is
 * >= 0, so S may be summed in any order before it saturates. */

#include "../common/lane_track.h"

enum total_use { TOTAL_NONE, TOTAL_FRESH, TOTAL_ADD };

#define ALWAYS_INLINE static inline __attribute__((always_inline))

/* What a run needs of its job, in registers: stores through vectors might alias the job itself. */
typedef struct run {
    int32_t p1, p2, groups;    /* of 32 disparities, or of 8 */
    ptrdiff_t stride, to_next; /* to_next: cells from a pixel's end to the next one, in block and total */
} run;

/* One pixel of a lane: m + p2, and the least cost so far. */
typedef struct state {
    vec_limit delta;
    vec least;
} state;

ALWAYS_INLINE void enter_pixel(state *s, const track *t, int turns, int32_t p2)
{
    s->delta = vec_limit_of(track_least(t, turns) + p2);
    s->least = vec_set(STAD_COST_MAX);
}

/* Eight disparities of a lane, the d-th and on; `first`: of its pixel. */
ALWAYS_INLINE vec step(state *s, const track *t, int32_t d, int first, vec cost, int32_t p1)
{
    const vec side = vec_add_scalar(vec_min_u16(vec_load(t->from + d - 1), vec_load(t->from + d + 1)), p1);
    const vec reach = vec_min_u16(vec_load(t->from + d), side);
    const vec path = vec_path(cost, reach, s->delta);
    vec_store(t->to + d, path);
    s->least = first ? path : vec_min_u16(s->least, path);
    return path;
}

/* Eight disparities of all lanes. */
ALWAYS_INLINE void eight(state *s, const track *t, int32_t d, int first, const int16_t *block, int16_t *total, int32_t p1,
                         int count, enum total_use use)
{
    const vec cost = vec_path_block(vec_load(block + d));
    vec sum = step(&s[0], &t[0], d, first, cost, p1);
#pragma GCC unroll 4
    for (int k = 1; k < count; k++)
        sum = vec_add_sat(sum, step(&s[k], &t[k], d, first, cost, p1));
    if (use == TOTAL_ADD)
        sum = vec_add_sat(sum, vec_load(total + d));
    if (use != TOTAL_NONE)
        vec_store(total + d, sum);
    VEC_IN_ORDER;
}

#if VEC_FOURS
/* Thirty-two disparities of a lane. */
ALWAYS_INLINE vec4 step_32(state *s, const track *t, int first, const vec4 *cost, int32_t p1)
{
    const vec4 below = vec4_load(t->from - 1), here = vec4_load(t->from), above = vec4_load(t->from + 1);
    vec4 path;
#    pragma GCC unroll 4
    for (int j = 0; j < 4; j++) {
        const vec side = vec_add_scalar(vec_min_u16(below.val[j], above.val[j]), p1);
        path.val[j] = vec_path(cost->val[j], vec_min_u16(here.val[j], side), s->delta);
        s->least = first && j == 0 ? path.val[j] : vec_min_u16(s->least, path.val[j]);
    }
    vec4_store(t->to, path);
    return path;
}

ALWAYS_INLINE void add_sat_32(vec4 *sum, vec4 more)
{
#    pragma GCC unroll 4
    for (int j = 0; j < 4; j++)
        sum->val[j] = vec_add_sat(sum->val[j], more.val[j]);
}

/* Thirty-two disparities of all lanes. */
ALWAYS_INLINE void thirty_two(state *s, const track *t, int first, const int16_t *block, int16_t *total, int32_t p1, int count,
                              enum total_use use)
{
    const vec4 cost = vec4_load(block);
    vec4 sum = step_32(&s[0], &t[0], first, &cost, p1);
#    pragma GCC unroll 4
    for (int k = 1; k < count; k++)
        add_sat_32(&sum, step_32(&s[k], &t[k], first, &cost, p1));
    if (use == TOTAL_ADD)
        add_sat_32(&sum, vec4_load(total));
    if (use != TOTAL_NONE)
        vec4_store(total, sum);
}
#endif

/* One pixel of `count` lanes: `groups` times `size` disparities, or `size` only. All but r, t, groups and the pointers are
 * constants. */
ALWAYS_INLINE void pixel(const run *r, const int16_t **block, int16_t **total, track *t, int count, int turns, int only,
                         int32_t groups, int32_t size, enum total_use use)
{
    state s[VEC_ABREAST];
#pragma GCC unroll 4
    for (int k = 0; k < count; k++)
        enter_pixel(&s[k], &t[k], turns && k == 0, r->p2);
    for (int32_t i = only ? 1 : groups; i > 0; i--) {
#if VEC_FOURS
        if (size == 32)
            thirty_two(s, t, only, *block, *total, r->p1, count, use);
        else
#endif
#pragma GCC unroll 4
            for (int32_t d = 0; d < size; d += 8)
                eight(s, t, d, only && d == 0, *block, *total, r->p1, count, use);
        *block += size;
        *total += use == TOTAL_NONE ? 0 : size;
#pragma GCC unroll 4
        for (int k = 0; k < count; k++) {
            t[k].from += size;
            t[k].to += size;
        }
    }
#pragma GCC unroll 4
    for (int k = 0; k < count; k++)
        track_next(&t[k], turns && k == 0, vec_least(s[k].least), only ? size : (ptrdiff_t)groups * size, r->stride);
    *block += r->to_next;
    *total += use == TOTAL_NONE ? 0 : r->to_next;
}

/* The whole run of `count` <= VEC_ABREAST lanes, the first of two slots if it `turns`; `only` `size` disparities. */
ALWAYS_INLINE void run_of(const stad_path_job *job, stad_lane *lanes, int count, int turns, int only, int32_t size,
                          enum total_use use)
{
    const int32_t n = only ? size : job->disparities;
    const run r = {job->p1, job->p2, n / size, job->stride, ((ptrdiff_t)job->step - 1) * n};
    const int16_t *block = job->block;
    int16_t *total = job->total;
    track t[VEC_ABREAST];
    for (int32_t left = job->count; left > 0;) {
        int32_t stretch = left;
#pragma GCC unroll 4
        for (int k = 0; k < count; k++)
            track_enter(&t[k], job, &lanes[k], turns && k == 0, &stretch);
        left -= stretch;
        for (int32_t i = stretch; i > 0; i--)
            pixel(&r, &block, &total, t, count, turns, only, r.groups, size, use);
#pragma GCC unroll 4
        for (int k = 0; k < count; k++)
            track_leave(&t[k], &lanes[k], turns && k == 0, stretch);
    }
}

/* Each form is a function of its own: compilers allot registers by function. */
#define FORM(name, count, turns, only, size, use)                                          \
    static __attribute__((noinline)) void name(const stad_path_job *job, stad_lane *lanes) \
    {                                                                                      \
        run_of(job, lanes, count, turns, only, size, use);                                 \
    }

/* Functions <name>_<use>: exactly 32 disparities, a multiple of 32, a multiple of 8. */
#define FORMS_OF_USE(name, count, turns, use)                    \
    FORM(name##_is_32, count, turns, 1, 32, use)                 \
    FORM(name##_by_32, count, turns, 0, 32, use)                 \
    FORM(name##_by_8, count, turns, 0, 8, use)                   \
    static void name(const stad_path_job *job, stad_lane *lanes) \
    {                                                            \
        if (job->disparities == 32)                              \
            name##_is_32(job, lanes);                            \
        else if (job->disparities % 32 == 0)                     \
            name##_by_32(job, lanes);                            \
        else                                                     \
            name##_by_8(job, lanes);                             \
    }

#define FORMS(name, count, turns)                                           \
    FORMS_OF_USE(name##_none, count, turns, TOTAL_NONE)                     \
    FORMS_OF_USE(name##_fresh, count, turns, TOTAL_FRESH)                   \
    FORMS_OF_USE(name##_add, count, turns, TOTAL_ADD)                       \
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
FORMS(two, 2, 0)
FORMS(two_turning, 2, 1)
#if VEC_ABREAST >= 4
FORMS(four_turning, 4, 1)
#endif

/* Takes the first lanes abreast, as many as there is a form for; returns how many. */
static int32_t take_lanes(const stad_path_job *job, stad_lane *lanes, int32_t count, int fresh)
{
    const int turns = lanes[0].slots == 2;
#if VEC_ABREAST >= 4
    if (turns && count >= 4) {
        four_turning(job, lanes, fresh);
        return 4;
    }
#endif
    if (count >= 2) {
        if (turns)
            two_turning(job, lanes, fresh);
        else
            two(job, lanes, fresh);
        return 2;
    }
    if (turns)
        one_turning(job, lanes, fresh);
    else
        one(job, lanes, fresh);
    return 1;
}

void STAD_TIER(stad_path_row)(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
{
    for (int32_t k = 0; k < lane_count;)
        k += take_lanes(job, lanes + k, lane_count - k, job->fresh && k == 0);
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
