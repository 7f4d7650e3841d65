/* SPDX-License-Identifier: MIT
 * proof/wp_median.c - the median of three rows for every width.
 * FUNCTIONS: stad_median_row_c sorted median_of min_i16 max_i16 min_i32 max_i32 */
#include "proof/contracts.h"

/*@ assigns \nothing; */
static inline int16_t median_of(int16_t a, int16_t b, int16_t c);

#include "kernel/median_row.c"

/*@ assigns \nothing; */
static inline triple sorted(int16_t a, int16_t b, int16_t c);
