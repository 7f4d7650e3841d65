#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Which kernels each port has of its own, as a table: what its stad_port.h binds; the rest is plain C.

ports.py             prints the table; exit 1 when docs/PORTING.md shows another
ports.py --update    writes it there
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PAGE = ROOT / "docs/PORTING.md"
PORTS = {"wide": "any that vectorises", "scalar": "M0+, M3, RV32IMAC", "arm_dsp": "M4, M7, M33", "arm_mve": "M55", "arm_neon": "A64, A32",
         "riscv_v": "V, Zve32x", "x86": "SSE4.1, AVX2, AVX-512"}


def bound(header):
    return re.findall(r"^#\s*define stad_(\w+)\s+stad_\w+$", header.read_text(), re.MULTILINE)


def table():
    kernels = bound(ROOT / "lib/src/kernel/bind_c.h")
    own = {port: set(bound(ROOT / "port/isa" / port / "stad_port.h")) for port in PORTS}
    lines = ["| kernel | " + " | ".join(f"{port} ({cores})" for port, cores in PORTS.items()) + " |",
             "|---|" + "---|" * len(PORTS)]
    for kernel in kernels:
        lines.append(f"| {kernel} | " + " | ".join("x" if kernel in own[port] else "C" for port in PORTS) + " |")
    return "\n".join(lines) + "\n"


def main():
    text, page = table(), PAGE.read_text()
    shown = re.search(r"^\| kernel \|.*\n(\|.*\n)+", page, re.MULTILINE)
    print(text)
    if "--update" in sys.argv[1:]:
        PAGE.write_text(page[:shown.start()] + text + page[shown.end():])
    elif shown[0] != text:
        print("docs/PORTING.md shows another table: test/budget/ports.py --update")
        return 1
    return 0


sys.exit(main())
