/* SPDX-License-Identifier: MIT
 * proof/wp_check.c - the left-right check for every width.
 * FUNCTIONS: stad_check_row_c disagrees */
#include "proof/contracts.h"

/*@ requires \valid_read(job) && 0 <= x < job->width <= 32767 && -32768 <= disparity <= 32767 && -2047 <= job->min_disparity <= 2047;
    requires \valid_read(job->vote_disp + (0 .. job->width - 1));
    assigns \nothing; */
static int disagrees(const stad_check_job *job, int32_t x, int32_t disparity);

#include "kernel/check_row.c"
