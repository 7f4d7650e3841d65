# SPDX-License-Identifier: MIT
# The bench, and the renderer that draws what the loop is asked to live with.
file(GLOB target_scene ${PROJECT_SOURCE_DIR}/tools/scene/target_*.c)
target_sources(${name} PRIVATE ${target_scene} ${PROJECT_SOURCE_DIR}/test/support/calib_bench.c)
target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tools)
target_link_libraries(${name} PRIVATE m)
