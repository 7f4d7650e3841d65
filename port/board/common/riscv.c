/* SPDX-License-Identifier: MIT
 * board/common/riscv.c - the console and the exit of QEMU's `virt` machine, 32 and 64 bits
 *
 * A 16550 UART that takes a byte at any time, and the test device: 0x5555 is success, (code << 16) + 0x3333 failure. */
#include <stdint.h>

#include "../board.h"

#define UART_DATA   (*(volatile uint8_t *)0x10000000u)
#define TEST_FINISH (*(volatile uint32_t *)0x00100000u)

void riscv_fault(void);

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
