/* SPDX-License-Identifier: MIT
 * best -> [REFINE] -> select
 * port/isa/x86/refine_row_sse41.c - the sub-pixel places of four winners at once.
 *
 * The quotient is made of two integers below 2^24 and is at most 9 wherever it is kept, since no neighbour of the winner is
 * cheaper; what it lacks to the next integer is 2^-18 or more, so that a division in single precision, good to 2^-21 there,
 * cuts it to the same integer. */
#include <smmintrin.h>
#include <string.h>

#include "kernel/kernel.h"

/* The costs before, at and after a winner in the lower lanes; of one at an end of the range, some others. */
static inline __m128i around(const int16_t *total, int32_t index, int32_t disparities)
{
    const int32_t from = index - 1, last = disparities - 4, at = from < 0 ? 0 : from > last ? last : from;
    int64_t costs;
    memcpy(&costs, total + at, sizeof costs);
    return _mm_cvtsi64_si128(from > last ? costs >> 16 : costs);
}

/* 16 times the place of four winners, as int32. */
static inline __m128i refine_four(const int16_t *total, const stad_best *best, int32_t n)
{
    const __m128i a = _mm_unpacklo_epi16(around(total, best[0].index, n), around(total + n, best[1].index, n));
    const __m128i b = _mm_unpacklo_epi16(around(total + 2 * n, best[2].index, n), around(total + 3 * n, best[3].index, n));
    const __m128i both = _mm_unpacklo_epi32(a, b);
    const __m128i before = _mm_cvtepi16_epi32(both), at = _mm_cvtepi16_epi32(_mm_srli_si128(both, 8));
    const __m128i after = _mm_cvtepi16_epi32(_mm_unpackhi_epi32(a, b));
    const __m128i twice = _mm_sub_epi32(_mm_add_epi32(before, after), _mm_add_epi32(at, at));
    const __m128i curve = _mm_max_epi32(twice, _mm_set1_epi32(1));
    const __m128i rise = _mm_add_epi32(_mm_slli_epi32(_mm_sub_epi32(before, after), 4), curve);
    const __m128i moved = _mm_cvttps_epi32(_mm_div_ps(_mm_cvtepi32_ps(rise), _mm_cvtepi32_ps(_mm_add_epi32(curve, curve))));
    const __m128i index = _mm_set_epi32(best[3].index, best[2].index, best[1].index, best[0].index);
    const __m128i inside =
        _mm_and_si128(_mm_cmpgt_epi32(index, _mm_setzero_si128()), _mm_cmplt_epi32(index, _mm_set1_epi32(n - 1)));
    return _mm_add_epi32(_mm_slli_epi32(index, 4), _mm_and_si128(moved, inside));
}

void stad_refine_row_sse41(const int16_t *total, const stad_best *best, int32_t count, int32_t disparities, int16_t *fine)
{
    int32_t i = 0;
    for (; i + 4 <= count; i += 4) {
        const __m128i four = refine_four(total + (ptrdiff_t)i * disparities, best + i, disparities);
        _mm_storel_epi64((__m128i *)(void *)(fine + i), _mm_packs_epi32(four, four));
    }
    stad_refine_row_c(total + (ptrdiff_t)i * disparities, best + i, count - i, disparities, fine + i);
}
