#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""This library and OpenCV in turn, in one loop, on one thread: the median of paired ratios of thread-CPU time.

    python3 tools/bench/compare.py                      every tier, mode, size and block
    python3 tools/bench/compare.py --tier avx2 --mode sgbm --sizes vga64

A ratio above 1 says how many times faster the library is than the installed cv2. Each pair's two runs follow one another
directly and take turns at being first, so that load and clock drift cancel. Every pair's arrays are compared once. Writes
its rows into tools/bench/results/compare.csv after each tier, in the place of older ones of the same case, and sums up all
that the file then holds (--csv FILE; - writes nothing)."""
import argparse
import csv
import math
import os
import statistics
import subprocess
import sys
import time

from bench_common import MODES, NARROW, ROOT, RESULTS, TIERS, WIDE, build, environment, machine, pair, parameters

SIZES = {"wide": WIDE, "narrow": NARROW, "vga64": WIDE[:1]}
FIELDS = ["tier", "mode", "width", "height", "disparities", "block", "pairs", "ratio", "low_quartile", "high_quartile",
          "ns_per_pxd", "opencv_ns_per_pxd", "small_over_fast", "opencv", "cpu", "compiler"]


def timed(call):
    start = time.thread_time()
    call()
    return time.thread_time() - start


def paired(a, b, seconds, least):
    """CPU times of two calls in turn: lists of equal length."""
    times = [], []
    until = time.monotonic() + seconds
    while len(times[0]) < least or time.monotonic() < until:
        for which in ((0, 1), (1, 0))[len(times[0]) % 2]:
            times[which].append(timed((a, b)[which]))
    return times


def measure(case, seconds):
    """One row of the table."""
    import cv2
    import numpy as np
    import stadimeter
    mode, (width, height, disparities), block = case
    left, right = pair(width, height, disparities)
    arguments = parameters(disparities, block, mode)
    ours, theirs = stadimeter.StereoSGBM_create(**arguments), cv2.StereoSGBM_create(**arguments)
    small = stadimeter.StereoSGBM_create(memory="small", **arguments)
    for matcher in (ours, small):
        if not np.array_equal(matcher.compute(left, right), theirs.compute(left, right)):
            raise SystemExit(f"{case}: the arrays differ")
    mine, opencv = paired(lambda: ours.compute(left, right), lambda: theirs.compute(left, right), seconds, 5)
    low, ratio, high = statistics.quantiles([b / a for a, b in zip(mine, opencv)], n=4)
    slow, fast = paired(lambda: small.compute(left, right), lambda: ours.compute(left, right), seconds / 2, 3)
    cells = (width - disparities) * height * disparities * 1e-9
    return [mode, width, height, disparities, block, len(mine), round(ratio, 3), round(low, 3), round(high, 3),
            round(statistics.median(mine) / cells, 3), round(statistics.median(opencv) / cells, 3),
            round(statistics.median(s / f for s, f in zip(slow, fast)), 3), cv2.__version__]


def worker(arguments):
    """Runs in a process of its own, since the tier is chosen when the library is loaded."""
    import cv2
    import stadimeter
    cv2.setNumThreads(1)
    tier, wanted = stadimeter.tier(), TIERS[arguments.worker][1]
    if tier != wanted:
        print(f"UNAVAILABLE {arguments.worker}: this processor's widest tier is {tier}")
        return
    for case in cases(arguments):
        print(",".join(map(str, [arguments.worker, *measure(case, arguments.seconds)])), flush=True)


def cases(arguments):
    chosen = [size for name in arguments.sizes for size in SIZES[name]]
    return [(mode, size, block) for mode in arguments.mode for size in chosen for block in ((3,) if size in NARROW else (3, 5))]


def run_tier(tier, arguments, libraries):
    variant, isa = TIERS[tier]
    if variant not in libraries:
        libraries[variant] = build(variant, arguments.build)
    command = [sys.executable, os.path.abspath(__file__), "--worker", tier, "--seconds", str(arguments.seconds), "--mode",
               *arguments.mode, "--sizes", *arguments.sizes]
    rows = []
    with subprocess.Popen(command, env=environment(libraries[variant], isa), stdout=subprocess.PIPE, text=True) as process:
        for line in process.stdout:
            row = line.strip().split(",")
            if len(row) != len(FIELDS) - 2:
                print(line.strip())
                continue
            rows.append(row)
            print("{:13} {:5} {:>4}x{:<4} D {:<4} block {}  {:>6}x [{}..{}]  {:>6} ns/pxd, OpenCV {:>6}  small/fast {}"
                  .format(*row[:6], *row[7:13]), flush=True)
    if process.returncode != 0:
        sys.exit(process.returncode)
    return rows


def merge(path, rows):
    """The rows of the file, older ones of the same case replaced; writes them unless path is -."""
    kept = {}
    if path != "-" and os.path.exists(path):
        with open(path, newline="", encoding="utf-8") as old:
            kept = {tuple(row[:6]): row for row in list(csv.reader(old))[1:]}
    kept.update({tuple(row[:6]): row for row in rows})
    if path != "-":
        os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
        with open(path, "w", newline="", encoding="utf-8") as out:
            csv.writer(out, lineterminator="\n").writerows([FIELDS, *kept.values()])
    return list(kept.values())


def geometric(values):
    return math.exp(sum(map(math.log, values)) / len(values))


def summary(rows):
    """Geometric means over the sizes of WIDE, blocks 3 and 5; and the narrow sizes."""
    print(f"\n{'':13}" + "".join(f"{mode:>9}" for mode in MODES) + "   geometric mean of the ratio, VGA D64, VGA D128, 720p D128, blocks 3 and 5")
    for tier in TIERS:
        for name, sizes, blocks in ((tier, WIDE, "35"), ("  block 3", WIDE, "3"), ("  block 5", WIDE, "5"), ("  narrow", NARROW, "3")):
            found = [[float(r[7]) for r in rows if r[0] == tier and r[1] == mode and r[5] in blocks and
                      tuple(map(int, r[2:5])) in sizes] for mode in MODES]
            if any(found):
                whole = [values if len(values) == len(sizes) * len(blocks) else [] for values in found]
                print(f"{name:13}" + "".join(f"{geometric(values):>8.2f}x" if values else f"{'-':>9}" for values in whole))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tier", nargs="+", choices=list(TIERS), default=list(TIERS))
    parser.add_argument("--mode", nargs="+", choices=list(MODES), default=list(MODES))
    parser.add_argument("--seconds", type=float, default=1.5, help="least time for each row's pairs (1.5)")
    parser.add_argument("--sizes", nargs="+", choices=list(SIZES), default=["wide", "narrow"])
    parser.add_argument("--build", default=os.path.join(ROOT, "build/bench"), help="folder for the builds (build/bench)")
    parser.add_argument("--csv", default=os.path.join(RESULTS, "compare.csv"))
    parser.add_argument("--worker", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.seconds < 0:
        parser.error(f"argument --seconds: {arguments.seconds} is less than 0")
    if arguments.worker:
        return worker(arguments)
    cpu, compiler = machine()
    print(f"{cpu}; {compiler}")
    libraries, rows = {}, []
    for tier in arguments.tier:
        rows += [row + [cpu, compiler] for row in run_tier(tier, arguments, libraries)]
        told = merge(arguments.csv, rows)
    print("against OpenCV " + ", ".join(sorted({row[13] for row in told})), end="")
    summary(told)
    return 0


if __name__ == "__main__":
    sys.exit(main())
