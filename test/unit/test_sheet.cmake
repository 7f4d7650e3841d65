# SPDX-License-Identifier: MIT
# The pages without the command, and the print that they share with the renderer.
file(GLOB sheet_sources ${PROJECT_SOURCE_DIR}/tools/sheet/*.c ${PROJECT_SOURCE_DIR}/tools/scene/target_*.c ${PROJECT_SOURCE_DIR}/tools/common/fail.c ${PROJECT_SOURCE_DIR}/tools/common/whole_file.c)
target_sources(${name} PRIVATE ${sheet_sources})
target_compile_definitions(${name} PRIVATE _POSIX_C_SOURCE=200809L _XOPEN_SOURCE=700)
target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tools)
target_link_libraries(${name} PRIVATE m)
