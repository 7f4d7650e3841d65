/* SPDX-License-Identifier: MIT
 * proof/contracts.h - kernel/kernel.h's prose as contracts: what a kernel may read and write, and the values it is called with.
 *
 * Frama-C's WP proves for every width that the kernels in C keep to them and overflow nowhere: wp_*.c. The verbs of
 * base/arith.h are proved with them, but for whole_8: no prover sees that clearing three zero bits changes nothing. */
#ifndef PROOF_CONTRACTS_H
#define PROOF_CONTRACTS_H

#include "kernel/kernel.h"

/* -- base/arith.h -- */

/*@ requires fits: -32768 <= v <= 32767; assigns \nothing; ensures \result == v; */
static inline int16_t narrow_i16(int32_t v);
/*@ assigns \nothing; ensures (\result == a || \result == b) && \result <= a && \result <= b; */
static inline int32_t min_i32(int32_t a, int32_t b);
/*@ assigns \nothing; ensures (\result == a || \result == b) && \result >= a && \result >= b; */
static inline int32_t max_i32(int32_t a, int32_t b);
/*@ assigns \nothing; ensures (\result == a || \result == b) && \result <= a && \result <= b; */
static inline int16_t min_i16(int16_t a, int16_t b);
/*@ assigns \nothing; ensures (\result == a || \result == b) && \result >= a && \result >= b; */
static inline int16_t max_i16(int16_t a, int16_t b);
/*@ assigns \nothing; ensures (\result == a || \result == b) && \result <= a && \result <= b; */
static inline uint8_t min_u8(uint8_t a, uint8_t b);
/*@ assigns \nothing; ensures (\result == a || \result == b) && \result >= a && \result >= b; */
static inline uint8_t max_u8(uint8_t a, uint8_t b);
/*@ requires low <= high; assigns \nothing; ensures low <= \result <= high; ensures low <= v <= high ==> \result == v; */
static inline int32_t clamp_i32(int32_t v, int32_t low, int32_t high);
/*@ requires v > -2147483648; assigns \nothing; ensures \result == \abs(v); */
static inline int32_t abs_i32(int32_t v);

/*@ requires n >= 0 && n % 8 == 0; assigns \nothing; ensures \result == n; */
static inline int32_t whole_8(int32_t n);

/* -- box: sums stay within int16 -- */

/*@ requires n >= 0 && -16384 <= weight <= 16384;
    requires \valid(sum + (0 .. n - 1)) && \valid_read(cost + (0 .. n - 1));
    requires \separated(sum + (0 .. n - 1), cost + (0 .. n - 1));
    requires \forall integer i; 0 <= i < n ==> -32768 <= sum[i] + weight * cost[i] <= 32767;
    assigns sum[0 .. n - 1]; */
void stad_box_add_row_u8_c(int16_t *restrict sum, const uint8_t *restrict cost, int32_t n, int32_t weight);

/*@ requires n >= 0 && -16384 <= weight <= 16384;
    requires \valid(sum + (0 .. n - 1)) && \valid_read(cost + (0 .. n - 1));
    requires \separated(sum + (0 .. n - 1), cost + (0 .. n - 1));
    requires \forall integer i; 0 <= i < n ==> -32768 <= sum[i] + weight * cost[i] <= 32767;
    assigns sum[0 .. n - 1]; */
void stad_box_add_row_u16_c(int16_t *restrict sum, const uint16_t *restrict cost, int32_t n, int32_t weight);

/* -- prefilter, range: rows of an image up to 32767 px wide, of one channel or three -- */

/*@ requires 1 <= width <= 32767 && (channels == 1 || channels == 3) && 1 <= cap <= 32767;
    requires \valid_read(above + (0 .. width * channels - 1)) && \valid_read(row + (0 .. width * channels - 1)) &&
             \valid_read(below + (0 .. width * channels - 1));
    requires \valid(planes + (0 .. 2 * channels * width - 1));
    requires \separated(planes + (0 .. 2 * channels * width - 1), above + (0 .. width * channels - 1));
    requires \separated(planes + (0 .. 2 * channels * width - 1), row + (0 .. width * channels - 1));
    requires \separated(planes + (0 .. 2 * channels * width - 1), below + (0 .. width * channels - 1));
    assigns planes[0 .. 2 * channels * width - 1]; */
void stad_prefilter_row_c(const uint8_t *above, const uint8_t *row, const uint8_t *below, int32_t width, int32_t channels,
                          int32_t cap, uint8_t *planes);

/*@ requires 1 <= width <= 32767;
    requires \valid_read(plane + (0 .. width - 1)) && \valid(out + (0 .. 3 * width - 1));
    requires \separated(plane + (0 .. width - 1), out + (0 .. 3 * width - 1));
    assigns out[0 .. 3 * width - 1]; */
void stad_range_row_c(const uint8_t *plane, int32_t width, int reverse, uint8_t *out);

/* -- median, check -- */

/*@ requires width >= 1;
    requires \valid_read(above + (0 .. width - 1)) && \valid_read(row + (0 .. width - 1)) && \valid_read(below + (0 .. width - 1));
    requires \valid(out + (0 .. width - 1));
    requires \separated(out + (0 .. width - 1), above + (0 .. width - 1));
    requires \separated(out + (0 .. width - 1), row + (0 .. width - 1));
    requires \separated(out + (0 .. width - 1), below + (0 .. width - 1));
    assigns out[0 .. width - 1]; */
void stad_median_row_c(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out);

/*@ requires \valid_read(job) && 0 <= job->x0 && job->x1 <= job->width <= 32767 && -2047 <= job->min_disparity <= 2047;
    requires \valid(job->disp + (0 .. job->width - 1)) && \valid_read(job->vote_disp + (0 .. job->width - 1));
    requires \separated(job->disp + (0 .. job->width - 1), job->vote_disp + (0 .. job->width - 1));
    requires \separated(job->disp + (0 .. job->width - 1), job);
    assigns job->disp[job->x0 .. job->x1 - 1];
    ensures 0 <= \result <= \max(job->x1 - job->x0, 0); */
int32_t stad_check_row_c(const stad_check_job *job);

#endif
