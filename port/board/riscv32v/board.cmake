# SPDX-License-Identifier: MIT
set(BOARD_CORE "RV32IMAC + Zve32x, VLEN 128")
set(BOARD_FAMILY riscv)
set(BOARD_FLAGS -march=rv32imac_zve32x_zvl128b -mabi=ilp32 -mcmodel=medany)
set(BOARD_GCC riscv64-unknown-elf)
set(BOARD_CLANG_TARGET riscv32-unknown-elf)
set(BOARD_ISA riscv_v)
set(BOARD_EMULATOR qemu-system-riscv32 -M virt -cpu rv32,v=true,vext_spec=v1.0,vlen=128 -bios none -nographic -semihosting-config enable=on,target=native)
