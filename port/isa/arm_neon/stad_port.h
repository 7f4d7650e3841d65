/* SPDX-License-Identifier: MIT
 * port/isa/arm_neon/stad_port.h - kernels for NEON, A64 and A32; contracts: kernel/kernel.h. */
#ifndef STAD_PORT_H
#define STAD_PORT_H

#define stad_prefilter_row   stad_prefilter_row_neon
#define stad_range_row       stad_range_row_neon
#define stad_cost_row_u8     stad_cost_row_u8_neon
#define stad_cost_row_u16    stad_cost_row_u16_neon
#define stad_box_add_row_u8  stad_box_add_row_u8_neon
#define stad_box_add_row_u16 stad_box_add_row_u16_neon
#define stad_block_row       stad_block_row_neon
#define stad_slide_row       stad_slide_row_neon
#define stad_path_row        stad_path_row_neon
#define stad_gather_row      stad_gather_row_neon
#define stad_best_row        stad_best_row_neon
#define stad_best_row_3way   stad_best_row_3way_neon
#define stad_select_row      stad_select_row_neon
#define stad_median_row      stad_median_row_neon

void stad_prefilter_row_neon(const uint8_t *above, const uint8_t *row, const uint8_t *below, int32_t width, int32_t channels,
                             int32_t cap, uint8_t *planes);
void stad_range_row_neon(const uint8_t *plane, int32_t width, int reverse, uint8_t *out);
void stad_cost_row_u8_neon(const stad_cost_job *job, uint8_t *cost);
void stad_cost_row_u16_neon(const stad_cost_job *job, uint16_t *cost);
void stad_box_add_row_u8_neon(int16_t *sum, const uint8_t *cost, int32_t n, int32_t weight);
void stad_box_add_row_u16_neon(int16_t *sum, const uint16_t *cost, int32_t n, int32_t weight);
void stad_block_row_neon(const stad_block_job *job, int16_t *block);
void stad_slide_row_neon(const stad_slide_job *job, int16_t *block);
void stad_path_row_neon(const stad_path_job *job, stad_lane *lanes, int32_t lane_count);
void stad_gather_row_neon(int16_t *total, const stad_lane *lane, int32_t slot, const stad_path_job *job);
void stad_best_row_neon(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_best_row_3way_neon(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_select_row_neon(stad_select_job *job);
void stad_median_row_neon(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out);

#include "kernel/bind_c.h"

#endif
