# SPDX-License-Identifier: MIT
# x86: each tier's file is compiled for its tier, the rest for the baseline.
target_sources(stadimeter PRIVATE ${STAD_PORT_DIR}/dispatch.c ${STAD_PORT_DIR}/kernels_sse41.c
  ${STAD_PORT_DIR}/select_row_sse41.c
  ${STAD_PORT_DIR}/kernels_avx2.c
  ${STAD_PORT_DIR}/kernels_avx512.c)
set_source_files_properties(${STAD_PORT_DIR}/kernels_sse41.c ${STAD_PORT_DIR}/select_row_sse41.c TARGET_DIRECTORY stadimeter
  PROPERTIES COMPILE_OPTIONS "-msse4.1;-mpopcnt")
set_source_files_properties(${STAD_PORT_DIR}/kernels_avx2.c TARGET_DIRECTORY stadimeter
  PROPERTIES COMPILE_OPTIONS "-mavx2;-mbmi;-mpopcnt")
set_source_files_properties(${STAD_PORT_DIR}/kernels_avx512.c TARGET_DIRECTORY stadimeter
  PROPERTIES COMPILE_OPTIONS "-mavx512f;-mavx512bw;-mavx2;-mbmi;-mpopcnt")
