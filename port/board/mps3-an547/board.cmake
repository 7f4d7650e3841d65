# SPDX-License-Identifier: MIT
set(BOARD_CORE "Cortex-M55")
set(BOARD_FAMILY cortex_m)
set(BOARD_FLAGS -mcpu=cortex-m55 -mthumb -mfloat-abi=hard)
set(BOARD_GCC arm-none-eabi)
set(BOARD_CLANG_TARGET thumbv8.1m.main-none-eabihf)
set(BOARD_ISA arm_mve)
set(BOARD_EMULATOR qemu-system-arm -M mps3-an547 -nographic -semihosting-config enable=on,target=native)
