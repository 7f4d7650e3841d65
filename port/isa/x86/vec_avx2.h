/* SPDX-License-Identifier: MIT
 * port/isa/x86/vec_avx2.h - the vector verbs of the templates, 16 lanes of 16 bits. */
#ifndef STAD_VEC_H
#define STAD_VEC_H

#include <immintrin.h>
#include <stdint.h>

#define STAD_TIER(name)  name##_avx2
#define VEC_LANES        16
#define VEC_SHIFT_ALWAYS 0
#define VEC_SHIFT_ACROSS 1

typedef __m256i vec;

static inline vec vec_load(const void *p)
{
    return _mm256_loadu_si256((const __m256i *)p);
}

static inline void vec_store(void *p, vec v)
{
    _mm256_storeu_si256((__m256i *)p, v);
}

/* VEC_LANES bytes as 16-bit lanes. */
static inline vec vec_widen(const uint8_t *p)
{
    return _mm256_cvtepu8_epi16(_mm_loadu_si128((const __m128i *)(const void *)p));
}

static inline vec vec_set(int v)
{
    return _mm256_set1_epi16((short)v);
}

#define vec_set_u8(v)          _mm256_set1_epi8((char)(v))
#define vec_min(a, b)          _mm256_min_epi16(a, b)
#define vec_min_u16(a, b)      _mm256_min_epu16(a, b)
#define vec_max(a, b)          _mm256_max_epi16(a, b)
#define vec_add(a, b)          _mm256_add_epi16(a, b)
#define vec_sub(a, b)          _mm256_sub_epi16(a, b)
#define vec_mul(a, b)          _mm256_mullo_epi16(a, b)
#define vec_add_sat(a, b)      _mm256_adds_epi16(a, b)
#define vec_sub_floor(a, b)    _mm256_subs_epu16(a, b) /* max(a - b, 0) for lanes read as unsigned */
#define vec_and(a, b)          _mm256_and_si256(a, b)
#define vec_shift_right(a, n)  _mm256_srli_epi16(a, n)
#define vec_min_u8(a, b)       _mm256_min_epu8(a, b)
#define vec_max_u8(a, b)       _mm256_max_epu8(a, b)
#define vec_add_u8(a, b)       _mm256_add_epi8(a, b)
#define vec_sub_floor_u8(a, b) _mm256_subs_epu8(a, b)
#define vec_mean_up_u8(a, b)   _mm256_avg_epu8(a, b)
#define vec_xor(a, b)          _mm256_xor_si256(a, b)

/* The lane before each lane of `here`, its first lane the last of the vector before, and the mirror image. A seam is the
 * upper half of one vector and the lower half of the next: both shifts across it share it. */
typedef vec vec_seam;
#define vec_join(here, after)          _mm256_permute2x128_si256(here, after, 0x21)
#define vec_behind(seam, before, here) _mm256_alignr_epi8(here, seam, 14)
#define vec_ahead(here, after, seam)   _mm256_alignr_epi8(seam, here, 2)

/* Bytes in reverse order. */
static inline vec vec_reverse_u8(vec v)
{
    const __m256i within = _mm256_set_epi8(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10,
                                           11, 12, 13, 14, 15);
    const __m256i turned = _mm256_shuffle_epi8(v, within);
    return _mm256_permute2x128_si256(turned, turned, 1);
}

/* The least lane, all lanes >= 0. */
static inline int vec_least(vec v)
{
    const __m128i half = _mm_min_epi16(_mm256_castsi256_si128(v), _mm256_extracti128_si256(v, 1));
    return _mm_extract_epi16(_mm_minpos_epu16(half), 0);
}

/* The least lane in all lanes; all >= 0. */
static inline vec vec_spread_least(vec v)
{
    const __m128i half = _mm_min_epi16(_mm256_castsi256_si128(v), _mm256_extracti128_si256(v, 1));
    return _mm256_broadcastw_epi16(_mm_minpos_epu16(half));
}

/* The least lane, of either sign. */
static inline int vec_least_signed(vec v)
{
    const __m128i low = _mm_min_epi16(_mm256_castsi256_si128(v), _mm256_extracti128_si256(v, 1));
    const __m128i half = _mm_xor_si128(low, _mm_set1_epi16(INT16_MIN));
    return _mm_extract_epi16(_mm_minpos_epu16(half), 0) + INT16_MIN;
}

/* One bit a lane of two vectors, the first one's low: is it equal to `wanted`? */
static inline uint64_t vec_equal_bits(vec a, vec b, vec wanted)
{
    const vec both = _mm256_packs_epi16(_mm256_cmpeq_epi16(a, wanted), _mm256_cmpeq_epi16(b, wanted));
    return (uint32_t)_mm256_movemask_epi8(_mm256_permute4x64_epi64(both, 0xD8));
}

/* Two vectors of 16-bit lanes <= 255 to bytes, in order. */
#define vec_narrow(a, b) _mm256_permute4x64_epi64(_mm256_packus_epi16(a, b), 0xD8)

/* The lower and the upper bytes of v as 16-bit lanes. */
#define vec_low_half(v)  _mm256_cvtepu8_epi16(_mm256_castsi256_si128(v))
#define vec_high_half(v) _mm256_cvtepu8_epi16(_mm256_extracti128_si256(v, 1))

#endif
