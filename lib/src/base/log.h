/* SPDX-License-Identifier: MIT
 * base/log.h - logarithm, power of two and square root in integers, the same bits on every core. */
#ifndef STAD_BASE_LOG_H
#define STAD_BASE_LOG_H

#include <stdint.h>

/* log2(v) * 65536 for v >= 1, rounded; 0 for v = 0. Exact at powers of two. */
int32_t stad_log2_q16(uint32_t v);

/* 2^(e / 65536) * 65536 for e / 65536 in [-16, 30), within one part in 70000; clipped outside. Exact at whole e, and
 * the inverse of stad_log2_q16() for 1..32767 once rounded to an integer. */
int64_t stad_exp2_q16(int32_t e_q16);

/* Square root, rounded down. */
uint32_t stad_isqrt(uint64_t v);

#endif
