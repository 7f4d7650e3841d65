#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Flash, RAM and worst stack of the library on microcontrollers, as one table, and the limits they must keep.

budget.py [--table FILE]    exit 1 when a limit is exceeded; the last line counts. Needs arm-none-eabi-gcc.

Flash: .text + .rodata of the library in a program that uses one feature, compiler's run-time routines included, memcpy and
memset not. Stack: the deepest chain of calls of every public function, from gcc's -fstack-usage and -fcallgraph-info=su;
recursion and calls through pointers end the analysis and are failures, but for the three functions of the caller's flash.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BOARD = ROOT / "port/board"
CC = "arm-none-eabi-gcc"
M4 = "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16".split()
M0 = "-mcpu=cortex-m0plus -mthumb".split()
CORES = {"M0+ -Os": (["-Os"] + M0, "c"), "M4 -Os": (["-Os"] + M4, "c"), "M4 -O2": (["-O2"] + M4, "c"), "M4 DSP -O2": (["-O2"] + M4, "arm_dsp")}
LIMITED = "M4 -Os"
SHOWN = {"M0+ -Os"}  # in the table, but not held to the limits: 8 low registers make larger frames
FEATURES = ["match", "one_mode", "one_mode_tune", "tune", "match_tune", "mark", "monitor", "store", "chain"]
FLASH_LIMIT = {"one_mode": 12 * 1024, "one_mode_tune": 20 * 1024, "chain": 48 * 1024}
ENTRY = {"one_mode": "match", "one_mode_tune": "match_tune"}
# How a firmware that will never ask for another mode than SGBM, nor for path state in bytes (the small plan's, up to P2 255),
# leaves them out (docs/PORTING.md).
ONE_MODE = ["-Wl,--defsym=stad_mode_3way_step=stad_mode_sgbm_step", "-Wl,--defsym=stad_mode_hh_step=stad_mode_sgbm_step",
            "-Wl,--defsym=stad_mode_hh4_step=stad_mode_sgbm_step", "-Wl,--defsym=stad_mode_two_pass_feed=stad_mode_sgbm_step",
            "-Wl,--defsym=stad_best_row_3way_c=stad_best_row_c", "-Wl,--defsym=stad_path_row_u8_c=stad_path_row_sat_c"]
STACK_LIMIT = 1023
FRAME_LIMIT = 256  # a function of lib/
CALLERS = {"read", "program", "erase"}  # stad_flash: their stack is the caller's
FREESTANDING = {"memcpy", "memset"}

checks = []


def check(name, good, detail):
    checks.append(good)
    print(f"{'ok  ' if good else 'FAIL'} {name}: {detail}")


def run(*command):
    done = subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}")
    return done.stdout


def compile_library(core, folder):
    """Objects of lib/ and of the port, with stack and call graph beside them."""
    flags, port = CORES[core]
    sources = sorted((ROOT / "lib/src").glob("*/*.c")) + (sorted((ROOT / "port/isa" / port).glob("*.c")) if port != "c" else [])
    folder.mkdir()
    for source in sources + [ROOT / "test/budget/features.c"]:
        run(CC, *flags, "-std=c99", "-ffreestanding", "-fbuiltin", "-ffunction-sections", "-fdata-sections", "-fstack-usage",
            "-fcallgraph-info=su", "-isystem", BOARD / "libc", "-I", ROOT / "lib/include", "-I", ROOT / "lib/src", "-I",
            ROOT / "port/isa" / port, "-c", source, "-o", folder / (source.stem + ".o"))
    run(CC, *flags, "-std=c99", "-ffreestanding", "-fno-builtin", "-fno-tree-loop-distribute-patterns", "-isystem",
        BOARD / "libc", "-c", BOARD / "common/memory.c", "-o", folder / "memory.obj")
    return sorted(folder.glob("*.o"))


def flash(core, objects, folder, feature):
    program = folder / (feature + ".elf")
    entry = "-Wl,-e,feature_" + ENTRY.get(feature, feature)
    run(CC, *CORES[core][0], "-nostdlib", "-Wl,--gc-sections", entry, *(ONE_MODE if feature in ENTRY else []), *objects,
        folder / "memory.obj", "-lgcc", "-o", program)
    sizes = {}
    for line in run("arm-none-eabi-size", "-A", program).splitlines():
        parts = line.split()
        if len(parts) == 3 and parts[0].startswith("."):
            sizes[parts[0]] = int(parts[1])
    own = 0
    for line in run("arm-none-eabi-nm", "-S", program).splitlines():
        parts = line.split()
        if len(parts) == 4 and (parts[3].startswith("feature_") or parts[3] in ("memcpy", "memset", "memmove", "memcmp")):
            own += int(parts[1], 16)
    return sizes.get(".text", 0) + sizes.get(".rodata", 0) - own


def call_graph(folder):
    """{function: own bytes}, {function: called}; a name that is static carries its file."""
    own, calls, labels = {}, {}, {}
    for graph in folder.glob("*.ci"):
        for line in graph.read_text().splitlines():
            node = re.match(r'node: \{ title: "([^"]+)" label: "([^"]*)"', line)
            edge = re.match(r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"(?: label: "([^"]*)")?', line)
            if node:
                bytes_used = re.search(r"(\d+) bytes \((\w+)", node[2])
                if bytes_used:
                    own[node[1]] = int(bytes_used[1])
                    labels[node[1]] = bytes_used[2]
            elif edge:
                calls.setdefault(edge[1], set()).add((edge[2], edge[3] or ""))
    return own, calls, labels


class Unbounded(Exception):
    pass


def worst(function, own, calls, memo, trail):
    """Bytes of the deepest chain from here, and the chain."""
    if function in trail:
        raise Unbounded("recursion: " + " -> ".join(trail + (function,)))
    if function not in memo:
        deepest = (0, ())
        for called, where in calls.get(function, ()):
            if called == "__indirect_call":
                if "store.c" not in where:
                    raise Unbounded(f"{function} calls through a pointer at {where}")
                continue
            if called not in own:  # memcpy, memset and libgcc's arithmetic: leaves of a few words
                chain = (32, (called,))
            else:
                chain = worst(called, own, calls, memo, trail + (function,))
            deepest = max(deepest, chain)
        memo[function] = (own[function] + deepest[0], (function,) + deepest[1])
    return memo[function]


def stack(core, folder):
    own, calls, labels = call_graph(folder)
    memo, results, trouble = {}, [], []
    for function in own:
        if function.startswith("stad_") and ":" not in function:
            try:
                results.append(worst(function, own, calls, memo, ()))
            except Unbounded as reason:
                trouble.append(str(reason))
    big = {f: n for f, n in own.items() if n > FRAME_LIMIT}
    dynamic = [f for f, kind in labels.items() if kind.startswith("dynamic")]
    results.sort(reverse=True)
    check(f"{core} stack can be bounded", not trouble and not dynamic, "; ".join(sorted(set(trouble)) + dynamic)
          or f"{len(results)} public functions, no recursion, no unknown call")
    if core not in SHOWN:
        check(f"{core} stack of a function <= {FRAME_LIMIT}", not big, ", ".join(f"{f} {n}" for f, n in big.items())
              or f"largest {max(own.values())}")
        check(f"{core} worst stack <= {STACK_LIMIT}", results[0][0] <= STACK_LIMIT,
              f"{results[0][0]} bytes: " + " > ".join(f.split(':')[-1] for f in results[0][1]))
    by_name = {chain[0]: total for total, chain in results}
    return results[0][0], by_name


def freestanding(folder, objects):
    """What the library calls and does not hold, but for the compiler's own run-time."""
    library = [o for o in objects if o.stem != "features"]
    run(CC, *M4, "-r", "-nostdlib", *library, "-o", folder / "all.rel")
    names = {line.split()[-1] for line in run("arm-none-eabi-nm", "-u", folder / "all.rel").splitlines() if line.strip()}
    runtime = {n for n in names if n.startswith("__aeabi_")}
    check("lib/ freestanding needs only " + ", ".join(sorted(FREESTANDING)), names - runtime <= FREESTANDING,
          f"{', '.join(sorted(names - runtime))}; of the compiler's run-time: {', '.join(sorted(runtime)) or 'nothing'}")


def ram():
    """Bytes of workspace by geometry, from the header's constant expressions."""
    modes = ["SGBM", "HH", "3WAY", "HH4"]
    sizes = [(160, 120, 32), (320, 240, 64), (640, 480, 64), (640, 480, 128)]
    lines = "".join(f'printf("{w}x{h} D{d},%lu,%lu,%lu,%lu,%lu,%lu,%lu,%lu\\n"' + "".join(
        f", (unsigned long)STAD_MATCH_BYTES({w}, {h}, 1, {d}, 5, 800, 63, STAD_MODE_{m}, {plan})" for m in modes
        for plan in (0, 1)) + ");\n" for w, h, d in sizes)
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder, "ram.c")
        source.write_text('#include <stdio.h>\n#include "stad/stad.h"\nint main(void)\n{\n' + lines + "return 0;\n}\n")
        run("cc", "-I", ROOT / "lib/include", source, "-o", source.with_suffix(""))
        return [line.split(",") for line in run(source.with_suffix("")).splitlines()]


def main():
    parse = argparse.ArgumentParser(usage=__doc__)
    parse.add_argument("--table", type=pathlib.Path)
    args = parse.parse_args()
    if shutil.which(CC) is None:
        print(f"budget: UNAVAILABLE ({CC} is not installed)\n0 passed, 0 failed, 1 skipped")
        return 0
    flashes, stacks, named = {}, {}, {}
    with tempfile.TemporaryDirectory() as scratch:
        for core in CORES:
            folder = pathlib.Path(scratch, core.replace(" ", "_"))
            objects = compile_library(core, folder)
            for feature in FEATURES:
                flashes[core, feature] = flash(core, objects, folder, feature)
            stacks[core], named[core] = stack(core, folder)
            if core == LIMITED:
                freestanding(folder, objects)
    for feature, limit in FLASH_LIMIT.items():
        size = flashes[LIMITED, feature]
        check(f"{LIMITED} flash of {feature} <= {limit}", size <= limit, f"{size} bytes")
    text = "| flash, bytes | " + " | ".join(CORES) + " |\n|---|" + "---|" * len(CORES) + "\n"
    for feature in FEATURES:
        text += f"| {feature.replace('_', ' + ')} | " + " | ".join(str(flashes[core, feature]) for core in CORES) + " |\n"
    text += "| worst stack | " + " | ".join(str(stacks[core]) for core in CORES) + " |\n\n"
    text += "| workspace, bytes, block 5 | SGBM fast | small | HH fast | small | 3WAY fast | small | HH4 fast | small |\n"
    text += "|---|" + "---|" * 8 + "\n" + "".join("| " + " | ".join(row) + " |\n" for row in ram())
    print("\n" + text)
    if args.table:
        args.table.write_text(text)
    print(f"{sum(checks)} passed, {len(checks) - sum(checks)} failed, 0 skipped")
    return 0 if all(checks) else 1


sys.exit(main())
