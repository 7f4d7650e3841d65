/* SPDX-License-Identifier: MIT
 * tune/tune_random.c - xorshift32. */
#include "tune/tune_random.h"

uint32_t stad_tune_random(uint32_t *state)
{
    uint32_t s = *state;
    s ^= s << 13;
    s ^= s >> 17;
    s ^= s << 5;
    return *state = s;
}

int32_t stad_tune_between(uint32_t *state, int32_t lo, int32_t hi)
{
    const uint64_t span = (uint64_t)((int64_t)hi - lo) + 1;
    return (int32_t)(lo + (int64_t)((stad_tune_random(state) * span) >> 32));
}
