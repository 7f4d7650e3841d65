/* SPDX-License-Identifier: MIT
 * proof/prove.h - inputs of which only the range is known, for Frama-C's value analysis. */
#ifndef PROVE_H
#define PROVE_H

#include <stdint.h>

#include "__fc_builtin.h"

static inline int any(int low, int high)
{
    return Frama_C_interval(low, high);
}

static inline long long any64(long long low, long long high)
{
    return Frama_C_long_long_interval(low, high);
}

static inline void any_u8(uint8_t *p, int n)
{
    for (int i = 0; i < n; i++) {
        p[i] = (uint8_t)any(0, 255);
    }
}

static inline void any_i16(int16_t *p, int n, int low, int high)
{
    for (int i = 0; i < n; i++) {
        p[i] = (int16_t)any(low, high);
    }
}

#endif
