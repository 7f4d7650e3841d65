/* SPDX-License-Identifier: MIT
 * base/divide.h - 64-bit division without the compiler's run-time routine, which alone is 700 bytes of a small core's flash. */
#ifndef STAD_BASE_DIVIDE_H
#define STAD_BASE_DIVIDE_H

#include <stdint.h>

/* a / b, toward zero as C divides. b != 0, |a| < 2^63, |b| < 2^62. A subtraction a bit of the quotient: for what is not done often. */
int64_t stad_div_i64(int64_t a, int64_t b);

#endif
