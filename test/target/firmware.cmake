# SPDX-License-Identifier: MIT
# The kernels of the port against C, for the board of the preset or the host; included by examples/CMakeLists.txt.
add_executable(kernels ${CMAKE_CURRENT_LIST_DIR}/kernels.c ${CMAKE_CURRENT_LIST_DIR}/kernels_bench.c
  ${CMAKE_CURRENT_LIST_DIR}/kernels_rows.c ${CMAKE_CURRENT_LIST_DIR}/kernels_paths.c ${PROJECT_SOURCE_DIR}/examples/mcu/say.c)
stad_warnings(kernels)
target_include_directories(kernels PRIVATE ${PROJECT_SOURCE_DIR}/examples/mcu ${PROJECT_SOURCE_DIR}/lib/src
  $<TARGET_PROPERTY:stadimeter,INCLUDE_DIRECTORIES>)
target_link_libraries(kernels PRIVATE stad_board stadimeter)
stad_board_runner(kernels)
