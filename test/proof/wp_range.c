/* SPDX-License-Identifier: MIT
 * proof/wp_range.c - half-sample bounds, either way round, for every width.
 * FUNCTIONS: stad_range_row_c inside inside_reverse put min_u8 max_u8 */
#include "proof/contracts.h"

/*@ requires \valid_read(at) && \valid_read(at + before) && \valid_read(at + after) && \valid(value) && \valid(low) && \valid(high);
    requires \separated(value, low, high, at) && \separated(value, low, high, at + before) && \separated(value, low, high, at + after);
    assigns *value, *low, *high; */
static inline void put(const uint8_t *at, int32_t before, int32_t after, uint8_t *value, uint8_t *low, uint8_t *high);
/*@ requires 1 <= width <= 32767 && \valid_read(plane + (0 .. width - 1)) && \valid(value + (0 .. width - 1)) &&
             \valid(low + (0 .. width - 1)) && \valid(high + (0 .. width - 1));
    requires \separated(value + (0 .. width - 1), low + (0 .. width - 1), high + (0 .. width - 1), plane + (0 .. width - 1));
    assigns value[0 .. width - 1], low[0 .. width - 1], high[0 .. width - 1]; */
static void inside(const uint8_t *restrict plane, int32_t width, uint8_t *restrict value, uint8_t *restrict low,
                   uint8_t *restrict high);
/*@ requires 1 <= width <= 32767 && \valid_read(plane + (0 .. width - 1)) && \valid(value + (0 .. width - 1)) &&
             \valid(low + (0 .. width - 1)) && \valid(high + (0 .. width - 1));
    requires \separated(value + (0 .. width - 1), low + (0 .. width - 1), high + (0 .. width - 1), plane + (0 .. width - 1));
    assigns value[0 .. width - 1], low[0 .. width - 1], high[0 .. width - 1]; */
static void inside_reverse(const uint8_t *restrict plane, int32_t width, uint8_t *restrict value, uint8_t *restrict low,
                           uint8_t *restrict high);

#include "kernel/range_row.c"
