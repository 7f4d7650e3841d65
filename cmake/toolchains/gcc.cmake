# SPDX-License-Identifier: MIT
# gcc for one board of port/board: -D STAD_BOARD=<name>.
include(${CMAKE_CURRENT_LIST_DIR}/board.cmake)
set(CMAKE_C_COMPILER ${BOARD_GCC}-gcc)
set(CMAKE_ASM_COMPILER ${BOARD_GCC}-gcc)
# Freestanding, so that gcc brings its own stdint.h; builtins stay, so that small copies need no call.
set(CMAKE_C_FLAGS_INIT "${STAD_BOARD_C_FLAGS} -ffreestanding -fbuiltin")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -static")
set(CMAKE_C_STANDARD_LIBRARIES "-lgcc")
if(BOARD_ISA STREQUAL riscv_v)
  set(BOARD_ISA c) # gcc 12 has no vector intrinsics for RISC-V
endif()
set(STAD_ISA ${BOARD_ISA} CACHE STRING "Kernels to use: a folder of port/isa")
