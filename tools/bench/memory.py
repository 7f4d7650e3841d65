#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Bytes of workspace, planned and touched, beside what OpenCV allocates for the same frames.

    python3 tools/bench/memory.py

planned: stad_match_bytes(). touched: workspace bytes that a frame changed, found by filling the workspace with two patterns in
turn. OpenCV by formula: (B + 13 + 64 / D) U, 3WAY (B + 5) U, HH and HH4 2 H U, with U = 2 (W - D) D bytes; measured: growth
of the process's peak resident set over one compute() of a matcher that has not computed before. Writes
tools/bench/results/memory.csv (--csv FILE; - writes nothing)."""
import argparse
import csv
import os
import subprocess
import sys

from bench_common import MODES, RESULTS, ROOT, build, environment, pair, parameters

SIZES = [(160, 120, 32), (320, 240, 64), (640, 480, 64), (640, 480, 128), (1280, 720, 128)]
FIELDS = ["mode", "width", "height", "disparities", "block", "opencv_formula", "opencv_measured", "fast", "fast_touched", "small",
          "small_touched", "small_p2_255", "small_p2_255_touched"]


def opencv_formula(mode, width, height, disparities, block):
    unit = 2 * (width - disparities) * disparities
    factor = {"sgbm": block + 13 + 64 / disparities, "3way": block + 5}.get(mode, 2 * height)
    return round(factor * unit)


def touched(matcher, left, right):
    """Workspace bytes that one frame changes; bytes() of the plan."""
    import numpy as np
    matcher.compute(left, right)
    planned = matcher.workspaceBytes(left)
    work = matcher._work[:planned]
    changed = np.zeros(planned, bool)
    for pattern in (0xA5, 0x5A):
        work[:] = pattern
        matcher.compute(left, right)
        changed |= work != pattern
    return planned, int(changed.sum())


def peak_growth(mode, size, block):
    """OpenCV's: a process of its own, its peak reset before the call."""
    code = ("import sys, cv2, numpy as np; from bench_common import pair, parameters\n"
            f"cv2.setNumThreads(1); left, right = pair(*{size})\n"
            "cv2.StereoSGBM_create(0, 16, 3).compute(left[:40, :80].copy(), right[:40, :80].copy())\n"
            f"m = cv2.StereoSGBM_create(**parameters({size[2]}, {block}, {mode!r})); out = np.zeros(left.shape, np.int16)\n"
            "open('/proc/self/clear_refs', 'w').write('5')\n"
            "def peak(): return next(int(l.split()[1]) for l in open('/proc/self/status') if l.startswith('VmHWM')) * 1024\n"
            "before = peak(); m.compute(left, right, out); print(peak() - before)")
    return int(subprocess.run([sys.executable, "-c", code], env=environment("", ""), check=True, capture_output=True, text=True).stdout)


def worker(arguments):
    import numpy as np
    import stadimeter
    for size in SIZES:
        left, right = pair(*size)
        for mode in MODES:
            for block in arguments.block:
                given = parameters(size[2], block, mode)
                row = [mode, *size, block, opencv_formula(mode, *size, block), peak_growth(mode, size, block)]
                first = None
                for memory, p2 in (("fast", None), ("small", None), ("small", 255)):
                    values = dict(given, P1=min(given["P1"], 60), P2=p2) if p2 else given
                    matcher = stadimeter.StereoSGBM_create(memory=memory, **values)
                    row += touched(matcher, left, right)
                    if not p2:
                        first = matcher.compute(left, right) if first is None else first
                        if not np.array_equal(first, matcher.compute(left, right)):
                            raise SystemExit(f"{size} {mode}: the memory plans differ")
                print(",".join(map(str, row)), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--block", nargs="+", type=int, default=[3, 5])
    parser.add_argument("--build", default=os.path.join(ROOT, "build/bench"), help="folder for the build (build/bench)")
    parser.add_argument("--csv", default=os.path.join(RESULTS, "memory.csv"))
    parser.add_argument("--worker", action="store_true", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.worker:
        return worker(arguments)
    command = [sys.executable, os.path.abspath(__file__), "--worker", "--block", *map(str, arguments.block)]
    rows = []
    print(("{:5} {:>10} {:>4} {:>2}" + " {:>12}" * 8).format("mode", "size", "D", "B", "OpenCV form.", "measured", "fast", "touched",
                                                        "small", "touched", "p2<=255", "touched"))
    with subprocess.Popen(command, env=environment(build("x86", arguments.build), "avx512"), stdout=subprocess.PIPE, text=True) as process:
        for line in process.stdout:
            row = line.strip().split(",")
            rows.append(row)
            print(("{:5} {:>5}x{:<4} {:>4} {:>2}" + " {:>12}" * 8).format(*row), flush=True)
    if process.returncode == 0 and arguments.csv != "-":
        os.makedirs(os.path.dirname(os.path.abspath(arguments.csv)), exist_ok=True)
        with open(arguments.csv, "w", newline="", encoding="utf-8") as out:
            csv.writer(out, lineterminator="\n").writerows([FIELDS, *rows])
    return process.returncode


if __name__ == "__main__":
    sys.exit(main())
