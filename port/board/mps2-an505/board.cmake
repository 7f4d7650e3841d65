# SPDX-License-Identifier: MIT
set(BOARD_CORE "Cortex-M33")
set(BOARD_FAMILY cortex_m)
set(BOARD_FLAGS -mcpu=cortex-m33 -mthumb -mfloat-abi=hard -mfpu=fpv5-sp-d16)
set(BOARD_GCC arm-none-eabi)
set(BOARD_CLANG_TARGET thumbv8m.main-none-eabihf)
set(BOARD_ISA arm_dsp)
set(BOARD_EMULATOR qemu-system-arm -M mps2-an505 -nographic -semihosting-config enable=on,target=native)
