/* SPDX-License-Identifier: MIT
 * port/isa/arm_dsp/pair_dsp.h - verbs on two 16-bit lanes or four bytes of a 32-bit register (Armv7E-M, Armv8-M DSP).
 *
 * Loads and stores may be unaligned: the cores that have these instructions allow it. */
#ifndef STAD_PAIR_DSP_H
#define STAD_PAIR_DSP_H

#include <arm_acle.h>
#include <stdint.h>

typedef uint32_t pair; /* the lane of the lower address in the lower half */
typedef uint32_t __attribute__((may_alias, aligned(1))) loose_pair;

#define PAIR_INLINE static inline __attribute__((always_inline))

PAIR_INLINE pair pair_load(const void *p)
{
    return *(const loose_pair *)p;
}

PAIR_INLINE void pair_store(void *p, pair v)
{
    *(loose_pair *)p = v;
}

/* Two pairs at once, from an address that is a multiple of 4: one LDRD or STRD, which gcc splits unless told. */
typedef uint64_t __attribute__((may_alias, aligned(4))) quad_memory;
typedef struct quad {
    pair low, high;
} quad;

PAIR_INLINE quad quad_load(const void *p)
{
    quad q;
#if defined(__clang__)
    const uint64_t v = *(const quad_memory *)p;
    q.low = (pair)v;
    q.high = (pair)(v >> 32);
#else
    __asm__("ldrd %0, %1, %2" : "=r"(q.low), "=r"(q.high) : "m"(*(const quad_memory *)p));
#endif
    return q;
}

PAIR_INLINE void quad_store(void *p, pair low, pair high)
{
#if defined(__clang__)
    *(quad_memory *)p = (uint64_t)high << 32 | low;
#else
    __asm__("strd %1, %2, %0" : "=m"(*(quad_memory *)p) : "r"(low), "r"(high));
#endif
}

/* The lower lanes of a and b; the upper ones. */
PAIR_INLINE pair pack_low(pair a, pair b)
{
    pair v;
    __asm__("pkhbt %0, %1, %2, lsl #16" : "=r"(v) : "r"(a), "r"(b));
    return v;
}

PAIR_INLINE pair pack_high(pair a, pair b)
{
    pair v;
    __asm__("pkhtb %0, %2, %1, asr #16" : "=r"(v) : "r"(a), "r"(b));
    return v;
}

PAIR_INLINE pair pair_set(int32_t v)
{
    return ((uint32_t)v & 0xFFFFu) * 0x10001u;
}

PAIR_INLINE pair bytes_set(uint32_t v)
{
    return v * 0x01010101u;
}

/* Bytes 0 and 2, and bytes 1 and 3, as 16-bit lanes. */
PAIR_INLINE pair even_bytes(pair v)
{
    return v & 0x00FF00FFu;
}

PAIR_INLINE pair odd_bytes(pair v)
{
    pair odd;
    __asm__("uxtb16 %0, %1, ror #8" : "=r"(odd) : "r"(v));
    return odd;
}

PAIR_INLINE pair pair_min_u16(pair a, pair b)
{
    (void)__usub16(a, b); /* sets GE where a >= b */
    return __sel(b, a);
}

PAIR_INLINE pair pair_min_i16(pair a, pair b)
{
    (void)__ssub16((int16x2_t)a, (int16x2_t)b);
    return __sel(b, a);
}

PAIR_INLINE pair pair_max_i16(pair a, pair b)
{
    (void)__ssub16((int16x2_t)a, (int16x2_t)b);
    return __sel(a, b);
}

PAIR_INLINE pair bytes_min(pair a, pair b)
{
    (void)__usub8(a, b);
    return __sel(b, a);
}

PAIR_INLINE pair bytes_max(pair a, pair b)
{
    (void)__usub8(a, b);
    return __sel(a, b);
}

/* S + L for lanes that are both >= 0 or saturate as int16. */
PAIR_INLINE pair pair_add_sat_i16(pair a, pair b)
{
    return (pair)__qadd16((int16x2_t)a, (int16x2_t)b);
}

PAIR_INLINE int32_t pair_low(pair v)
{
    return (int16_t)(v & 0xFFFFu);
}

PAIR_INLINE int32_t pair_high(pair v)
{
    return (int16_t)(v >> 16);
}

#endif
