# SPDX-License-Identifier: MIT
target_sources(test_kernel PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/kernel/room.c ${CMAKE_CURRENT_SOURCE_DIR}/kernel/case_rows.c
  ${CMAKE_CURRENT_SOURCE_DIR}/kernel/case_paths.c)
