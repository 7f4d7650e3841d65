/* SPDX-License-Identifier: MIT
 * port/isa/wide/stad_port.h - plain C for compilers that vectorise: the heavy kernels as loops over unsigned cells that no
 * pointer can alias. The C reference is written to be short. Contracts: kernel/kernel.h; what is of another size than 16 divides
 * goes to the reference. */
#ifndef STAD_PORT_H
#define STAD_PORT_H

#define stad_cost_row_u8   stad_cost_row_u8_wide
#define stad_path_row      stad_path_row_wide
#define stad_best_row      stad_best_row_wide
#define stad_best_row_3way stad_best_row_3way_wide
#define stad_median_row    stad_median_row_wide

void stad_cost_row_u8_wide(const stad_cost_job *job, uint8_t *cost);
void stad_path_row_wide(const stad_path_job *job, stad_lane *lanes, int32_t lane_count);
void stad_best_row_wide(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_best_row_3way_wide(const int16_t *total, int32_t count, int32_t disparities, stad_best *best);
void stad_median_row_wide(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out);

#include "kernel/bind_c.h"

#endif
