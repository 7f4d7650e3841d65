/* SPDX-License-Identifier: MIT
 * kernel/kernel_case.h - one random case of a kernel: run on a tier and by C, compared.
 *
 * `size` is what the sweep varies: disparities, or the width of a row. Everything else is drawn within the kernel's contract
 * (kernel/kernel.h), its edges often. */
#ifndef TEST_KERNEL_CASE_H
#define TEST_KERNEL_CASE_H

#include "kernel/kernel_set.h"
#include "kernel/room.h"

typedef struct kernel_case {
    const kernel_set *set;
    int32_t size;
    chance chance;
    char text[200]; /* the arguments drawn */
} kernel_case;

/* Each answers whether the tier wrote what C wrote. */
int case_prefilter(kernel_case *k);
int case_range(kernel_case *k);
int case_cost_u8(kernel_case *k);
int case_cost_u16(kernel_case *k);
int case_box_add_u8(kernel_case *k);
int case_box_add_u16(kernel_case *k);
int case_block(kernel_case *k);
int case_slide(kernel_case *k);
int case_path(kernel_case *k);
int case_path_sat(kernel_case *k);
int case_path_u8(kernel_case *k);
int case_gather(kernel_case *k);
int case_best(kernel_case *k);
int case_best_3way(kernel_case *k);
int case_median(kernel_case *k);
int case_last(kernel_case *k);
int case_refine(kernel_case *k);
int case_select(kernel_case *k);
int case_check(kernel_case *k);

#endif
