#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Ablation: ncg without its ladder on design scenes, one part left out at a time by the switches of tune/tune_switches.h.

    STAD_DATA=... tools/study/ablation.py [--budget 80]

Every variant is a build of the library of its own, run in a process of its own. The gap is to the best that a variant here or a
method of results/table1.csv came to on the scene."""
import argparse
import csv
import json
import math
import os
import statistics
import subprocess
import sys

from ours import search
from package import ROOT, build
from scenes import Scene, manifest, sample, split

PARTS = (("full", ""), ("no PR+ (beta 0)", "-DTUNE_BETA=0"), ("no curvature scaling", "-DTUNE_SCALING=0"),
         ("no polls of block and disp12", "-DTUNE_POLLS=0"), ("no follow", "-DTUNE_FOLLOW=0"), ("no joint step", "-DTUNE_JOINT=0"))
CELLS = [(cost, family) for cost in ("chow", "bad") for family in ("middlebury", "driving")]
TABLE = os.path.join(ROOT, "tools/study/results/table1.csv")


def best_of_table(cost, scene):
    """In Q20; the table has four digits."""
    with open(TABLE, encoding="utf-8") as file:
        return min(float(row[cost]) * 2**20 / 100 for row in csv.DictReader(file) if (row["cost"], row["scene"]) == (cost, scene))


def one_variant(budget):
    """By cell and scene the costs of the search, by the library of this process."""
    return [{path: [c for _, c in search(cost, "ncg-bare", budget, sample(), lambda x: scene.cost(x, cost))[0]]
             for path, scene in ((p, Scene(p)) for p in split("design", family))} for cost, family in CELLS]


def run(number, flags):
    library = build(os.path.join(ROOT, "build-study", f"ablation-{number}"), flags)
    out = subprocess.run([sys.executable, *sys.argv, "--one"], env=dict(os.environ, STADIMETER_LIBRARY=library), check=True, capture_output=True)
    return json.loads(out.stdout)


def summary(costs, floor):
    """Median evaluations to 2 %, scenes that came there, mean gap."""
    steps = [next((i + 1 for i, c in enumerate(costs[p]) if c <= 1.02 * floor[p]), math.inf) for p in costs]
    gaps = [100 * (min(costs[p]) / floor[p] - 1) for p in costs]
    return f"{statistics.median(steps):g}, {sum(map(math.isfinite, steps))} of {len(steps)}, {statistics.mean(gaps):.2f} %"


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    a.add_argument("--budget", type=int, default=80)
    a.add_argument("--one", action="store_true", help=argparse.SUPPRESS)
    args = a.parse_args()
    if args.one:
        print(json.dumps(one_variant(args.budget)))
        return
    manifest()  # before anything is built
    runs = {name: run(i, flags) for i, (name, flags) in enumerate(PARTS)}
    floors = [{path: min(best_of_table(cost, path), *(min(cells[k][path]) for cells in runs.values())) for path in split("design", family)}
              for k, (cost, family) in enumerate(CELLS)]
    print("| variant | " + " | ".join(map(", ".join, CELLS)) + " |\n|---|" + "---|" * len(CELLS))
    for name, cells in runs.items():
        print(f"| {name} | " + " | ".join(map(summary, cells, floors)) + " |")


if __name__ == "__main__":
    main()
