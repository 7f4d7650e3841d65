# SPDX-License-Identifier: MIT
# gcc for another Linux, run by user-mode emulation: -D STAD_LINUX=powerpc-linux-gnu (big-endian), aarch64-linux-gnu,
# arm-linux-gnueabihf.
set(STAD_LINUX "" CACHE STRING "Triple of the target Linux")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES STAD_LINUX)
string(REGEX MATCH "^[^-]*" STAD_LINUX_CORE "${STAD_LINUX}")
string(REPLACE powerpc ppc STAD_LINUX_CORE "${STAD_LINUX_CORE}")
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR ${STAD_LINUX_CORE})
set(CMAKE_C_COMPILER ${STAD_LINUX}-gcc)

set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-${STAD_LINUX_CORE})
if(STAD_LINUX_CORE STREQUAL arm)
  string(APPEND CMAKE_C_FLAGS_INIT " -march=armv7-a+simd -mfpu=neon")
  set(STAD_ISA arm_neon CACHE STRING "Kernels to use: a folder of port/isa")
endif()
