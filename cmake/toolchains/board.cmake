# SPDX-License-Identifier: MIT
# What every compiler of a board shares; included by gcc.cmake and clang.cmake.
set(STAD_BOARD "" CACHE STRING "A folder of port/board")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES STAD_BOARD)
cmake_path(SET STAD_BOARD_DIR NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../../port/board)
include(${STAD_BOARD_DIR}/${STAD_BOARD}/board.cmake)
list(JOIN BOARD_FLAGS " " STAD_BOARD_FLAGS)
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR ${BOARD_FAMILY})
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_CROSSCOMPILING_EMULATOR ${BOARD_EMULATOR} -kernel)
set(STAD_BOARD_C_FLAGS "${STAD_BOARD_FLAGS} -ffunction-sections -fdata-sections -isystem ${STAD_BOARD_DIR}/libc")
set(CMAKE_ASM_FLAGS_INIT "${STAD_BOARD_FLAGS}")
set(CMAKE_C_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "As a firmware is built")
