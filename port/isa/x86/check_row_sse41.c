/* SPDX-License-Identifier: MIT
 * select -> [CHECK] -> median
 * port/isa/x86/check_row_sse41.c - left-right consistency of eight pixels at once.
 *
 * The two right pixels that a disparity may mean are the same or neighbours, so one reading of two votes serves both. Bounds:
 * columns and disparities within REACH keep every difference in 16 bits; what is larger is left to C. */
#include <smmintrin.h>
#include <string.h>

#include "kernel/kernel.h"

#define REACH 28000

static inline __m128i load(const void *p)
{
    return _mm_loadu_si128((const __m128i *)p);
}

/* The votes at a column and the one after it, of four columns. */
static inline __m128i votes_at(const int16_t *votes, int64_t columns)
{
    int32_t pair[4];
    for (int k = 0; k < 4; k++, columns >>= 16)
        memcpy(&pair[k], votes + (uint16_t)columns, sizeof pair[k]);
    return _mm_set_epi32(pair[3], pair[2], pair[1], pair[0]);
}

/* All ones where this vote is none or near enough. */
static inline __m128i agrees(const stad_check_job *job, __m128i vote, __m128i disparity)
{
    const __m128i apart = _mm_abs_epi16(_mm_sub_epi16(vote, disparity));
    return _mm_or_si128(_mm_cmplt_epi16(vote, _mm_set1_epi16((int16_t)job->min_disparity)),
                        _mm_cmplt_epi16(apart, _mm_set1_epi16((int16_t)(job->max_diff + 1))));
}

/* Which of the eight pixels from column x on fail, as all ones. */
static inline __m128i failing(const stad_check_job *job, int32_t x, __m128i disp, __m128i none)
{
    const __m128i first = _mm_srai_epi16(disp, 4),
                  columns = _mm_add_epi16(_mm_set1_epi16((int16_t)x), _mm_setr_epi16(0, 1, 2, 3, 4, 5, 6, 7));
    const __m128i whole = _mm_cmpeq_epi16(_mm_and_si128(disp, _mm_set1_epi16(15)), _mm_setzero_si128());
    const __m128i second = _mm_add_epi16(first, _mm_andnot_si128(whole, _mm_set1_epi16(1)));
    const __m128i right = _mm_sub_epi16(columns, first), last = _mm_sub_epi16(columns, second);
    const __m128i below = _mm_max_epi16(
        _mm_min_epi16(_mm_sub_epi16(right, _mm_set1_epi16(1)), _mm_set1_epi16((int16_t)(job->width - 2))), _mm_setzero_si128());
    const __m128i a = votes_at(job->vote_disp, _mm_cvtsi128_si64(below)),
                  b = votes_at(job->vote_disp, _mm_extract_epi64(below, 1));
    const __m128i low = _mm_packs_epi32(_mm_srai_epi32(_mm_slli_epi32(a, 16), 16), _mm_srai_epi32(_mm_slli_epi32(b, 16), 16));
    const __m128i high = _mm_packs_epi32(_mm_srai_epi32(a, 16), _mm_srai_epi32(b, 16));
    const __m128i vote = _mm_blendv_epi8(high, low, _mm_cmpeq_epi16(right, _mm_setzero_si128()));
    const __m128i other = _mm_blendv_epi8(low, vote, whole);
    const __m128i outside = _mm_or_si128(_mm_cmplt_epi16(last, _mm_setzero_si128()),
                                         _mm_cmpgt_epi16(right, _mm_set1_epi16((int16_t)(job->width - 1))));
    const __m128i kept = _mm_or_si128(_mm_or_si128(agrees(job, vote, first), agrees(job, other, second)), outside);
    return _mm_andnot_si128(_mm_or_si128(kept, _mm_cmpeq_epi16(disp, none)), _mm_set1_epi16(-1));
}

int32_t stad_check_row_sse41(const stad_check_job *job)
{
    const int fits = job->width >= 2 && job->width <= REACH && job->max_diff >= 0 && job->max_diff <= REACH;
    const __m128i none = _mm_set1_epi16((int16_t)((job->min_disparity - 1) * 16));
    stad_check_job rest = *job;
    int32_t rejected = 0;
    for (; fits && rest.x0 + 8 <= job->x1; rest.x0 += 8) {
        int16_t *at = job->disp + rest.x0;
        const __m128i disp = load(at), fails = failing(job, rest.x0, disp, none);
        _mm_storeu_si128((__m128i *)(void *)at, _mm_blendv_epi8(disp, none, fails));
        rejected += __builtin_popcount((unsigned)_mm_movemask_epi8(fails)) / 2;
    }
    return rejected + stad_check_row_c(&rest);
}
