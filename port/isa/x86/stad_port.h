/* SPDX-License-Identifier: MIT
 * port/isa/x86/stad_port.h - x86: kernels that choose SSE4.1, AVX2 or C at run time (dispatch.c). */
#ifndef STAD_PORT_H
#define STAD_PORT_H

#define stad_prefilter_row   stad_prefilter_row_x86
#define stad_range_row       stad_range_row_x86
#define stad_cost_row_u8     stad_cost_row_u8_x86
#define stad_cost_row_u16    stad_cost_row_u16_x86
#define stad_box_add_row_u8  stad_box_add_row_u8_x86
#define stad_box_add_row_u16 stad_box_add_row_u16_x86
#define stad_block_row       stad_block_row_x86
#define stad_slide_row       stad_slide_row_x86
#define stad_path_row        stad_path_row_x86
#define stad_gather_row      stad_gather_row_x86
#define stad_best_row        stad_best_row_x86
#define stad_best_row_3way   stad_best_row_3way_x86
#define stad_last_row        stad_last_row_x86
#define stad_refine_row      stad_refine_row_x86
#define stad_select_row      stad_select_row_x86
#define stad_check_row       stad_check_row_x86
#define stad_median_row      stad_median_row_x86

#include "port_x86.h"
#include "kernel/bind_c.h"

#endif
