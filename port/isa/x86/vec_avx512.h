/* SPDX-License-Identifier: MIT
 * port/isa/x86/vec_avx512.h - the vector verbs of the templates, 32 lanes of 16 bits (AVX-512 F and BW). */
#ifndef STAD_VEC_H
#define STAD_VEC_H

#include <immintrin.h>
#include <stdint.h>

#define STAD_TIER(name)  name##_avx512
#define VEC_LANES        32
#define VEC_SHIFT_ALWAYS 1
#define VEC_SHIFT_ACROSS 1

typedef __m512i vec;

static inline vec vec_load(const void *p)
{
    return _mm512_loadu_si512(p);
}

static inline void vec_store(void *p, vec v)
{
    _mm512_storeu_si512(p, v);
}

/* VEC_LANES bytes as 16-bit lanes. */
static inline vec vec_widen(const uint8_t *p)
{
    return _mm512_cvtepu8_epi16(_mm256_loadu_si256((const __m256i *)(const void *)p));
}

static inline vec vec_set(int v)
{
    return _mm512_set1_epi16((short)v);
}

#define vec_set_u8(v)          _mm512_set1_epi8((char)(v))
#define vec_min(a, b)          _mm512_min_epi16(a, b)
#define vec_min_u16(a, b)      _mm512_min_epu16(a, b)
#define vec_max(a, b)          _mm512_max_epi16(a, b)
#define vec_add(a, b)          _mm512_add_epi16(a, b)
#define vec_sub(a, b)          _mm512_sub_epi16(a, b)
#define vec_mul(a, b)          _mm512_mullo_epi16(a, b)
#define vec_add_sat(a, b)      _mm512_adds_epi16(a, b)
#define vec_sub_floor(a, b)    _mm512_subs_epu16(a, b) /* max(a - b, 0) for lanes read as unsigned */
#define vec_and(a, b)          _mm512_and_si512(a, b)
#define vec_xor(a, b)          _mm512_xor_si512(a, b)
#define vec_shift_right(a, n)  _mm512_srli_epi16(a, n)
#define vec_min_u8(a, b)       _mm512_min_epu8(a, b)
#define vec_max_u8(a, b)       _mm512_max_epu8(a, b)
#define vec_add_u8(a, b)       _mm512_add_epi8(a, b)
#define vec_sub_floor_u8(a, b) _mm512_subs_epu8(a, b)
#define vec_mean_up_u8(a, b)   _mm512_avg_epu8(a, b)

/* The lane before each lane of `here`, its first lane the last of the vector before, and the mirror image; one permutation
 * crosses everything, so a seam is nothing. */
typedef int vec_seam;
#define vec_join(here, after) 0

static inline vec lanes_up_from(int first)
{
    const __m512i count = _mm512_set_epi16(31, 30, 29, 28, 27, 26, 25, 24, 23, 22, 21, 20, 19, 18, 17, 16, 15, 14, 13, 12, 11, 10,
                                           9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
    return _mm512_add_epi16(count, _mm512_set1_epi16((short)first));
}

#define vec_behind(seam, before, here) ((void)(seam), _mm512_permutex2var_epi16(before, lanes_up_from(31), here))
#define vec_ahead(here, after, seam)   ((void)(seam), _mm512_permutex2var_epi16(here, lanes_up_from(1), after))

/* Bytes in reverse order. */
static inline vec vec_reverse_u8(vec v)
{
    const __m128i within = _mm_set_epi8(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    const __m512i turned = _mm512_shuffle_epi8(v, _mm512_broadcast_i32x4(within));
    return _mm512_shuffle_i64x2(turned, turned, 0x1B);
}

static inline __m128i least_of_eight(vec v)
{
    const __m256i half = _mm256_min_epi16(_mm512_castsi512_si256(v), _mm512_extracti64x4_epi64(v, 1));
    return _mm_min_epi16(_mm256_castsi256_si128(half), _mm256_extracti128_si256(half, 1));
}

/* The least lane, all lanes >= 0. */
static inline int vec_least(vec v)
{
    return _mm_extract_epi16(_mm_minpos_epu16(least_of_eight(v)), 0);
}

/* The least lane in all lanes; all >= 0. */
static inline vec vec_spread_least(vec v)
{
    return _mm512_broadcastw_epi16(_mm_minpos_epu16(least_of_eight(v)));
}

/* The least lane, of either sign. */
static inline int vec_least_signed(vec v)
{
    const __m128i biased = _mm_xor_si128(least_of_eight(v), _mm_set1_epi16(INT16_MIN));
    return _mm_extract_epi16(_mm_minpos_epu16(biased), 0) + INT16_MIN;
}

/* One bit a lane of two vectors, the first one's low: is it equal to `wanted`? */
static inline uint64_t vec_equal_bits(vec a, vec b, vec wanted)
{
    return (uint64_t)_mm512_cmpeq_epi16_mask(a, wanted) | (uint64_t)_mm512_cmpeq_epi16_mask(b, wanted) << 32;
}

/* Two vectors of 16-bit lanes <= 255 to bytes, in order. */
static inline vec vec_narrow(vec a, vec b)
{
    return _mm512_inserti64x4(_mm512_castsi256_si512(_mm512_cvtepi16_epi8(a)), _mm512_cvtepi16_epi8(b), 1);
}

/* The lower and the upper bytes of v as 16-bit lanes. */
#define vec_low_half(v)  _mm512_cvtepu8_epi16(_mm512_castsi512_si256(v))
#define vec_high_half(v) _mm512_cvtepu8_epi16(_mm512_extracti64x4_epi64(v, 1))

#endif
