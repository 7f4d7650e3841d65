# SPDX-License-Identifier: MIT
set(BOARD_CORE "Cortex-A53")
set(BOARD_FAMILY aarch64)
set(BOARD_FLAGS -mcpu=cortex-a53 -fno-pie)
set(BOARD_OPTIMIZE -O3) # flash is no matter here, and gcc 12 vectorises little below
set(BOARD_GCC aarch64-linux-gnu)
set(BOARD_CLANG_TARGET aarch64-none-elf)
set(BOARD_ISA arm_neon)
set(BOARD_EMULATOR qemu-system-aarch64 -M virt -cpu cortex-a53 -nic none -nographic -semihosting-config enable=on,target=native)
