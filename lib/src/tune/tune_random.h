/* SPDX-License-Identifier: MIT
 * tune/tune_random.h - the same random numbers on every core. */
#ifndef STAD_TUNE_RANDOM_H
#define STAD_TUNE_RANDOM_H

#include <stdint.h>

/* The next number of xorshift32; *state must not be 0 and never becomes 0. */
uint32_t stad_tune_random(uint32_t *state);

/* A number of lo..hi. */
int32_t stad_tune_between(uint32_t *state, int32_t lo, int32_t hi);

#endif
