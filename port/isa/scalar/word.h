/* SPDX-License-Identifier: MIT
 * port/isa/scalar/word.h - two 16-bit lanes of a 32-bit word with ordinary instructions, for cores without any SIMD.
 *
 * Sums and differences whose every lane stays in 0..65535 carry nothing into the other lane: plain + and - do. */
#ifndef STAD_WORD_H
#define STAD_WORD_H

#include <stdint.h>

typedef uint32_t __attribute__((may_alias)) word;

#define WORD_INLINE static inline __attribute__((always_inline))
#define WORD_TOPS   0x80008000u

/* The two lanes of value v. */
WORD_INLINE word word_set(int32_t v)
{
    return (word)v * 0x10001u;
}

/* v > 0 ? v : 0, without a branch. */
WORD_INLINE int32_t floor_i32(int32_t v)
{
#if defined(__ARM_FEATURE_SAT)
    int32_t floor;
    __asm__("usat %0, #31, %1" : "=r"(floor) : "r"(v));
    return floor;
#else
    return v & ~(v >> 31);
#endif
}

#endif
