# SPDX-License-Identifier: MIT
# clang for one board of port/board: -D STAD_BOARD=<name>. Arithmetic the core lacks comes from gcc's libgcc.
include(${CMAKE_CURRENT_LIST_DIR}/board.cmake)
set(STAD_CLANG 19 CACHE STRING "Version suffix of clang and lld")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES STAD_CLANG)
set(CMAKE_C_COMPILER clang-${STAD_CLANG})
set(CMAKE_ASM_COMPILER clang-${STAD_CLANG})
set(CMAKE_C_COMPILER_TARGET ${BOARD_CLANG_TARGET})
set(CMAKE_ASM_COMPILER_TARGET ${BOARD_CLANG_TARGET})
set(CMAKE_C_FLAGS_INIT "${STAD_BOARD_C_FLAGS}")
if(BOARD_FAMILY STREQUAL cortex_m)
  string(APPEND CMAKE_C_FLAGS_INIT " -meabi gnu") # copies call memcpy, not __aeabi_memcpy4
endif()
string(APPEND CMAKE_C_FLAGS_INIT " -fomit-frame-pointer") # as gcc does
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -static -fuse-ld=lld-${STAD_CLANG}")
# gcc knows its libraries by the base architecture: strip the vector extension.
string(REGEX REPLACE "_zve[0-9a-z_]*" "" STAD_GCC_FLAGS "${STAD_BOARD_FLAGS}")
string(REPLACE "rv64gcv" "rv64gc" STAD_GCC_FLAGS "${STAD_GCC_FLAGS}")
separate_arguments(STAD_GCC_FLAGS)
execute_process(COMMAND ${BOARD_GCC}-gcc ${STAD_GCC_FLAGS} -print-libgcc-file-name
  OUTPUT_VARIABLE STAD_LIBGCC OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
set(CMAKE_C_STANDARD_LIBRARIES "${STAD_LIBGCC}")
set(STAD_ISA ${BOARD_ISA} CACHE STRING "Kernels to use: a folder of port/isa")
