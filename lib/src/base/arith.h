/* SPDX-License-Identifier: MIT
 * base/arith.h - arithmetic verbs whose names say width and overflow.
 *
 * narrow_*: the value is known to fit. sat_*: clamps. wrap_*: keeps the low bits. A build with STAD_CHECKED asserts that values
 * fit, and at the borders of the modules what their headers leave to the caller: pointers, sizes, what was begun. */
#ifndef STAD_BASE_ARITH_H
#define STAD_BASE_ARITH_H

#include <stdint.h>

#ifdef STAD_CHECKED
#    include <assert.h>
#    define STAD_ASSERT(condition) assert(condition)
#else
#    define STAD_ASSERT(condition) ((void)0)
#endif

static inline int32_t min_i32(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

static inline int32_t max_i32(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

static inline int32_t clamp_i32(int32_t v, int32_t low, int32_t high)
{
    STAD_ASSERT(low <= high);
    return v < low ? low : v > high ? high : v;
}

static inline int32_t abs_i32(int32_t v)
{
    STAD_ASSERT(v > INT32_MIN);
    return v < 0 ? -v : v;
}

static inline int16_t min_i16(int16_t a, int16_t b)
{
    return a < b ? a : b;
}

static inline int16_t max_i16(int16_t a, int16_t b)
{
    return a > b ? a : b;
}

static inline uint8_t min_u8(uint8_t a, uint8_t b)
{
    return a < b ? a : b;
}

static inline uint8_t max_u8(uint8_t a, uint8_t b)
{
    return a > b ? a : b;
}

/* max(a - b, 0) without leaving eight bits. */
static inline uint8_t sub_floor_u8(uint8_t a, uint8_t b)
{
    return (uint8_t)(max_u8(a, b) - b);
}

static inline int16_t narrow_i16(int32_t v)
{
    STAD_ASSERT(v >= INT16_MIN && v <= INT16_MAX);
    return (int16_t)v;
}

static inline uint8_t narrow_u8(int32_t v)
{
    STAD_ASSERT(v >= 0 && v <= UINT8_MAX);
    return (uint8_t)v;
}

static inline int16_t sat_i16(int32_t v)
{
    return (int16_t)clamp_i32(v, INT16_MIN, INT16_MAX);
}

static inline int32_t clamp_i64(int64_t v, int32_t low, int32_t high)
{
    STAD_ASSERT(low <= high);
    return v < low ? low : v > high ? high : (int32_t)v;
}

static inline int32_t sat_i32(int64_t v)
{
    return clamp_i64(v, INT32_MIN, INT32_MAX);
}

/* The low 16 bits read as two's complement, with no implementation-defined conversion. */
static inline int16_t wrap_i16(int32_t v)
{
    const int32_t low = (int32_t)((uint32_t)v & 0xFFFFu);
    return (int16_t)(low < 0x8000 ? low : low - 0x10000);
}

static inline int16_t add_sat_i16(int16_t a, int16_t b)
{
    return sat_i16((int32_t)a + b);
}

static inline int16_t sub_sat_i16(int16_t a, int16_t b)
{
    return sat_i16((int32_t)a - b);
}

/* n, a multiple of 8, in a form that tells the compiler so: a vectorised loop then has no remainder, or one of 8. */
static inline int32_t whole_8(int32_t n)
{
    STAD_ASSERT(n >= 0 && n % 8 == 0);
    return (int32_t)((uint32_t)n & ~(uint32_t)7);
}

/* v modulo n for n > 0, in [0, n) for negative v too. */
static inline int32_t mod_i32(int32_t v, int32_t n)
{
    STAD_ASSERT(n > 0);
    const int32_t rest = v % n;
    return rest < 0 ? rest + n : rest;
}

#endif
