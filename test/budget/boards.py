#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What `stad plan --board` says of each board is what its linker script and counts.csv say. Exit 0, or 1."""
import csv
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SOURCE = (ROOT / "tools/stad/plan_board.c").read_text()
CELLS = (160 - 32) * 120 * 32
TWINS = {"netduinoplus2": "mps2-an386"}  # the same core, flags and kernels
REGIONS = ["sgbm_fast", "sgbm_small", "3way_fast", "3way_small"]


def memory(board):
    """{CODE or DATA: bytes} of a linker script."""
    text = (ROOT / "port/board" / board / "board.ld").read_text()
    return {name: int(n) << {"K": 10, "M": 20}[unit]
            for name, n, unit in re.findall(r"(CODE|DATA) .*LENGTH = (\d+)([KM])", text)}


def counted():
    """{board: [instructions per pixel and disparity]}, by region, with the compiler that takes fewest."""
    sums, best = {}, {}
    with (ROOT / "tools/count/counts.csv").open() as file:
        for row in csv.DictReader(file):
            preset = sums.setdefault(row["preset"], dict.fromkeys(REGIONS, 0))
            if row["region"] in preset:
                preset[row["region"]] += int(row["instructions"])
    for preset, regions in sums.items():
        board = preset.rsplit("-", 1)[0]
        best[board] = min(best.get(board, [1e9]), [n / CELLS for n in regions.values()])
    return best


def main():
    costs = {name: [float(v) for v in values.split(",")]
             for name, values in re.findall(r"#define (\w+)\s+\{([\d., ]+)\}", SOURCE)}
    rows = re.findall(r'\{"([\w-]+)", "[^"]*", (\d+)l << (\d+), (\d+)l << (\d+), (\w+)\}', SOURCE)
    known, wrong = counted(), []
    boards = {path.parent.name for path in (ROOT / "port/board").glob("*/board.ld")}
    if boards != {row[0] for row in rows}:
        wrong.append(f"boards: {boards ^ {row[0] for row in rows}}")
    for name, ram, ram_shift, flash, flash_shift, cost in rows:
        if memory(name) != {"CODE": int(flash) << int(flash_shift), "DATA": int(ram) << int(ram_shift)}:
            wrong.append(f"{name}: {memory(name)}")
        want = known.get(TWINS.get(name, name), [0] * 4)
        if any(abs(w - c) > 0.03 * w for w, c in zip(want, costs[cost])) or (want[0] == 0) != (costs[cost][0] == 0):
            wrong.append(f"{name}: counted {[round(w, 1) for w in want]}, planned {costs[cost]}")
    print("\n".join(wrong) or f"{len(rows)} boards as planned")
    return 1 if wrong else 0


sys.exit(main())
