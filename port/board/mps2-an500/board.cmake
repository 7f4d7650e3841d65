# SPDX-License-Identifier: MIT
set(BOARD_CORE "Cortex-M7")
set(BOARD_FAMILY cortex_m)
set(BOARD_FLAGS -mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16)
set(BOARD_GCC arm-none-eabi)
set(BOARD_CLANG_TARGET thumbv7em-none-eabihf)
set(BOARD_ISA arm_dsp)
set(BOARD_EMULATOR qemu-system-arm -M mps2-an500 -nographic -semihosting-config enable=on,target=native)
