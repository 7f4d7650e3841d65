/* SPDX-License-Identifier: MIT
 * port/isa/x86/port_x86.h - the kernels of each tier; contracts: kernel/kernel.h. The tiers take every
 * size the contract allows; what a vector does not fit they finish in narrower steps. */
#ifndef STAD_PORT_X86_H
#define STAD_PORT_X86_H

/* -- the bound symbols: choose a tier -- */
void stad_prefilter_row_x86(const uint8_t *above, const uint8_t *row, const uint8_t *below, int32_t width, int32_t channels,
                            int32_t cap, uint8_t *planes);
void stad_range_row_x86(const uint8_t *plane, int32_t width, int reverse, uint8_t *out);
void stad_cost_row_u8_x86(const stad_cost_job *job, uint8_t *cost);
void stad_cost_row_u16_x86(const stad_cost_job *job, uint16_t *cost);
void stad_box_add_row_u8_x86(int16_t *sum, const uint8_t *cost, int32_t n, int32_t weight);
void stad_box_add_row_u16_x86(int16_t *sum, const uint16_t *cost, int32_t n, int32_t weight);
void stad_block_row_x86(const stad_block_job *job, int16_t *block);
void stad_slide_row_x86(const stad_slide_job *job, int16_t *block);
void stad_path_row_x86(const stad_path_job *job, stad_lane *lanes, int32_t lane_count);
void stad_gather_row_x86(int16_t *total, const stad_lane *lane, int32_t slot, const stad_path_job *job);
void stad_best_row_x86(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_best_row_3way_x86(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_last_row_x86(const stad_path_job *job, stad_lane *lane, int three_way, stad_best *best);
void stad_refine_row_x86(const int16_t *total, const stad_best *best, int32_t count, int32_t disparities, int16_t *fine);
void stad_select_row_x86(stad_select_job *job);
int32_t stad_check_row_x86(const stad_check_job *job);
void stad_median_row_x86(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out);

/* -- 128-bit vectors -- */
void stad_prefilter_row_sse41(const uint8_t *above, const uint8_t *row, const uint8_t *below, int32_t width, int32_t channels,
                              int32_t cap, uint8_t *planes);
void stad_range_row_sse41(const uint8_t *plane, int32_t width, int reverse, uint8_t *out);
void stad_cost_row_u8_sse41(const stad_cost_job *job, uint8_t *cost);
void stad_cost_row_u16_sse41(const stad_cost_job *job, uint16_t *cost);
void stad_box_add_row_u8_sse41(int16_t *sum, const uint8_t *cost, int32_t n, int32_t weight);
void stad_box_add_row_u16_sse41(int16_t *sum, const uint16_t *cost, int32_t n, int32_t weight);
void stad_block_row_sse41(const stad_block_job *job, int16_t *block);
void stad_slide_row_sse41(const stad_slide_job *job, int16_t *block);
void stad_path_row_sse41(const stad_path_job *job, stad_lane *lanes, int32_t lane_count);
void stad_gather_row_sse41(int16_t *total, const stad_lane *lane, int32_t slot, const stad_path_job *job);
void stad_best_row_sse41(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_best_row_3way_sse41(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_last_row_sse41(const stad_path_job *job, stad_lane *lane, int three_way, stad_best *best);
void stad_refine_row_sse41(const int16_t *total, const stad_best *best, int32_t count, int32_t disparities,
                           int16_t *fine); /* at every tier */
void stad_median_row_sse41(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out);
void stad_select_row_sse41(stad_select_job *job);        /* at every tier */
int32_t stad_check_row_sse41(const stad_check_job *job); /* at every tier */

/* -- 256-bit vectors -- */
void stad_prefilter_row_avx2(const uint8_t *above, const uint8_t *row, const uint8_t *below, int32_t width, int32_t channels,
                             int32_t cap, uint8_t *planes);
void stad_range_row_avx2(const uint8_t *plane, int32_t width, int reverse, uint8_t *out);
void stad_cost_row_u8_avx2(const stad_cost_job *job, uint8_t *cost);
void stad_cost_row_u16_avx2(const stad_cost_job *job, uint16_t *cost);
void stad_box_add_row_u8_avx2(int16_t *sum, const uint8_t *cost, int32_t n, int32_t weight);
void stad_box_add_row_u16_avx2(int16_t *sum, const uint16_t *cost, int32_t n, int32_t weight);
void stad_block_row_avx2(const stad_block_job *job, int16_t *block);
void stad_slide_row_avx2(const stad_slide_job *job, int16_t *block);
void stad_path_row_avx2(const stad_path_job *job, stad_lane *lanes, int32_t lane_count);
void stad_gather_row_avx2(int16_t *total, const stad_lane *lane, int32_t slot, const stad_path_job *job);
void stad_best_row_avx2(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_best_row_3way_avx2(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_last_row_avx2(const stad_path_job *job, stad_lane *lane, int three_way, stad_best *best);
void stad_median_row_avx2(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out);

/* -- 512-bit vectors -- */
void stad_prefilter_row_avx512(const uint8_t *above, const uint8_t *row, const uint8_t *below, int32_t width, int32_t channels,
                               int32_t cap, uint8_t *planes);
void stad_range_row_avx512(const uint8_t *plane, int32_t width, int reverse, uint8_t *out);
void stad_cost_row_u8_avx512(const stad_cost_job *job, uint8_t *cost);
void stad_cost_row_u16_avx512(const stad_cost_job *job, uint16_t *cost);
void stad_box_add_row_u8_avx512(int16_t *sum, const uint8_t *cost, int32_t n, int32_t weight);
void stad_box_add_row_u16_avx512(int16_t *sum, const uint16_t *cost, int32_t n, int32_t weight);
void stad_block_row_avx512(const stad_block_job *job, int16_t *block);
void stad_slide_row_avx512(const stad_slide_job *job, int16_t *block);
void stad_path_row_avx512(const stad_path_job *job, stad_lane *lanes, int32_t lane_count);
void stad_gather_row_avx512(int16_t *total, const stad_lane *lane, int32_t slot, const stad_path_job *job);
void stad_best_row_avx512(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_best_row_3way_avx512(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_last_row_avx512(const stad_path_job *job, stad_lane *lane, int three_way, stad_best *best);
void stad_median_row_avx512(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out);

/* The widest tier in use: 0 C, 1 SSE4.1, 2 AVX2, 3 AVX-512 (F, BW). What the CPU has, lowered by the environment variable STAD_ISA (c, sse41,
 * avx2, avx512), read once. */
int stad_x86_tier(void);
const char *stad_x86_tier_name(void);

#endif
