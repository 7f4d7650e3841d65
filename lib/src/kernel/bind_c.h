/* SPDX-License-Identifier: MIT
 * kernel/bind_c.h - what a port has not bound falls to the C reference. A port's stad_port.h defines its own bindings and
 * then includes this file. */
#ifndef STAD_KERNEL_BIND_C_H
#define STAD_KERNEL_BIND_C_H

#ifndef stad_prefilter_row
#    define stad_prefilter_row stad_prefilter_row_c
#endif
#ifndef stad_range_row
#    define stad_range_row stad_range_row_c
#endif
#ifndef stad_cost_row_u8
#    define stad_cost_row_u8 stad_cost_row_u8_c
#endif
#ifndef stad_cost_row_u16
#    define stad_cost_row_u16 stad_cost_row_u16_c
#endif
#ifndef stad_box_add_row_u8
#    define stad_box_add_row_u8 stad_box_add_row_u8_c
#endif
#ifndef stad_box_add_row_u16
#    define stad_box_add_row_u16 stad_box_add_row_u16_c
#endif
#ifndef stad_block_row
#    define stad_block_row stad_block_row_c
#endif
#ifndef stad_slide_row
#    define stad_slide_row stad_slide_row_c
#endif
#ifndef stad_path_row
#    define stad_path_row stad_path_row_c
#endif
#ifndef stad_path_row_sat
#    define stad_path_row_sat stad_path_row_sat_c
#endif
#ifndef stad_path_row_u8
#    define stad_path_row_u8 stad_path_row_u8_c
#endif
#ifndef stad_gather_row
#    define stad_gather_row stad_gather_row_c
#endif
#ifndef stad_best_row
#    define stad_best_row stad_best_row_c
#endif
#ifndef stad_best_row_3way
#    define stad_best_row_3way stad_best_row_3way_c
#endif
#ifndef stad_last_row
#    define stad_last_row stad_last_row_c
#endif
#ifndef stad_refine_row
#    define stad_refine_row stad_refine_row_c
#endif
#ifndef stad_select_row
#    define stad_select_row stad_select_row_c
#endif
#ifndef stad_check_row
#    define stad_check_row stad_check_row_c
#endif
#ifndef stad_median_row
#    define stad_median_row stad_median_row_c
#endif
#ifndef stad_box_sat_row
#    define stad_box_sat_row stad_box_sat_row_c
#endif

#endif
