/* SPDX-License-Identifier: MIT
 * port/isa/wide/cost_column_wide.h - one column of pixel costs; in a file of its own as path_step_wide.h says. */
#ifndef STAD_COST_COLUMN_WIDE_H
#define STAD_COST_COLUMN_WIDE_H

#include <stdint.h>

/* A plane of the left pixel, and the right row from the column that disparity 0 meets. */
typedef struct wide_plane {
    const uint8_t *restrict right_value, *restrict right_low, *restrict right_high;
    uint8_t value, low, high;
} wide_plane;

/* disparities: a multiple of 16. */
typedef struct wide_column {
    wide_plane gradient, intensity;
    uint8_t *restrict cost;
    int32_t disparities;
} wide_column;

/* Writes the costs of a channel; adds them to those there. */
void stad_cost_column_wide(const wide_column *restrict column);
void stad_cost_column_add_wide(const wide_column *restrict column);

#endif
