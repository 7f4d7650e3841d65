/* SPDX-License-Identifier: MIT
 * port/isa/x86/vec_sse41.h - the vector verbs of the templates, 8 lanes of 16 bits. */
#ifndef STAD_VEC_H
#define STAD_VEC_H

#include <smmintrin.h>
#include <stdint.h>

#define STAD_TIER(name)  name##_sse41
#define VEC_LANES        8
#define VEC_SHIFT_ALWAYS 0
#define VEC_SHIFT_ACROSS 0

typedef __m128i vec;

static inline vec vec_load(const void *p)
{
    return _mm_loadu_si128((const __m128i *)p);
}

static inline void vec_store(void *p, vec v)
{
    _mm_storeu_si128((__m128i *)p, v);
}

/* VEC_LANES bytes as 16-bit lanes. */
static inline vec vec_widen(const uint8_t *p)
{
    return _mm_cvtepu8_epi16(_mm_loadl_epi64((const __m128i *)(const void *)p));
}

static inline vec vec_set(int v)
{
    return _mm_set1_epi16((short)v);
}

#define vec_set_u8(v)          _mm_set1_epi8((char)(v))
#define vec_min(a, b)          _mm_min_epi16(a, b)
#define vec_min_u16(a, b)      _mm_min_epu16(a, b)
#define vec_max(a, b)          _mm_max_epi16(a, b)
#define vec_add(a, b)          _mm_add_epi16(a, b)
#define vec_sub(a, b)          _mm_sub_epi16(a, b)
#define vec_mul(a, b)          _mm_mullo_epi16(a, b)
#define vec_add_sat(a, b)      _mm_adds_epi16(a, b)
#define vec_sub_floor(a, b)    _mm_subs_epu16(a, b) /* max(a - b, 0) for lanes read as unsigned */
#define vec_and(a, b)          _mm_and_si128(a, b)
#define vec_shift_right(a, n)  _mm_srli_epi16(a, n)
#define vec_min_u8(a, b)       _mm_min_epu8(a, b)
#define vec_max_u8(a, b)       _mm_max_epu8(a, b)
#define vec_add_u8(a, b)       _mm_add_epi8(a, b)
#define vec_sub_floor_u8(a, b) _mm_subs_epu8(a, b)
#define vec_mean_up_u8(a, b)   _mm_avg_epu8(a, b)
#define vec_xor(a, b)          _mm_xor_si128(a, b)

/* The lane before each lane of `here`, its first lane the last of the vector before, and the mirror image. A seam is what
 * wider vectors need to shift across their middle: nothing here. */
typedef int vec_seam;
#define vec_join(here, after)          0
#define vec_behind(seam, before, here) ((void)(seam), _mm_alignr_epi8(here, before, 14))
#define vec_ahead(here, after, seam)   ((void)(seam), _mm_alignr_epi8(after, here, 2))

/* Bytes in reverse order. */
static inline vec vec_reverse_u8(vec v)
{
    return _mm_shuffle_epi8(v, _mm_set_epi8(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
}

/* The least lane, all lanes >= 0. */
static inline int vec_least(vec v)
{
    return _mm_extract_epi16(_mm_minpos_epu16(v), 0);
}

/* The least lane in all lanes; all >= 0. */
static inline vec vec_spread_least(vec v)
{
    return _mm_shuffle_epi8(_mm_minpos_epu16(v), _mm_set1_epi16(0x0100));
}

/* The least lane, of either sign. */
static inline int vec_least_signed(vec v)
{
    const __m128i half = _mm_xor_si128(v, _mm_set1_epi16(INT16_MIN));
    return _mm_extract_epi16(_mm_minpos_epu16(half), 0) + INT16_MIN;
}

/* One bit a lane of two vectors, the first one's low: is it equal to `wanted`? */
static inline uint64_t vec_equal_bits(vec a, vec b, vec wanted)
{
    return (uint32_t)_mm_movemask_epi8(_mm_packs_epi16(_mm_cmpeq_epi16(a, wanted), _mm_cmpeq_epi16(b, wanted)));
}

/* Two vectors of 16-bit lanes <= 255 to bytes, in order. */
#define vec_narrow(a, b) _mm_packus_epi16(a, b)

/* The lower and the upper bytes of v as 16-bit lanes. */
#define vec_low_half(v)  _mm_cvtepu8_epi16(v)
#define vec_high_half(v) _mm_unpackhi_epi8(v, _mm_setzero_si128())

#endif
