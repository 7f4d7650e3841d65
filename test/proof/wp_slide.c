/* SPDX-License-Identifier: MIT
 * proof/wp_slide.c - a column of sums added, and moved, for every width.
 * FUNCTIONS: add_column move_column */
#include "proof/contracts.h"

/*@ requires n >= 0 && \valid(block + (0 .. n - 1)) && \valid_read(sum + (0 .. n - 1));
    requires \separated(block + (0 .. n - 1), sum + (0 .. n - 1));
    requires \forall integer d; 0 <= d < n ==> -32768 <= block[d] + sum[d] <= 32767;
    assigns block[0 .. n - 1]; */
static void add_column(int16_t *restrict block, const int16_t *restrict sum, int32_t n);
/*@ requires n >= 0 && \valid(to + (0 .. n - 1)) && \valid_read(from + (0 .. n - 1)) && \valid_read(in + (0 .. n - 1)) &&
             \valid_read(out + (0 .. n - 1));
    requires \separated(to + (0 .. n - 1), from + (0 .. n - 1)) && \separated(to + (0 .. n - 1), in + (0 .. n - 1)) &&
             \separated(to + (0 .. n - 1), out + (0 .. n - 1));
    requires \forall integer d; 0 <= d < n ==> -32768 <= from[d] + (in[d] - out[d]) <= 32767;
    assigns to[0 .. n - 1]; */
static void move_column(int16_t *restrict to, const int16_t *from, const int16_t *in, const int16_t *out, int32_t n);

#include "kernel/slide_row.c"
