#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Ablation: ncg without its ladder on design scenes, one part left out at a time by the switches of tune/tune_switches.h.

    STAD_DATA=... tools/study/ablation.py [--cost chow] [--family middlebury] [--budget 80]

Every variant is a build of the library of its own, run in a process of its own. The gap is to the best point that the cache
of counts holds for a scene, by whatever method it got there."""
import argparse
import json
import os
import statistics
import subprocess
import sys

from costs import COUNTS, cost_q20
from ours import search
from package import ROOT, build
from scenes import Scene, sample, split

PARTS = (("full", ""), ("no PR+ (beta 0)", "-DTUNE_BETA=0"), ("no curvature scaling", "-DTUNE_SCALING=0"),
         ("no polls of block and disp12", "-DTUNE_POLLS=0"), ("no follow", "-DTUNE_FOLLOW=0"), ("no joint step", "-DTUNE_JOINT=0"))


def best_known(scene, kind):
    scene.reload()
    return min(cost_q20(dict(zip(COUNTS, v)), kind) for v in scene.known.values())


def one_variant(args):
    """Costs of every design scene, by the library of this process."""
    return [[c for _, c in search(args.cost, "ncg-bare", args.budget, sample(), lambda x: s.cost(x, args.cost))[0]]
            for s in map(Scene, split("design", args.family))]


def run(number, flags):
    library = build(os.path.join(ROOT, "build-study", f"ablation-{number}"), flags)
    out = subprocess.run([sys.executable, *sys.argv, "--one"], env=dict(os.environ, STADIMETER_LIBRARY=library), check=True, capture_output=True)
    return json.loads(out.stdout)


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    a.add_argument("--cost", default="chow")
    a.add_argument("--family", default="middlebury")
    a.add_argument("--budget", type=int, default=80)
    a.add_argument("--one", action="store_true", help=argparse.SUPPRESS)
    args = a.parse_args()
    if args.one:
        print(json.dumps(one_variant(args)))
        return
    runs = {name: run(i, flags) for i, (name, flags) in enumerate(PARTS)}
    best = [best_known(Scene(p), args.cost) for p in split("design", args.family)]
    print("| variant | to 2 % (median) | reached | mean gap % |\n|---|---|---|---|")
    for name, costs in runs.items():
        steps = [next((i + 1 for i, c in enumerate(cs) if c <= 1.02 * b), float("inf")) for cs, b in zip(costs, best)]
        gaps = [100 * (min(cs) / b - 1) for cs, b in zip(costs, best)]
        print(f"| {name} | {statistics.median(steps):g} | {sum(s != float('inf') for s in steps)} of {len(steps)} | {statistics.mean(gaps):.2f} |")


if __name__ == "__main__":
    main()
