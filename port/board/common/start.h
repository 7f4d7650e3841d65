/* SPDX-License-Identifier: MIT
 * board/common/start.h - reset (by core family) -> [START] -> main. */
#ifndef BOARD_START_H
#define BOARD_START_H

/* Fills .data and .bss, paints the free stack, runs main and exits with its result. Needs a stack and, where the compiler
 * may use them, FPU and vector unit switched on: these loops get vectorised too. */
void board_start(void);

#endif
