/* SPDX-License-Identifier: MIT
 * proof/wp_box.c - vertical sums of costs that stay within int16, for every width.
 * FUNCTIONS: stad_box_add_row_u8_c stad_box_add_row_u16_c narrow_i16 */
#include "proof/contracts.h"
#include "kernel/box_row.c"
