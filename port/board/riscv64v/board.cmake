# SPDX-License-Identifier: MIT
set(BOARD_CORE "RV64GCV, VLEN 128")
set(BOARD_FAMILY riscv)
set(BOARD_FLAGS -march=rv64gcv -mabi=lp64d -mcmodel=medany)
set(BOARD_GCC riscv64-unknown-elf)
set(BOARD_CLANG_TARGET riscv64-unknown-elf)
set(BOARD_ISA riscv_v)
set(BOARD_EMULATOR qemu-system-riscv64 -M virt -cpu rv64,v=true,vext_spec=v1.0,vlen=128 -bios none -nographic -semihosting-config enable=on,target=native)
