/* SPDX-License-Identifier: MIT
 * kernel/kernel_set.h - the kernels of one tier as a table, so that one set of cases runs on every tier. */
#ifndef TEST_KERNEL_SET_H
#define TEST_KERNEL_SET_H

#include "kernel/last_row.h"

typedef void prefilter_kernel(const uint8_t *, const uint8_t *, const uint8_t *, int32_t, int32_t, int32_t, uint8_t *);
typedef void range_kernel(const uint8_t *, int32_t, int, uint8_t *);
typedef void cost_u8_kernel(const stad_cost_job *, uint8_t *);
typedef void cost_u16_kernel(const stad_cost_job *, uint16_t *);
typedef void box_add_u8_kernel(int16_t *, const uint8_t *, int32_t, int32_t);
typedef void box_add_u16_kernel(int16_t *, const uint16_t *, int32_t, int32_t);
typedef void block_kernel(const stad_block_job *, int16_t *);
typedef void slide_kernel(const stad_slide_job *, int16_t *);
typedef void path_kernel(const stad_path_job *, stad_lane *, int32_t);
typedef void path_u8_kernel(const stad_path_job *, stad_lane_u8 *, int32_t);
typedef void gather_kernel(int16_t *, const stad_lane *, int32_t, const stad_path_job *);
typedef void best_kernel(const int16_t *, int32_t, int32_t, stad_best *);
typedef void last_kernel(const stad_path_job *, stad_lane *, int, stad_best *);
typedef void refine_kernel(const int16_t *, const stad_best *, int32_t, int32_t, int16_t *);
typedef void select_kernel(stad_select_job *);
typedef int32_t check_kernel(const stad_check_job *);
typedef void median_kernel(const int16_t *, const int16_t *, const int16_t *, int32_t, int16_t *);

typedef struct kernel_set {
    const char *name;
    int32_t lanes; /* kernels that walk disparities take multiples of it */
    prefilter_kernel *prefilter;
    range_kernel *range;
    cost_u8_kernel *cost_u8;
    cost_u16_kernel *cost_u16;
    box_add_u8_kernel *box_add_u8;
    box_add_u16_kernel *box_add_u16;
    block_kernel *block;
    slide_kernel *slide;
    path_kernel *path, *path_sat;
    path_u8_kernel *path_u8;
    gather_kernel *gather;
    best_kernel *best, *best_3way;
    median_kernel *median;
    last_kernel *last;
    refine_kernel *refine;
    select_kernel *select;
    check_kernel *check;
} kernel_set;

/* A table whose every kernel has this suffix; path_sat and path_u8 are named, since few tiers have their own. The bound set alone has
 * refine, select and check of its own: no x86 tier but the narrowest has them. */
#define KERNEL_SET(name, lanes, suffix, path_sat, path_u8) \
    {name,                                                 \
     lanes,                                                \
     stad_prefilter_row##suffix,                           \
     stad_range_row##suffix,                               \
     stad_cost_row_u8##suffix,                             \
     stad_cost_row_u16##suffix,                            \
     stad_box_add_row_u8##suffix,                          \
     stad_box_add_row_u16##suffix,                         \
     stad_block_row##suffix,                               \
     stad_slide_row##suffix,                               \
     stad_path_row##suffix,                                \
     path_sat,                                             \
     path_u8,                                              \
     stad_gather_row##suffix,                              \
     stad_best_row##suffix,                                \
     stad_best_row_3way##suffix,                           \
     stad_median_row##suffix,                              \
     stad_last_row##suffix,                                \
     stad_refine_row_c,                                    \
     stad_select_row_c,                                    \
     stad_check_row_c}

#endif
