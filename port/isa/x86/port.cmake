# SPDX-License-Identifier: MIT
# x86: each tier's files are compiled for their tier, the rest for the baseline.
file(GLOB STAD_PORT_SSE41 CONFIGURE_DEPENDS ${STAD_PORT_DIR}/*_sse41.c)
target_sources(stadimeter PRIVATE ${STAD_PORT_DIR}/dispatch.c ${STAD_PORT_SSE41}
  ${STAD_PORT_DIR}/kernels_avx2.c
  ${STAD_PORT_DIR}/kernels_avx512.c)
set_source_files_properties(${STAD_PORT_SSE41} TARGET_DIRECTORY stadimeter
  PROPERTIES COMPILE_OPTIONS "-msse4.1;-mpopcnt")
set_source_files_properties(${STAD_PORT_DIR}/kernels_avx2.c TARGET_DIRECTORY stadimeter
  PROPERTIES COMPILE_OPTIONS "-mavx2;-mbmi;-mpopcnt")
set_source_files_properties(${STAD_PORT_DIR}/kernels_avx512.c TARGET_DIRECTORY stadimeter
  PROPERTIES COMPILE_OPTIONS "-mavx512f;-mavx512bw;-mavx2;-mbmi;-mpopcnt")
