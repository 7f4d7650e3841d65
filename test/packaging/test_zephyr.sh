#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The module of Zephyr: its module.yml and Kconfig are read, the kernels follow the core, and library and example build and run
# with stand-ins for the few functions of Zephyr's build that they call. Zephyr is in no package: no board is built.
. "$(dirname "$0")/common.sh"
venv_with zephyr 'kconfiglib==14.1.0' pyyaml
quietly "$venv/bin/python" - "$source_dir" "$work" <<'END'
import os, sys, yaml, kconfiglib
root, work = sys.argv[1:]
module = yaml.safe_load(open(f"{root}/zephyr/module.yml"))
assert set(module) == {"name", "build"} and set(module["build"]) == {"cmake", "kconfig"}, module
assert os.path.exists(os.path.join(root, module["build"]["cmake"], "CMakeLists.txt"))
cores = {"CPU_CORTEX_M0": "scalar", "CPU_CORTEX_M4": "arm_dsp", "CPU_CORTEX_M7": "arm_dsp", "ARMV8_M_DSP": "arm_dsp",
         "ARMV8_1_M_MVEI": "arm_mve", "ARM64": "arm_neon", "BIG_ENDIAN": "c", "64BIT": "c"}
with open(f"{work}/Kconfig", "w") as top:
    for core in cores:
        top.write(f"config {core}\n\tbool \"{core}\"\n\tselect 64BIT\n" if core == "ARM64" else f"config {core}\n\tbool \"{core}\"\n")
    top.write(f"source \"{root}/{module['build']['kconfig']}\"\n")
for core, isa in cores.items():
    config = kconfiglib.Kconfig(f"{work}/Kconfig")
    config.warn_to_stderr = True
    config.syms[core].set_value("y")
    assert config.syms["STADIMETER_ISA"].str_value == "", "kernels without the module"
    config.syms["STADIMETER"].set_value("y")
    found = config.syms["STADIMETER_ISA"].str_value
    assert found == isa, f"{core}: {found}, not {isa}"
    assert os.path.exists(f"{root}/port/isa/{found}/stad_port.h")
    assert not config.warnings, config.warnings
example = kconfiglib.Kconfig(f"{work}/Kconfig")
example.warn_assign_undef = False
example.load_config(f"{root}/examples/zephyr/prj.conf")
assert example.syms["STADIMETER"].str_value == "y", "the example does not ask for the module"
END
mkdir -p "$work/zephyr/include/zephyr" "$work/app"
printf '#include <stdio.h>\n#define printk printf\n' >"$work/zephyr/include/zephyr/kernel.h"
cat >"$work/zephyr/ZephyrConfig.cmake" <<'END'
function(zephyr_include_directories)
  include_directories(${ARGN})
endfunction()
macro(zephyr_library_named name)
  set(ZEPHYR_CURRENT_LIBRARY ${name})
  add_library(${name} STATIC)
  target_link_libraries(app PRIVATE ${name})
endmacro()
function(zephyr_library_include_directories)
  target_include_directories(${ZEPHYR_CURRENT_LIBRARY} PRIVATE ${ARGN})
endfunction()
function(zephyr_library_sources)
  target_sources(${ZEPHYR_CURRENT_LIBRARY} PRIVATE ${ARGN})
endfunction()
enable_language(C)
add_executable(app)
include_directories(${CMAKE_CURRENT_LIST_DIR}/include)
set(CONFIG_STADIMETER y)
set(CONFIG_STADIMETER_ISA scalar)
foreach(module IN LISTS ZEPHYR_EXTRA_MODULES)
  add_subdirectory(${module}/zephyr module)
endforeach()
target_include_directories(app PRIVATE "${STAD_HEADERS}")
END
sed -i "s|\${STAD_HEADERS}|$source_dir/lib/include|" "$work/zephyr/ZephyrConfig.cmake"
quietly cmake -S "$source_dir/examples/zephyr" -B "$work/build" -DZephyr_DIR="$work/zephyr" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_COMPILER="$cc"
quietly cmake --build "$work/build" -j 2
quietly "$work/build/app"
grep -q '^STAD_OK: [1-9]' "$work/log" || { cat "$work/log"; echo "FAILED: the example finds nothing"; exit 1; }
