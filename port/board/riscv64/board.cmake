# SPDX-License-Identifier: MIT
set(BOARD_CORE "RV64GC")
set(BOARD_FAMILY riscv)
set(BOARD_FLAGS -march=rv64gc -mabi=lp64d -mcmodel=medany)
set(BOARD_GCC riscv64-unknown-elf)
set(BOARD_CLANG_TARGET riscv64-unknown-elf)
set(BOARD_ISA c)
set(BOARD_EMULATOR qemu-system-riscv64 -M virt -bios none -nographic -semihosting-config enable=on,target=native)
