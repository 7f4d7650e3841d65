#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The component of ESP-IDF: compote takes the manifest and packs it; what it packed builds and runs by itself, with a stand-in
# for idf_component_register() in place of ESP-IDF, which is in no package.
. "$(dirname "$0")/common.sh"
venv_with idf-component-manager 'idf-component-manager~=3.1'
copy_source "$work/copy"
cd "$work/copy"
export IDF_TOOLS_PATH=$work/tools
quietly "$venv/bin/compote" component pack --name stadimeter
grep -q 'WARNING' "$work/log" && { cat "$work/log"; echo "FAILED: compote warns"; exit 1; }
archive=dist/stadimeter_$version.tgz
[ -s "$archive" ] || { ls dist; echo "FAILED: no $archive"; exit 1; }
mkdir "$work/component" "$work/project"
tar -xzf "$archive" -C "$work/component"
if [ -e "$work/component/tools" ] || [ -e "$work/component/test" ]; then echo "FAILED: more was packed than the library"; exit 1; fi
printf 'void app_main(void);\nint main(void) { app_main(); return 0; }\n' >"$work/app.c"
build_with() { # FOLDER_OF_THE_COMPONENT
    rm -rf "$work/project/build"
    cat >"$work/project/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.16)
project(consumer LANGUAGES C)
set(ESP_PLATFORM 1)
function(idf_component_register)
  cmake_parse_arguments(ARG "" "" "SRCS;INCLUDE_DIRS;PRIV_INCLUDE_DIRS;REQUIRES" \${ARGN})
  add_library(component STATIC \${ARG_SRCS})
  target_include_directories(component PUBLIC \${ARG_INCLUDE_DIRS} PRIVATE \${ARG_PRIV_INCLUDE_DIRS})
endfunction()
add_subdirectory("$1" component)
add_executable(main "$work/main.c")
target_link_libraries(main PRIVATE component)
add_executable(app "$source_dir/examples/esp-idf/main/main.c" "$work/app.c")
target_link_libraries(app PRIVATE component)
END
    quietly cmake -S "$work/project" -B "$work/project/build" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_COMPILER="$cc"
    quietly cmake --build "$work/project/build" -j 2
    quietly "$work/project/build/main"
    quietly "$work/project/build/app"
    grep -q '^STAD_OK: [1-9]' "$work/log" || { cat "$work/log"; echo "FAILED: the example finds nothing"; exit 1; }
}
build_with "$work/component"
build_with "$work/copy/examples/esp-idf/components/stadimeter"
