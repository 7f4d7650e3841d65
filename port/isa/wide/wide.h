/* SPDX-License-Identifier: MIT
 * port/isa/wide/wide.h - verbs on unsigned cells, whose least and largest compilers know as one instruction each. */
#ifndef STAD_WIDE_H
#define STAD_WIDE_H

#include <stdint.h>

static inline uint16_t min_u16(uint16_t a, uint16_t b)
{
    return a < b ? a : b;
}

static inline uint16_t max_u16(uint16_t a, uint16_t b)
{
    return a > b ? a : b;
}

static inline int is_whole_16(int32_t n)
{
    return n % 16 == 0;
}

/* n, a multiple of 16, in a form that tells the compiler so: its vectors leave no remainder. */
static inline int32_t whole_16(int32_t n)
{
    return (int32_t)((uint32_t)n & ~(uint32_t)15);
}

#endif
