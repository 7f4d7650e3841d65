#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Ablation: ncg without its ladder on design scenes, one part left out at a time by the switches of tune/tune_switches.h.

    STAD_DATA=... tools/study/ablation.py [--cost chow] [--family middlebury] [--budget 80]

The gap is to the best point that the cache of counts holds for a scene, by whatever method it got there."""
import argparse
import os
import statistics

from native import Native
from scenes import COUNTS, Scene, cost_q20, sample, split

PARTS = (("full", ""), ("no PR+ (beta 0)", "-DTUNE_BETA=0"), ("no curvature scaling", "-DTUNE_SCALING=0"),
         ("no polls of block and disp12", "-DTUNE_POLLS=0"), ("no follow", "-DTUNE_FOLLOW=0"), ("no joint step", "-DTUNE_JOINT=0"))


def best_known(scene, kind):
    scene.reload()
    return min(cost_q20(dict(zip(COUNTS, v)), kind) for v in scene.known.values())


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    a.add_argument("--cost", default="chow")
    a.add_argument("--family", default="middlebury")
    a.add_argument("--budget", type=int, default=80)
    args = a.parse_args()
    scenes = [Scene(p) for p in split("design", args.family)]
    runs = {}
    for name, flags in PARTS:
        os.environ["STAD_STUDY_CFLAGS"] = flags
        native = Native()
        config = native.config("any", "ncg", args.budget)
        runs[name] = [[c for _, c in native.tune(config, sample(), lambda x: s.cost(x, args.cost))[0]] for s in scenes]
    best = [best_known(s, args.cost) for s in scenes]
    print("| variant | to 2 % (median) | reached | mean gap % |\n|---|---|---|---|")
    for name, costs in runs.items():
        steps = [next((i + 1 for i, c in enumerate(cs) if c <= 1.02 * b), float("inf")) for cs, b in zip(costs, best)]
        gaps = [100 * (min(cs) / b - 1) for cs, b in zip(costs, best)]
        print(f"| {name} | {statistics.median(steps):g} | {sum(s != float('inf') for s in steps)} of {len(steps)} | {statistics.mean(gaps):.2f} |")


if __name__ == "__main__":
    main()
