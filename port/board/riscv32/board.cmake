# SPDX-License-Identifier: MIT
set(BOARD_CORE "RV32IMAC")
set(BOARD_FAMILY riscv)
set(BOARD_FLAGS -march=rv32imac -mabi=ilp32 -mcmodel=medany)
set(BOARD_GCC riscv64-unknown-elf)
set(BOARD_CLANG_TARGET riscv32-unknown-elf)
set(BOARD_ISA scalar)
set(BOARD_EMULATOR qemu-system-riscv32 -M virt -bios none -nographic -semihosting-config enable=on,target=native)
