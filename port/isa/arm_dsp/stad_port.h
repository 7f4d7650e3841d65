/* SPDX-License-Identifier: MIT
 * port/isa/arm_dsp/stad_port.h - kernels for the 32-bit SIMD of Cortex-M4, M7 and M33; contracts: kernel/kernel.h. */
#ifndef STAD_PORT_H
#define STAD_PORT_H

#define stad_prefilter_row  stad_prefilter_row_dsp
#define stad_range_row      stad_range_row_dsp
#define stad_cost_row_u8    stad_cost_row_u8_dsp
#define stad_box_add_row_u8 stad_box_add_row_u8_dsp
#define stad_block_row      stad_block_row_dsp
#define stad_slide_row      stad_slide_row_dsp
#define stad_path_row       stad_path_row_dsp
#define stad_gather_row     stad_gather_row_dsp
#define stad_best_row       stad_best_row_dsp
#define stad_best_row_3way  stad_best_row_3way_dsp
#define stad_median_row     stad_median_row_dsp

void stad_prefilter_row_dsp(const uint8_t *above, const uint8_t *row, const uint8_t *below, int32_t width, int32_t channels,
                            int32_t cap, uint8_t *planes);
void stad_range_row_dsp(const uint8_t *plane, int32_t width, int reverse, uint8_t *out);
void stad_cost_row_u8_dsp(const stad_cost_job *job, uint8_t *cost);
void stad_box_add_row_u8_dsp(int16_t *sum, const uint8_t *cost, int32_t n, int32_t weight);
void stad_block_row_dsp(const stad_block_job *job, int16_t *block);
void stad_slide_row_dsp(const stad_slide_job *job, int16_t *block);
void stad_path_row_dsp(const stad_path_job *job, stad_lane *lanes, int32_t lane_count);
void stad_gather_row_dsp(int16_t *total, const stad_lane *lane, int32_t slot, const stad_path_job *job);
void stad_best_row_dsp(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_best_row_3way_dsp(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_median_row_dsp(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out);

#include "kernel/bind_c.h"

#endif
