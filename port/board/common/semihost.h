/* SPDX-License-Identifier: MIT
 * board/common/semihost.h - the call by which an emulator or debugger lends the board its console, files and exit. */
#ifndef BOARD_SEMIHOST_H
#define BOARD_SEMIHOST_H

#include <stdint.h>

/* One operation; block: its arguments, words of the core's width. Each core family has its own trap. */
intptr_t board_semihost(uintptr_t operation, const void *block);

#endif
