/* SPDX-License-Identifier: MIT
 * port/isa/scalar/stad_port.h - the heavy kernels for little-endian 32-bit cores without SIMD (Cortex-M3, RV32IMAC): the C
 * reference is written for compilers that vectorise, these for those that cannot. Contracts: kernel/kernel.h. */
#ifndef STAD_PORT_H
#define STAD_PORT_H

#define stad_cost_row_u8   stad_cost_row_u8_scalar
#define stad_block_row     stad_block_row_scalar
#define stad_slide_row     stad_slide_row_scalar
#define stad_path_row      stad_path_row_scalar
#define stad_best_row      stad_best_row_scalar
#define stad_best_row_3way stad_best_row_3way_scalar

void stad_cost_row_u8_scalar(const stad_cost_job *job, uint8_t *cost);
void stad_block_row_scalar(const stad_block_job *job, int16_t *block);
void stad_slide_row_scalar(const stad_slide_job *job, int16_t *block);
void stad_path_row_scalar(const stad_path_job *job, stad_lane *lanes, int32_t lane_count);
void stad_best_row_scalar(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_best_row_3way_scalar(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);

#include "kernel/bind_c.h"

#endif
