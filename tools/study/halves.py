#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Halves: the upper and the lower half of every report scene as scenes of their own, to which nothing was ever fitted.

    STAD_DATA=... tools/study/halves.py [--family middlebury] [--budget 150] [--out halves.json]

The methods, start, budget, gap and `to 2 %` of table1.py, whose variants of ncg are set aside here too. Runs what halves.json
does not hold yet. Half a picture has half the pixels, so its costs are rougher."""
import argparse
import json
import os
import statistics
import sys

import numpy as np

from scenes import Scene, split
from table1 import ORDER, VARIANTS, best_cost, first_within, run

COSTS = ("chow", "bad")


class Half(Scene):
    """Rows of the upper (0) or the lower (1) half of a scene."""

    def __init__(self, path, part):
        super().__init__(path)
        middle = self.left.shape[0] // 2
        rows = slice(0, middle) if part == 0 else slice(middle, None)
        self.left, self.right, self.truth, self.label = (np.ascontiguousarray(a[rows]) for a in (self.left, self.right, self.truth, self.label))
        self.file = self.file.replace(".txt", f"_{part}.txt")
        self.path = f"{path}#{part}"
        self.known = {}
        self.reload()


def fill(results, args):
    for place in split("report", args.family):
        for part in (0, 1):
            todo = [(k, m) for k in COSTS for m in ORDER if f"{k}|{place}#{part}|{m}" not in results]
            scene = Half(place, part) if todo else None
            for kind, method in todo:
                results[f"{kind}|{scene.path}|{method}"] = run(scene, kind, method, args.budget)
            if todo:
                print(scene.path, file=sys.stderr, flush=True)
                with open(args.out + ".part", "w", encoding="utf-8") as file:
                    json.dump(results, file)
                os.replace(args.out + ".part", args.out)


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    a.add_argument("--family", default="middlebury")
    a.add_argument("--budget", type=int, default=150)
    a.add_argument("--out", default="halves.json")
    args = a.parse_args()
    results = json.load(open(args.out, encoding="utf-8")) if os.path.exists(args.out) else {}
    fill(results, args)
    places = [f"{p}#{part}" for p in split("report", args.family) for part in (0, 1)]
    for kind in COSTS:
        print(f"\n**{args.family}, {len(places)} halves of report scenes, tuned on {kind}**\n\n| method | gap % | to 2 % |\n|---|---|---|")
        best = [best_cost(results, kind, p, VARIANTS) for p in places]
        for method in ORDER:
            costs = [results[f"{kind}|{p}|{method}"]["costs"] for p in places]
            gap = statistics.mean(100 * (min(c) / b - 1) for c, b in zip(costs, best))
            steps = statistics.median(first_within(c, 1.02 * b) for c, b in zip(costs, best))
            print(f"| {method} | {gap:.2f} | {'never' if steps == float('inf') else format(steps, 'g')} |")


if __name__ == "__main__":
    main()
