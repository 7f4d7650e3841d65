/* SPDX-License-Identifier: MIT
 * board/common/aarch64.S - [RESET] -> start -> main, at EL1
 *
 * Vectors, FP and NEON on, then an identity map of 1 GiB blocks: the first Device, the second (RAM) Normal. Without a map all
 * memory is Device, where an unaligned load faults on silicon. */
    .section .reset, "ax"
    .globl reset
reset:
    ldr     x0, =vectors
    msr     vbar_el1, x0
    mov     x0, #(3 << 20)
    msr     cpacr_el1, x0
    isb
    ldr     x0, =stack_top
    mov     sp, x0

    ldr     x0, =0xff00             /* attribute 0 Device-nGnRnE, 1 Normal write-back */
    msr     mair_el1, x0
    ldr     x0, =0x803519           /* T0SZ 25: 39 bits; write-back, inner shareable walks; no TTBR1 */
    msr     tcr_el1, x0
    ldr     x0, =level1
    msr     ttbr0_el1, x0
    isb
    mrs     x0, sctlr_el1
    ldr     x1, =0x1005             /* M, C, I */
    orr     x0, x0, x1
    msr     sctlr_el1, x0
    isb
    bl      board_start

fault:
    ldr     x0, =stack_top
    mov     sp, x0
    bl      aarch64_fault

    .balign 2048
vectors:
    .rept 16
    b       fault
    .balign 128
    .endr

    .section .rodata
    .balign 4096
level1:
    .quad   0x00000000 | 0x0060000000000401     /* never executed, Device */
    .quad   0x40000000 | 0x0000000000000705     /* RAM: accessed, inner shareable, Normal */
    .fill   510, 8, 0
