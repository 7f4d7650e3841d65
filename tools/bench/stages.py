#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Where the time of `stad bench` goes: nanoseconds per pixel and disparity of every stage, by sampling with perf.

    python3 tools/bench/stages.py                              every tier and mode, VGA, 64 and 128 disparities
    python3 tools/bench/stages.py --tier avx2 --mode sgbm --disparities 128

A stage is a kernel (docs/PORTING.md); `last` is the path back and the winners where a port takes both at once, `rest` all of
the library that is no kernel. Each is its share of the samples times what `stad bench` measures without perf. Needs the
program perf (Debian: linux-perf) and a build (--stad). Writes tools/bench/results/stages.csv (--csv FILE; - writes nothing)."""
import argparse
import csv
import os
import re
import subprocess
import sys
import tempfile

from bench_common import MODES, RESULTS, ROOT, TIERS

STAGES = ["prefilter", "cost", "block", "path", "last", "best", "refine", "select", "check", "median", "rest"]
STAGE_OF = {"prefilter": "prefilter", "range": "prefilter", "cost": "cost", "box": "block", "slide": "block", "block": "block",
            "path": "path", "gather": "path"}  # others: a stage of their own name
FIELDS = ["tier", "mode", "disparities", *STAGES]


def stage_of(symbol):
    name = re.match(r"stad_([a-z]+)_", symbol)
    if name:
        stage = STAGE_OF.get(name[1], name[1])
        return stage if stage in STAGES else "rest"
    return "rest" if symbol.startswith("__mem") else None  # None: not the library's


def shares(samples):
    """Share of each stage among the samples that are the library's."""
    counted = dict.fromkeys(STAGES, 0.0)
    for share, symbol in re.findall(r"^\s*([\d.]+)%\s+\[\.\]\s+(\S+)", samples, re.MULTILINE):
        stage = stage_of(symbol)
        if stage:
            counted[stage] += float(share)
    whole = sum(counted.values())
    return {stage: value / whole for stage, value in counted.items()} if whole else None


def bench(command):
    """Nanoseconds per pixel and disparity; the kernels named."""
    done = subprocess.run(command, capture_output=True, text=True)
    time = re.search(r"([\d.]+) ns per pixel and disparity", done.stdout)
    if done.returncode != 0 or not time:
        sys.exit(f"stages: {' '.join(command)}: {done.stderr.strip() or done.stdout.strip()}")
    return float(time[1]), re.search(r"kernels: (.*)", done.stdout)[1]


def measure(arguments, tier, mode, disparities):
    command = [arguments.stad, "bench", "--isa", tier, "--mode", mode, "--num-disparities", str(disparities)]
    time, kernels = bench([*command, "--frames", "15"])
    if kernels != tier:
        print(f"UNAVAILABLE {tier}: the kernels in use are {kernels}")
        return None
    with tempfile.TemporaryDirectory() as folder:
        data = os.path.join(folder, "perf.data")
        record = ["perf", "record", "-q", "-e", "cpu-clock", "-F", "5000", "-o", data, *command, "--frames", str(arguments.frames)]
        subprocess.run(record, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        report = subprocess.run(["perf", "report", "-q", "-i", data, "--stdio", "-s", "symbol"], capture_output=True, text=True)
    found = shares(report.stdout)
    if not found:
        sys.exit("stages: perf found no sample of the library; was the program stripped?")
    return [tier, mode, disparities, *(round(time * found[stage], 3) for stage in STAGES)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    tiers = [isa for build, isa in TIERS.values() if build == "x86"]
    parser.add_argument("--tier", nargs="+", choices=tiers, default=tiers)
    parser.add_argument("--mode", nargs="+", choices=list(MODES), default=list(MODES))
    parser.add_argument("--disparities", nargs="+", type=int, default=[64, 128])
    parser.add_argument("--frames", type=int, default=60, help="frames that perf watches (60)")
    parser.add_argument("--stad", default=os.path.join(ROOT, "build/stad"), help="the program to watch (build/stad)")
    parser.add_argument("--csv", default=os.path.join(RESULTS, "stages.csv"))
    arguments = parser.parse_args()
    for program in (["perf", "--version"], [arguments.stad, "--version"]):
        try:
            subprocess.run(program, check=True, stdout=subprocess.DEVNULL)
        except (OSError, subprocess.CalledProcessError):
            sys.exit(f"stages: {program[0]} does not run; see --help")
    print("ns per pixel and disparity\n" + " ".join(f"{name:>9}" for name in FIELDS))
    rows = []
    for tier in arguments.tier:
        for mode in arguments.mode:
            for disparities in arguments.disparities:
                row = measure(arguments, tier, mode, disparities)
                if row:
                    rows.append(row)
                    print(" ".join(f"{value:>9}" for value in row), flush=True)
    if arguments.csv != "-":
        with open(arguments.csv, "w", newline="", encoding="utf-8") as out:
            csv.writer(out, lineterminator="\n").writerows([FIELDS, *rows])


main()
