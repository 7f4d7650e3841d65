/* SPDX-License-Identifier: MIT
 * port/board/board.h - all that a board gives an example firmware: text out, files in, an exit code, and what its stack came to.
 *
 * A board is a folder with a linker script and a settings file; the start-up code is shared by core family (common/). The
 * library itself uses nothing of this. */
#ifndef BOARD_H
#define BOARD_H

#include <stddef.h>

/* Writes a string to the console: semihosting on Arm, the UART on RISC-V, standard output on a host. */
void board_print(const char *text);

/* Ends the run; the emulator or process exits with `code`, 0..125. A fault ends it with BOARD_FAULT. */
void board_exit(int code);
#define BOARD_FAULT 125

/* Reads the first `bytes` bytes of a file of the host, a path from where the emulator or process was started; returns how
 * many there were, or -1. */
long board_read_file(const char *path, void *to, long bytes);

/* Bytes of stack the run has touched since reset: the start-up paints the free stack and this looks for the paint.
 * 0 where nobody painted (a host). */
size_t board_stack_used(void);

/* The firmware: returns its exit code. */
int main(void);

#endif
