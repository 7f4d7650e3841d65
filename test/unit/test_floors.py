#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Who may include whom: the floors of docs/ARCHITECTURE.md, checked on every #include of the tree."""
import os
import re
import sys

ROOT = os.environ.get("STAD_SOURCE") or os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
PLAIN = {"stdint.h", "stddef.h", "limits.h", "string.h"}
FLOORS = {  # module: modules of lib/src whose insides it may see
    "base": set(),
    "kernel": {"base"},
    "match": {"base", "kernel"},
    "mark": {"base", "kernel"},
    "tune": {"base"},
    "truth": {"base"},
    "rig": {"base"},
    "score": {"base"},
    "store": {"base"},
    "monitor": {"base"},
    "depth": {"base"},
    "calib": {"base", "kernel", "match", "mark", "tune", "truth", "rig", "score", "store", "monitor"},
}
IMAGE_HEADERS = {"stad/image.h", "stad/match.h", "stad/mark.h", "stad/stad.h", "stad/score.h", "stad/truth.h"}
PUBLIC_ONLY = ["tools", "examples", "test/golden", "test/property", "test/target", "test/support"]
KERNEL_TESTS = {os.path.join("test", "target", name) for name in ("kernels.c", "kernels_rows.c", "kernels_paths.c")}  # compares kernels, as test/kernel does
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.M)


def sources(folder):
    for path, _, files in os.walk(os.path.join(ROOT, folder)):
        for name in sorted(files):
            if name.endswith((".c", ".h", ".cpp", ".hpp")):
                full = os.path.join(path, name)
                with open(full, encoding="utf-8") as text:
                    yield os.path.relpath(full, ROOT), text.read()


def complaint_in_library(module, path, bracket, name):
    if bracket == "<":
        checked = name == "assert.h" and path.endswith("base/arith.h")
        return None if name in PLAIN or checked else "system header"
    if name.startswith("stad/"):
        return "tune knows no image" if module == "tune" and name in IMAGE_HEADERS else None
    if "/" not in name:
        beside = os.path.exists(os.path.join(ROOT, os.path.dirname(path), name))
        return None if beside or name == "stad_port.h" and module == "kernel" else "neither beside the file nor a module"
    other = name.split("/")[0]
    return None if other == module or other in FLOORS[module] else "floor of " + other


def complaints():
    for path, text in sources("lib/src"):
        module = path.split(os.sep)[2]
        for bracket, name in INCLUDE.findall(text):
            why = complaint_in_library(module, path, bracket, name) if module in FLOORS else "unknown module " + module
            if why:
                yield path, name, why
    for path, text in sources("lib/include"):
        for bracket, name in INCLUDE.findall(text):
            if name not in PLAIN and not name.startswith("stad/"):
                yield path, name, "public headers include the four plain headers and each other"
    for path, text in sources("port/isa"):
        for bracket, name in INCLUDE.findall(text):
            if bracket == '"' and name.split("/")[0] in set(FLOORS) - {"base", "kernel"}:
                yield path, name, "a port sees base and kernel"
    for folder in PUBLIC_ONLY:
        for path, text in sources(folder):
            for bracket, name in INCLUDE.findall(text) if path not in KERNEL_TESTS else []:
                if "lib/src" in name or os.path.exists(os.path.join(ROOT, "lib", "src", name)):
                    yield path, name, "only public headers here"


def main():
    found = list(complaints())
    for path, name, why in found:
        print(f"{path}: includes {name}: {why}")
    count = sum(1 for _ in sources("lib/src"))
    print(f"{count} library files, {len(found)} includes against the floors")
    sys.exit(1 if found or count == 0 else 0)


main()
