/* SPDX-License-Identifier: MIT
 * port/isa/x86/path_row_x86.h - template: the path kernel, all lanes of a pixel abreast.
 *
 * The recurrence of kernel/path_row.c with one saturating operation (all lanes unsigned, C cannot saturate):
 *     L = C - floor(delta - min(p[d], min(p[d-1], p[d+1]) + p1)),   delta = m + p2, floor(v) = max(v, 0)
 * The horizontal lane reads what the pixel before has just stored: where vectors are wide its neighbours come by lane shifts
 * (VEC_SHIFT_ACROSS), because an unaligned load across two fresh stores would have to wait for both; where they are narrow the
 * stores are old by then. Its least value stays in a register for the same reason. The other lanes load their neighbours,
 * except where one permutation reaches across the whole vector (VEC_SHIFT_ALWAYS). */

enum total_use { TOTAL_NONE, TOTAL_FRESH, TOTAL_ADD };

/* Penalties in all lanes, the horizontal lane's least value so far, and D. */
typedef struct course {
    vec p1, p2, across_least;
    int32_t disparities, stride;
} course;

typedef struct walker {
    const int16_t *from;
    int16_t *to, *least_to;
    vec delta, least;
} walker;

static inline walker walk(const course *c, stad_lane *lane, int across)
{
    const int32_t to = lane->write, from = to + 1 == lane->slots ? 0 : to + 1;
    const vec delta = vec_add(across ? c->across_least : vec_set(lane->least[from]), c->p2);
    walker w = {lane->cost + (ptrdiff_t)from * c->stride, lane->cost + (ptrdiff_t)to * c->stride, lane->least + to, delta,
                vec_set(STAD_COST_MAX)};
    lane->write = from;
    return w;
}

static inline vec step(const course *c, walker *w, int32_t d, vec block, vec here, vec side)
{
    const vec reach = vec_min_u16(vec_add(side, c->p1), here);
    const vec path = vec_sub(block, vec_sub_floor(w->delta, reach));
    vec_store(w->to + d, path);
    w->least = vec_min(w->least, path);
    return path;
}

static inline vec step_loaded(const course *c, walker *w, int32_t d, vec block)
{
    const vec side = vec_min(vec_load(w->from + d - 1), vec_load(w->from + d + 1));
    return step(c, w, d, block, vec_load(w->from + d), side);
}

static inline void put_total(int16_t *total, int32_t d, vec sum, enum total_use use)
{
    if (use == TOTAL_ADD)
        sum = vec_add_sat(sum, vec_load(total + d));
    if (use != TOTAL_NONE)
        vec_store(total + d, sum);
}

/* A lane read vector by vector: what lies before the current vector, and what joins them. */
typedef struct reader {
    vec before, here;
    vec_seam left;
} reader;

static inline reader read_from(const walker *w)
{
    const vec before = vec_set(STAD_COST_MAX), here = vec_load(w->from);
    reader r = {before, here, vec_join(before, here)};
    return r;
}

static inline vec vector_after(const course *c, const walker *w, int32_t d)
{
    return d + VEC_LANES < c->disparities ? vec_load(w->from + d + VEC_LANES) : vec_set(STAD_COST_MAX);
}

static inline vec step_shifted(const course *c, walker *w, reader *r, int32_t d, vec block, vec after)
{
    const vec_seam right = vec_join(r->here, after);
    const vec side = vec_min(vec_behind(r->left, r->before, r->here), vec_ahead(r->here, after, right));
    const vec path = step(c, w, d, block, r->here, side);
    r->left = right;
    r->before = r->here;
    r->here = after;
    return path;
}

/* One pixel of all lanes; `across`: the first is the horizontal one. Count and flags are constants where it is inlined. */
static inline __attribute__((always_inline)) void pixel(course *c, const int16_t *block, int16_t *total, stad_lane *lanes,
                                                        int count, int across, enum total_use use)
{
    const int32_t n = c->disparities;
    walker w[4];
    reader r[4];
#pragma GCC unroll 4
    for (int i = 0; i < count; i++) {
        w[i] = walk(c, &lanes[i], across && i == 0);
        r[i] = read_from(&w[i]);
    }
#pragma GCC unroll 2 /* gcc by itself copies registers about at every turn */
    for (int32_t d = 0; d < n; d += VEC_LANES) {
        const vec cost = vec_load(block + d);
        vec sum = vec_set(0);
#pragma GCC unroll 4
        for (int i = 0; i < count; i++) {
            const int by_shift = VEC_SHIFT_ALWAYS || (VEC_SHIFT_ACROSS && across && i == 0);
            const vec path =
                by_shift ? step_shifted(c, &w[i], &r[i], d, cost, vector_after(c, &w[i], d)) : step_loaded(c, &w[i], d, cost);
            sum = i == 0 || use == TOTAL_NONE ? path : vec_add_sat(sum, path);
        }
        put_total(total, d, sum, use);
    }
    if (across)
        c->across_least = vec_spread_least(w[0].least);
#pragma GCC unroll 4
    for (int i = 0; i < count; i++)
        *w[i].least_to = (int16_t)vec_least(w[i].least);
}

static inline __attribute__((always_inline)) void run_of(const stad_path_job *job, stad_lane *lanes, int32_t count, int across,
                                                         enum total_use use)
{
    const ptrdiff_t to_next = (ptrdiff_t)job->step * job->disparities;
    course c = {vec_set(job->p1), vec_set(job->p2), vec_set(0), job->disparities, job->stride};
    const int16_t *block = job->block;
    int16_t *total = job->total;
    if (across)
        c.across_least = vec_set(lanes[0].least[1 - lanes[0].write]);
    for (int32_t i = 0; i < job->count; i++, block += to_next) {
        pixel(&c, block, total, lanes, count, across, use);
        if (use != TOTAL_NONE)
            total += to_next;
    }
}

#define STAD_RUN_OF(count, across)                          \
    do {                                                    \
        if (!job->total)                                    \
            run_of(job, lanes, count, across, TOTAL_NONE);  \
        else if (job->fresh)                                \
            run_of(job, lanes, count, across, TOTAL_FRESH); \
        else                                                \
            run_of(job, lanes, count, across, TOTAL_ADD);   \
    } while (0)

void STAD_TIER(stad_path_row)(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
{
    const int across = lanes[0].slots == 2;
    switch (lane_count * 2 + across) {
    case 2:
        STAD_RUN_OF(1, 0);
        break;
    case 3:
        STAD_RUN_OF(1, 1);
        break;
    case 4:
        STAD_RUN_OF(2, 0);
        break;
    case 5:
        STAD_RUN_OF(2, 1);
        break;
    case 6:
        STAD_RUN_OF(3, 0);
        break;
    case 7:
        STAD_RUN_OF(3, 1);
        break;
    case 8:
        STAD_RUN_OF(4, 0);
        break;
    default:
        STAD_RUN_OF(4, 1);
        break;
    }
}

void STAD_TIER(stad_gather_row)(int16_t *total, const stad_lane *lane, int32_t slot, const stad_path_job *job)
{
    const int32_t n = job->disparities;
    for (int32_t i = 0; i < job->count; i++, total += n) {
        const int16_t *path = lane->cost + (ptrdiff_t)slot * job->stride;
        for (int32_t d = 0; d < n; d += VEC_LANES)
            vec_store(total + d, vec_add_sat(vec_load(total + d), vec_load(path + d)));
        slot = slot + 1 == lane->slots ? 0 : slot + 1;
    }
}
