/* SPDX-License-Identifier: MIT
 * proof/wp_prefilter.c - gradients and intensities, one channel or three, for every width.
 * FUNCTIONS: stad_prefilter_row_c gradient_row intensity_row clamp_i32 abs_i32 */
#include "proof/contracts.h"

/*@ requires 1 <= width <= 32767 && (step == 1 || step == 3) && 1 <= cap <= 32767;
    requires \valid_read(above + (0 .. (width - 1) * step)) && \valid_read(row + (0 .. (width - 1) * step)) &&
             \valid_read(below + (0 .. (width - 1) * step));
    requires \valid(gradient + (0 .. width - 1));
    assigns gradient[0 .. width - 1]; */
static inline void gradient_row(const uint8_t *restrict above, const uint8_t *restrict row, const uint8_t *restrict below,
                                int32_t width, int32_t step, int32_t cap, uint8_t *restrict gradient);
/*@ requires 1 <= width <= 32767 && (step == 1 || step == 3) && 1 <= cap <= 32767;
    requires \valid_read(row + (0 .. (width - 1) * step)) && \valid(intensity + (0 .. width - 1));
    assigns intensity[0 .. width - 1]; */
static void intensity_row(const uint8_t *restrict row, int32_t width, int32_t step, int32_t cap, uint8_t *restrict intensity);

#include "kernel/prefilter_row.c"
