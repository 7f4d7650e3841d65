/* SPDX-License-Identifier: MIT
 * port/isa/riscv_v/stad_port.h - kernels for the vector extension 1.0 (V or Zve32x, any VLEN); contracts: kernel/kernel.h.
 * Written with intrinsics: clang 17 or later, gcc 13 or later. */
#ifndef STAD_PORT_H
#define STAD_PORT_H

#define stad_prefilter_row  stad_prefilter_row_rvv
#define stad_range_row      stad_range_row_rvv
#define stad_cost_row_u8    stad_cost_row_u8_rvv
#define stad_box_add_row_u8 stad_box_add_row_u8_rvv
#define stad_block_row      stad_block_row_rvv
#define stad_slide_row      stad_slide_row_rvv
#define stad_path_row       stad_path_row_rvv
#define stad_gather_row     stad_gather_row_rvv
#define stad_best_row       stad_best_row_rvv
#define stad_best_row_3way  stad_best_row_3way_rvv
#define stad_refine_row     stad_refine_row_rvv
#define stad_select_row     stad_select_row_rvv
#define stad_check_row      stad_check_row_rvv
#define stad_median_row     stad_median_row_rvv

void stad_prefilter_row_rvv(const uint8_t *above, const uint8_t *row, const uint8_t *below, int32_t width, int32_t channels,
                            int32_t cap, uint8_t *planes);
void stad_range_row_rvv(const uint8_t *plane, int32_t width, int reverse, uint8_t *out);
void stad_cost_row_u8_rvv(const stad_cost_job *job, uint8_t *cost);
void stad_box_add_row_u8_rvv(int16_t *sum, const uint8_t *cost, int32_t n, int32_t weight);
void stad_block_row_rvv(const stad_block_job *job, int16_t *block);
void stad_slide_row_rvv(const stad_slide_job *job, int16_t *block);
void stad_path_row_rvv(const stad_path_job *job, stad_lane *lanes, int32_t lane_count);
void stad_gather_row_rvv(int16_t *total, const stad_lane *lane, int32_t slot, const stad_path_job *job);
void stad_best_row_rvv(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_best_row_3way_rvv(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_refine_row_rvv(const int16_t *total, const stad_best *best, int32_t count, int32_t disparities, int16_t *fine);
void stad_select_row_rvv(stad_select_job *job);
int32_t stad_check_row_rvv(const stad_check_job *job);
void stad_median_row_rvv(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out);

#include "kernel/bind_c.h"

#endif
