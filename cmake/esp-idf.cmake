# SPDX-License-Identifier: MIT
# The library as a component of ESP-IDF, with the kernels for 32-bit cores without SIMD.
get_filename_component(STAD_ROOT ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
set(STAD_PORT_DIR ${STAD_ROOT}/port/isa/scalar)
file(GLOB STAD_SOURCES ${STAD_ROOT}/lib/src/*/*.c ${STAD_PORT_DIR}/*.c)
idf_component_register(SRCS ${STAD_SOURCES} INCLUDE_DIRS ${STAD_ROOT}/lib/include
  PRIV_INCLUDE_DIRS ${STAD_ROOT}/lib/src ${STAD_PORT_DIR})
