/* SPDX-License-Identifier: MIT
 * test/target/kernels.h - what the cases of test/target/kernels.c share: draws, inputs, two outputs between guards. */
#ifndef STAD_TARGET_KERNELS_H
#define STAD_TARGET_KERNELS_H

#include <stdint.h>

enum { WIDTH = 80, DISPARITIES = 48, COLUMNS = 40, GUARD = 64 };
enum { CELLS = COLUMNS * DISPARITIES, STRIDE = DISPARITIES + 16 };

/* One of the port and one of C, each between guards. */
typedef union output {
    uint8_t u8[2 * GUARD + 2 * CELLS];
    int16_t i16[GUARD + CELLS];
    uint16_t u16[GUARD + CELLS];
    uint64_t align;
} output;

extern output mine, reference;
extern uint8_t bytes_a[12 * WIDTH * 3], bytes_b[12 * WIDTH * 3];
extern int16_t words_a[CELLS + 16], words_b[CELLS + 16], words_c[CELLS + 16];

/* Fills both outputs with guards and begins to draw anew. */
void prepare(uint32_t seed);

/* The port wrote what C wrote, and neither wrote elsewhere. */
int same(void);

uint32_t draw(void);
int32_t between(int32_t low, int32_t high);

/* In [0, top], one time in four an end of it. */
int32_t value_to(int32_t top);
void fill_u8(uint8_t *p, int32_t n, int32_t top);
void fill_i16(int16_t *p, int32_t n, int32_t low, int32_t top);

/* Cases: each answers whether the port agrees. */
int run(void);
int case_prefilter(void);
int case_range(void);
int case_cost_u8(void);
int case_cost_u16(void);
int case_box_add_u8(void);
int case_box_add_u16(void);
int case_block(void);
int case_box_sat(void);
int case_slide(void);
int case_path(void);
int case_path_sat(void);
int case_path_u8(void);
int case_gather(void);
int case_best(void);
int case_best_3way(void);
int case_refine(void);
int case_select(void);
int case_check(void);
int case_median(void);

#endif
