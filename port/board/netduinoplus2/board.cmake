# SPDX-License-Identifier: MIT
set(BOARD_CORE "STM32F405, Cortex-M4F")
set(BOARD_FAMILY cortex_m)
set(BOARD_FLAGS -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16)
set(BOARD_GCC arm-none-eabi)
set(BOARD_CLANG_TARGET thumbv7em-none-eabihf)
set(BOARD_ISA arm_dsp)
set(BOARD_EMULATOR qemu-system-arm -M netduinoplus2 -nographic -semihosting-config enable=on,target=native)
