/* SPDX-License-Identifier: MIT
 * board/common/aarch64.c - the console and the exit of an AArch64 machine, by semihosting. */
#include <stdint.h>

#include "../board.h"
#include "semihost.h"

enum { SYS_WRITE0 = 0x04, SYS_EXIT = 0x18, ADP_APPLICATION_EXIT = 0x20026 };

void aarch64_fault(void);

intptr_t board_semihost(uintptr_t operation, const void *block)
{
    register uintptr_t x0 __asm__("x0") = operation;
    register const void *x1 __asm__("x1") = block;
    __asm__ volatile("hlt 0xf000" : "+r"(x0) : "r"(x1) : "memory");
    return (intptr_t)x0;
}

void board_print(const char *text)
{
    board_semihost(SYS_WRITE0, text);
}

void board_exit(int code)
{
    const uint64_t block[2] = {ADP_APPLICATION_EXIT, (uint64_t)code};
    board_semihost(SYS_EXIT, block);
    for (;;) {
    }
}

void aarch64_fault(void)
{
    board_print("fault\n");
    board_exit(BOARD_FAULT);
}
