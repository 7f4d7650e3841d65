/* SPDX-License-Identifier: MIT
 * board/common/riscv.c - the console and the exit of QEMU's `virt` machine, 32 and 64 bits
 *
 * A 16550 UART that takes a byte at any time, and the test device: 0x5555 is success, (code << 16) + 0x3333 failure; files
 * by semihosting. */
#include <stdint.h>

#include "../board.h"
#include "semihost.h"

#define UART_DATA   (*(volatile uint8_t *)0x10000000u)
#define TEST_FINISH (*(volatile uint32_t *)0x00100000u)

void riscv_fault(void);

/* Three instructions of full length mark the trap. */
intptr_t board_semihost(uintptr_t operation, const void *block)
{
    register uintptr_t a0 __asm__("a0") = operation;
    register const void *a1 __asm__("a1") = block;
    __asm__ volatile(".option push\n\t.option norvc\n\t.balign 16\n\tslli x0, x0, 0x1f\n\tebreak\n\tsrai x0, x0, 7\n\t"
                     ".option pop"
                     : "+r"(a0)
                     : "r"(a1)
                     : "memory");
    return (intptr_t)a0;
}

void board_print(const char *text)
{
    while (*text != '\0')
        UART_DATA = (uint8_t)*text++;
}

void board_exit(int code)
{
    TEST_FINISH = code == 0 ? 0x5555u : ((uint32_t)code << 16) + 0x3333u;
    for (;;) {
    }
}

void riscv_fault(void)
{
    board_print("fault\n");
    board_exit(BOARD_FAULT);
}
