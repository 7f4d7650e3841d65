/* SPDX-License-Identifier: MIT
 * plan -> [BOARD]
 * stad/plan_board.c - memories as the linker scripts of port/board have them, instructions as tools/count/counts.csv. */
#include "plan_board.h"

#include <stdio.h>
#include <string.h>

#include "stad/calib.h"

enum { STACK_BYTES = 1024, LOOP_STACK_BYTES = 2048 }; /* the library's worst, test/budget; a firmware's, examples/mcu */

struct plan_board {
    const char *name, *core;
    long ram_bytes, flash_bytes;
    double instructions[4]; /* per (W - D) H D: SGBM fast, small, 3WAY fast, small */
};

#define M3   {176.7, 270.7, 148.1, 230.7}
#define M4   {81.7, 114.9, 69.4, 100.0}
#define M7   {81.9, 114.7, 69.6, 99.9}
#define M55  {18.1, 30.2, 16.0, 26.3}
#define RV32 {151.1, 229.7, 125.5, 199.0}
#define RV_V {11.0, 18.9, 10.1, 16.6}
#define A53  {15.5, 27.3, 14.3, 23.8}
#define NONE {0, 0, 0, 0}

static const plan_board boards[] = {{"mps2-an385", "Cortex-M3", 4l << 20, 4l << 20, M3},
                                    {"mps2-an386", "Cortex-M4F", 4l << 20, 4l << 20, M4},
                                    {"mps2-an500", "Cortex-M7", 4l << 20, 4l << 20, M7},
                                    {"mps2-an505", "Cortex-M33", 4l << 20, 4l << 20, NONE},
                                    {"mps3-an547", "Cortex-M55", 512l << 10, 512l << 10, M55},
                                    {"netduinoplus2", "STM32F405, Cortex-M4F", 192l << 10, 1l << 20, M4},
                                    {"riscv32", "RV32IMAC", 14l << 20, 2l << 20, RV32},
                                    {"riscv32v", "RV32 with Zve32x, VLEN 128", 14l << 20, 2l << 20, NONE},
                                    {"riscv64", "RV64GC", 14l << 20, 2l << 20, NONE},
                                    {"riscv64v", "RV64GCV, VLEN 128", 14l << 20, 2l << 20, RV_V},
                                    {"aarch64", "Cortex-A53", 14l << 20, 2l << 20, A53}};
enum { BOARDS = sizeof boards / sizeof boards[0] };

const plan_board *plan_board_named(const char *name)
{
    for (int i = 0; i < BOARDS; i++)
        if (strcmp(boards[i].name, name) == 0)
            return &boards[i];
    return NULL;
}

void plan_board_names(char *to, size_t bytes)
{
    size_t used = 0;
    for (int i = 0; i < BOARDS && used < bytes; i++)
        used += (size_t)snprintf(to + used, bytes - used, "%s%s", i ? ", " : "", boards[i].name);
}

/* Two rows of pixels in, one of disparities out. */
static long row_bytes(const stad_geometry *g)
{
    return (long)g->width * (2 * g->channels + 2);
}

void plan_board_print(const plan_board *b, const stad_geometry *g)
{
    printf("%s (%s): %ld bytes of RAM, %ld of flash; beside a workspace: %zu of context, %ld of rows, %d of stack\n", b->name,
           b->core, b->ram_bytes, b->flash_bytes, sizeof(stad_match), row_bytes(g), STACK_BYTES);
}

long plan_board_left(const plan_board *b, const stad_geometry *g)
{
    return b->ram_bytes - (long)stad_match_bytes(g) - (long)sizeof(stad_match) - row_bytes(g) - STACK_BYTES;
}

double plan_board_instructions(const plan_board *b, const stad_geometry *g)
{
    const double cells = (double)(g->width - g->max_disparities) * g->height * g->max_disparities;
    const int small = g->memory == STAD_MEMORY_SMALL;
    const size_t block = (size_t)g->max_block_size, p2 = (size_t)g->max_p2, cap = (size_t)g->max_pre_filter_cap;
    const int counted = g->channels == 1 && cells > 0 && (g->mode == STAD_MODE_SGBM || g->mode == STAD_MODE_3WAY);
    if (!counted || !STAD_COST_SAFE(1, block, p2, cap) || STAD_LANE_NARROW(1, block, p2, cap, g->mode, g->memory))
        return 0; /* other kernels work there */
    return b->instructions[(g->mode == STAD_MODE_3WAY ? 2 : 0) + small] * cells;
}

void plan_board_print_loop(const plan_board *b, const stad_geometry *g)
{
    const size_t trial = stad_calib_evaluate_bytes(g), marks = stad_calib_frame_bytes(g->width, g->height);
    const long work = (long)(trial > marks ? trial : marks);
    const long pairs = 3l * 2 * g->width * g->height * g->channels;
    const long state = (long)(sizeof(stad_calib) + sizeof(stad_evaluator) + sizeof(stad_match)) + row_bytes(g);
    const long left = b->ram_bytes - work - pairs - state - LOOP_STACK_BYTES;
    printf("whole loop, sgbm small: %ld bytes, of them %ld workspace in turn, %ld three pairs, %ld state and rows, %d stack: %s "
           "%ld %s\n",
           work + pairs + state + LOOP_STACK_BYTES, work, pairs, state, LOOP_STACK_BYTES, left >= 0 ? "fits," : "does NOT fit,",
           left >= 0 ? left : -left, left >= 0 ? "left" : "too many");
}
