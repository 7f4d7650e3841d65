/* SPDX-License-Identifier: MIT
 * port/isa/x86/path_row_x86.h - template: the path kernel, two lanes abreast (a third would spill registers).
 *
 * The recurrence of kernel/path_row.c in one vector operation less (all lanes unsigned, C cannot saturate):
 *     L = C - max(floor(delta - p), floor(delta - p1 - min(p[d-1], p[d+1]))),   delta = m + p2, floor(v) = max(v, 0)
 * The horizontal lane reads what the pixel before has just stored: its neighbours come by lane shifts, because an unaligned
 * load across two fresh stores would have to wait for both. */

enum total_use { TOTAL_NONE, TOTAL_FRESH, TOTAL_ADD };

typedef struct walker {
    const int16_t *from;
    int16_t *to, *least_to;
    vec delta, ceiling, least;
} walker;

static inline walker walk(const stad_path_job *job, stad_lane *lane)
{
    const int32_t to = lane->write, from = to + 1 == lane->slots ? 0 : to + 1;
    const int delta = lane->least[from] + job->p2;
    walker w = {lane->cost + (ptrdiff_t)from * job->stride, lane->cost + (ptrdiff_t)to * job->stride, lane->least + to,
                vec_set(delta), vec_set(delta - job->p1), vec_set(STAD_COST_MAX)};
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

static inline void leave(const walker *w)
{
    *w->least_to = (int16_t)vec_least(w->least);
}

static inline void put_total(int16_t *total, int32_t d, vec sum, enum total_use use)
{
    if (use == TOTAL_ADD)
        sum = vec_add_sat(sum, vec_load(total + d));
    if (use != TOTAL_NONE)
        vec_store(total + d, sum);
}

/* One pixel of one or two lanes; `shifted`: the first is the horizontal one. The flags are constants where it is inlined. */
static inline __attribute__((always_inline)) void pixel(const stad_path_job *job, const int16_t *block, int16_t *total,
                                                        stad_lane *lanes, int two, int shifted, enum total_use use)
{
    const int32_t n = job->disparities;
    walker a = walk(job, &lanes[0]), b = two ? walk(job, &lanes[1]) : a;
    vec before = vec_set(STAD_COST_MAX), here = vec_load(a.from);
    for (int32_t d = 0; d < n; d += VEC_LANES) {
        const vec c = vec_load(block + d);
        vec sum;
        if (shifted) {
            const vec after = d + VEC_LANES < n ? vec_load(a.from + d + VEC_LANES) : vec_set(STAD_COST_MAX);
            sum = step(&a, d, c, here, vec_min(vec_behind(before, here), vec_ahead(here, after)));
            before = here;
            here = after;
        } else {
            sum = step_loaded(&a, d, c);
        }
        if (two) {
            const vec other = step_loaded(&b, d, c);
            sum = use == TOTAL_NONE ? sum : vec_add_sat(sum, other);
        }
        put_total(total, d, sum, use);
    }
    leave(&a);
    if (two)
        leave(&b);
}

static inline __attribute__((always_inline)) void lanes_of_pixel(const stad_path_job *job, ptrdiff_t at, stad_lane *lanes,
                                                                 int32_t count, enum total_use first, enum total_use later)
{
    const int16_t *block = job->block + at;
    int16_t *total = first == TOTAL_NONE ? NULL : job->total + at;
    int32_t k = 0;
    if (lanes[0].slots == 2) {
        k = count > 1 ? 2 : 1;
        if (k == 2)
            pixel(job, block, total, lanes, 1, 1, first);
        else
            pixel(job, block, total, lanes, 0, 1, first);
    } else if (count > 1) {
        k = 2;
        pixel(job, block, total, lanes, 1, 0, first);
    } else {
        k = 1;
        pixel(job, block, total, lanes, 0, 0, first);
    }
    if (count - k == 2)
        pixel(job, block, total, lanes + k, 1, 0, later);
    else if (count - k == 1)
        pixel(job, block, total, lanes + k, 0, 0, later);
}

void STAD_TIER(stad_path_row)(const stad_path_job *job, stad_lane *lanes, int32_t lane_count)
{
    const ptrdiff_t step_cells = (ptrdiff_t)job->step * job->disparities;
    for (int32_t i = 0; i < job->count; i++) {
        if (!job->total)
            lanes_of_pixel(job, i * step_cells, lanes, lane_count, TOTAL_NONE, TOTAL_NONE);
        else if (job->fresh)
            lanes_of_pixel(job, i * step_cells, lanes, lane_count, TOTAL_FRESH, TOTAL_ADD);
        else
            lanes_of_pixel(job, i * step_cells, lanes, lane_count, TOTAL_ADD, TOTAL_ADD);
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
