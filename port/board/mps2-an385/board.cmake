# SPDX-License-Identifier: MIT
set(BOARD_CORE "Cortex-M3")
set(BOARD_FAMILY cortex_m)
set(BOARD_FLAGS -mcpu=cortex-m3 -mthumb)
set(BOARD_GCC arm-none-eabi)
set(BOARD_CLANG_TARGET thumbv7m-none-eabi)
set(BOARD_ISA scalar)
set(BOARD_EMULATOR qemu-system-arm -M mps2-an385 -nographic -semihosting-config enable=on,target=native)
