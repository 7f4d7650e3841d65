/* SPDX-License-Identifier: MIT
 * board/common/cortex_m.c - [RESET] -> start -> main, and the console, for every Cortex-M
 *
 * Vector table, coprocessors on before anything else (compilers vectorise even the loop that clears .bss), output and
 * exit by semihosting. */
#include <stdint.h>

#include "../board.h"
#include "semihost.h"
#include "start.h"

enum { SYS_WRITE0 = 0x04, SYS_EXIT_EXTENDED = 0x20, ADP_APPLICATION_EXIT = 0x20026 };

#define CPACR (*(volatile uint32_t *)0xE000ED88u)
enum { CPACR_CP10_CP11 = 0xF << 20 }; /* FPU and MVE; on a core without them the bits stay zero */

extern uint32_t stack_top[];
void reset(void);

intptr_t board_semihost(uintptr_t operation, const void *block)
{
    register uintptr_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = block;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return (intptr_t)r0;
}

void board_print(const char *text)
{
    board_semihost(SYS_WRITE0, text);
}

void board_exit(int code)
{
    const uint32_t block[2] = {ADP_APPLICATION_EXIT, (uint32_t)code};
    board_semihost(SYS_EXIT_EXTENDED, block);
    for (;;) {
    }
}

void reset(void)
{
    CPACR |= CPACR_CP10_CP11;
    __asm__ volatile("dsb\n\tisb" ::: "memory");
    board_start();
}

static void fault(void)
{
    board_print("fault\n");
    board_exit(BOARD_FAULT);
}

typedef void (*vector)(void);

/* The stack's top, reset, then NMI to SysTick: nothing here runs on interrupts, so any of them is a fault. */
__attribute__((section(".vectors"), used)) static const struct {
    const uint32_t *stack;
    vector handlers[15];
} vectors = {stack_top,
             {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault}};
