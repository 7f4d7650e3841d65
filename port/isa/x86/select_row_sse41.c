/* SPDX-License-Identifier: MIT
 * refine -> [SELECT] -> check
 * port/isa/x86/select_row_sse41.c - uniqueness of eight winners at once, and their votes.
 *
 * Wider vectors bring nothing: votes are most of it. 3WAY's rule and confidences are left to C. Bounds: costs are int16, so
 * the difference of two products with up to 100 fits int32. */
#include <smmintrin.h>

#include "kernel/kernel.h"

/* Eight winners. */
typedef struct winners {
    __m128i index, least, runner_up;
} winners;

static inline __m128i load(const void *p)
{
    return _mm_loadu_si128((const __m128i *)p);
}

static inline void store(void *p, __m128i v)
{
    _mm_storeu_si128((__m128i *)p, v);
}

/* The lane of `order`'s place p goes to p. */
#define ARRANGE(v, a, b, c, d, e, f, g, h)                                                                                     \
    _mm_shuffle_epi8(v, _mm_set_epi8(2 * h + 1, 2 * h, 2 * g + 1, 2 * g, 2 * f + 1, 2 * f, 2 * e + 1, 2 * e, 2 * d + 1, 2 * d, \
                                     2 * c + 1, 2 * c, 2 * b + 1, 2 * b, 2 * a + 1, 2 * a))

/* A stad_best is three cells, so each field is in every third lane of three vectors. */
static inline winners take_winners(const stad_best *best)
{
    const int16_t *cell = &best->index;
    const __m128i a = load(cell), b = load(cell + 8), c = load(cell + 16);
    const __m128i index = _mm_blend_epi16(_mm_blend_epi16(a, b, 0x92), c, 0x24);
    const __m128i least = _mm_blend_epi16(_mm_blend_epi16(a, b, 0x24), c, 0x49);
    const __m128i runner_up = _mm_blend_epi16(_mm_blend_epi16(a, b, 0x49), c, 0x92);
    const winners w = {ARRANGE(index, 0, 3, 6, 1, 4, 7, 2, 5), ARRANGE(least, 1, 4, 7, 2, 5, 0, 3, 6),
                       ARRANGE(runner_up, 2, 5, 0, 3, 6, 1, 4, 7)};
    return w;
}

/* All ones where runner_up * rest < least * 100. */
static inline __m128i is_near(const winners *w, int rest)
{
    const __m128i by = _mm_set1_epi32((int)((uint32_t)-100 << 16 | (uint32_t)rest));
    const __m128i low = _mm_madd_epi16(_mm_unpacklo_epi16(w->runner_up, w->least), by);
    const __m128i high = _mm_madd_epi16(_mm_unpackhi_epi16(w->runner_up, w->least), by);
    return _mm_srai_epi16(_mm_packs_epi32(low, high), 15);
}

/* A winner's vote for the right view; x: its column of the image. Both values are stored either way, as C does. */
static inline void vote(const stad_select_job *job, int32_t index, int16_t least, int32_t x)
{
    const int32_t disparity = index + job->min_disparity, right = x - disparity;
    if ((uint32_t)right >= (uint32_t)job->width)
        return;
    const int16_t cost = job->vote_cost[right], held = job->vote_disp[right];
    job->vote_cost[right] = cost < least ? cost : least;
    job->vote_disp[right] = cost > least ? (int16_t)disparity : held;
}

/* Votes of eight winners from column x on; who may not vote comes with the highest cost. Winners of one disparity vote for
 * neighbours, and cannot meet. */
static inline void vote_all(const stad_select_job *job, const winners *w, const stad_best *best, int32_t x, __m128i least)
{
    const int32_t disparity = best->index + job->min_disparity, right = x - disparity;
    const __m128i first = _mm_set1_epi16(best->index);
    if (_mm_movemask_epi8(_mm_cmpeq_epi16(w->index, first)) == 0xFFFF && right >= 0 && right + 8 <= job->width) {
        int16_t *cost = job->vote_cost + right, *disp = job->vote_disp + right;
        const __m128i held = load(cost), wins = _mm_cmpgt_epi16(held, least);
        store(disp, _mm_blendv_epi8(load(disp), _mm_set1_epi16((int16_t)disparity), wins));
        store(cost, _mm_min_epi16(held, least));
        return;
    }
    int16_t each[8];
    store(each, least);
    for (int32_t k = 7; k >= 0; k--)
        vote(job, best[k].index, each[k], x + k);
}

static inline int32_t sum_of(__m128i v)
{
    int16_t each[8];
    int32_t sum = 0;
    store(each, v);
    for (int32_t k = 0; k < 8; k++)
        sum += each[k];
    return sum;
}

void stad_select_row_sse41(stad_select_job *shared)
{
    stad_select_job job = *shared;
    const __m128i shift = _mm_set1_epi16((int16_t)(16 * job.min_disparity)), most = _mm_set1_epi16(STAD_COST_MAX);
    __m128i weak = _mm_setzero_si128(), rejected = weak; /* counted downwards */
    for (; !job.floor_rule && !job.confidence && job.count >= 8; job.count -= 8) {
        const int32_t i = job.count - 8;
        const winners w = take_winners(job.best + i);
        const __m128i ambiguous = is_near(&w, 100 - job.uniqueness_ratio);
        int16_t *disp = job.disp + job.x + i;
        weak = _mm_add_epi16(weak, is_near(&w, 75));
        rejected = _mm_add_epi16(rejected, ambiguous);
        store(disp, _mm_blendv_epi8(_mm_add_epi16(load(job.fine + i), shift), load(disp), ambiguous));
        vote_all(&job, &w, job.best + i, job.x + i, _mm_blendv_epi8(w.least, most, ambiguous));
    }
    const int32_t taken = shared->count - job.count;
    stad_select_row_c(&job);
    shared->firm = job.firm + taken + sum_of(weak);
    shared->rejected = job.rejected - sum_of(rejected);
}
