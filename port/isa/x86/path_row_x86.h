/* SPDX-License-Identifier: MIT
 * port/isa/x86/path_row_x86.h - template: the path kernel, two lanes abreast (a third would spill registers).
 *
 * The recurrence of kernel/path_row.c in one vector operation less (all lanes unsigned, C cannot saturate):
 *     L = C - max(floor(delta - p), floor(delta - p1 - min(p[d-1], p[d+1]))),   delta = m + p2, floor(v) = max(v, 0)
 * The horizontal lane reads what the pixel before has just stored: its neighbours come by lane shifts, because an unaligned
 * load across two fresh stores would have to wait for both; its least value stays in a register for the same reason. The
 * other lanes load their neighbours, except where one permutation reaches across the whole vector (VEC_SHIFT_ALWAYS). */

enum total_use { TOTAL_NONE, TOTAL_FRESH, TOTAL_ADD };

/* Penalties in all lanes, the horizontal lane's least value so far, and D. */
typedef struct course {
    vec p1, p2, across_least;
    int32_t disparities, stride;
} course;

typedef struct walker {
    const int16_t *from;
    int16_t *to, *least_to;
    vec delta, ceiling, least;
} walker;

static inline walker walk(const course *c, stad_lane *lane, int shifted)
{
    const int32_t to = lane->write, from = to + 1 == lane->slots ? 0 : to + 1;
    const vec delta = vec_add(shifted ? c->across_least : vec_set(lane->least[from]), c->p2);
    walker w = {lane->cost + (ptrdiff_t)from * c->stride, lane->cost + (ptrdiff_t)to * c->stride, lane->least + to,
                delta, vec_sub(delta, c->p1), vec_set(STAD_COST_MAX)};
    lane->write = from;
    return w;
}

static inline vec step(walker *w, int32_t d, vec block, vec here, vec side)
{
    const vec gain = vec_max(vec_sub_floor(w->delta, here), vec_sub_floor(w->ceiling, side));
    const vec path = vec_sub(block, gain);
    vec_store(w->to + d, path);
    w->least = vec_min(w->least, path);
    return path;
}

static inline vec step_loaded(walker *w, int32_t d, vec block)
{
    const vec side = vec_min(vec_load(w->from + d - 1), vec_load(w->from + d + 1));
    return step(w, d, block, vec_load(w->from + d), side);
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

static inline vec step_shifted(walker *w, reader *r, int32_t d, int32_t n, vec block)
{
    const vec after = d + VEC_LANES < n ? vec_load(w->from + d + VEC_LANES) : vec_set(STAD_COST_MAX);
    const vec_seam right = vec_join(r->here, after);
    const vec side = vec_min(vec_behind(r->left, r->before, r->here), vec_ahead(r->here, after, right));
    const vec path = step(w, d, block, r->here, side);
    r->left = right;
    r->before = r->here;
    r->here = after;
    return path;
}

/* One pixel of one or two lanes; `shifted`: the first is the horizontal one. The flags are constants where it is inlined. */
static inline __attribute__((always_inline)) void pixel(course *c, const int16_t *block, int16_t *total, stad_lane *lanes,
                                                        int two, int shifted, enum total_use use)
{
    const int32_t n = c->disparities;
    walker a = walk(c, &lanes[0], shifted), b = two ? walk(c, &lanes[1], 0) : a;
    reader from_a = read_from(&a), from_b = read_from(&b);
#pragma GCC unroll 2 /* gcc by itself copies registers about at every turn */
    for (int32_t d = 0; d < n; d += VEC_LANES) {
        const vec cost = vec_load(block + d);
        vec sum = shifted || VEC_SHIFT_ALWAYS ? step_shifted(&a, &from_a, d, n, cost) : step_loaded(&a, d, cost);
        if (two) {
            const vec other = VEC_SHIFT_ALWAYS ? step_shifted(&b, &from_b, d, n, cost) : step_loaded(&b, d, cost);
            sum = use == TOTAL_NONE ? sum : vec_add_sat(sum, other);
        }
        put_total(total, d, sum, use);
    }
    if (shifted)
        c->across_least = vec_spread_least(a.least);
    *a.least_to = (int16_t)vec_least(a.least);
    if (two)
        *b.least_to = (int16_t)vec_least(b.least);
}

/* All lanes of one pixel: the horizontal one, if any, is the first (kernel.h). */
static inline __attribute__((always_inline)) void pixel_lanes(course *c, const int16_t *block, int16_t *total,
                                                              stad_lane *lanes, int32_t count, int shifted,
                                                              enum total_use first, enum total_use later)
{
    const int32_t pair = count > 1 ? 2 : 1;
    pixel(c, block, total, lanes, pair == 2, shifted, first);
    if (count > 2)
        pixel(c, block, total, lanes + 2, count == 4, 0, later);
}

static inline __attribute__((always_inline)) void run_of(const stad_path_job *job, stad_lane *lanes, int32_t count,
                                                         int shifted, enum total_use first, enum total_use later)
{
    const ptrdiff_t to_next = (ptrdiff_t)job->step * job->disparities;
    course c = {vec_set(job->p1), vec_set(job->p2), vec_set(0), job->disparities, job->stride};
    const int16_t *block = job->block;
    int16_t *total = job->total;
    if (shifted)
        c.across_least = vec_set(lanes[0].least[1 - lanes[0].write]);
    for (int32_t i = 0; i < job->count; i++, block += to_next) {
        pixel_lanes(&c, block, total, lanes, count, shifted, first, later);
        if (first != TOTAL_NONE)
            total += to_next;
    }
}

#define STAD_RUN_OF(count, shifted) \
    do { \
        if (!job->total) \
            run_of(job, lanes, count, shifted, TOTAL_NONE, TOTAL_NONE); \
        else if (job->fresh) \
            run_of(job, lanes, count, shifted, TOTAL_FRESH, TOTAL_ADD); \
        else \
            run_of(job, lanes, count, shifted, TOTAL_ADD, TOTAL_ADD); \
    } while (0)

void STAD_TIER(stad_path_row)(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
{
    const int shifted = lanes[0].slots == 2;
    switch (lane_count * 2 + shifted) {
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
