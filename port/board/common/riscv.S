/* SPDX-License-Identifier: MIT
 * board/common/riscv.S - [RESET] -> start -> main, for 32 and 64 bits
 *
 * mstatus.FS and .VS first (bits without a unit behind them stay zero), then a trap vector that ends the run. */
    .option arch, +zicsr            /* here alone: gcc has no run-time library by that name */
    .section .reset, "ax"
    .globl reset
reset:
    li      t0, 0x6600
    csrs    mstatus, t0
    la      t0, trap
    csrw    mtvec, t0
    la      sp, stack_top
    call    board_start

    .balign 4
trap:
    la      sp, stack_top
    call    riscv_fault
