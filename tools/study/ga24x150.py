#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The genetic algorithm at full length, 24 x 150 calls, against ncg with a twentieth of its evaluations.

    STAD_DATA=... tools/study/ga24x150.py [--cost chow] [--family middlebury,driving] [--out ga.json] [SCENE...]

Same start, variables, box, lattice and memo. Three ratios for each scene, how many evaluations of the GA one of ncg's replaces
until ncg is at or below the GA's best: against the GA's calls (3600), its distinct points, and the point at which it met its
best. ncg may take up to 180 distinct evaluations, a twentieth of 3600."""
import argparse
import json
import os
import statistics

import rivals
from ours import search
from scenes import Scene, sample, split

CALLS, LIMIT = 24 * 150, 180


class Calls:
    """Ends a rival after a number of calls instead of distinct evaluations."""

    def __init__(self, box, most):
        self.box, self.left, self.start, self.trace, self.round = box, most, box.start, box.trace, box.round

    def __call__(self, cube):
        self.left -= 1
        if self.left < 0:
            raise rivals.Spent
        return self.box(cube)


def genetic(scene, kind, seed=1):
    """Costs of the GA's distinct points, in order."""
    box = rivals.Box(lambda x: scene.cost(x, kind), 10**6, sample())
    try:
        rivals.ga(Calls(box, CALLS), seed, 24)
    except rivals.Spent:
        pass
    return [c for _, c in box.trace]


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    listed = lambda s: s.split(",")
    a.add_argument("--cost", default="chow")
    a.add_argument("--family", type=listed, default=["middlebury", "driving"])
    a.add_argument("--out", default="ga.json")
    a.add_argument("scene", nargs="*")
    args = a.parse_args()
    done = json.load(open(args.out)) if os.path.exists(args.out) else {}
    places = args.scene or [p for f in args.family for h in ("report", "design") for p in split(h, f)]
    print("| scene | GA % | distinct | best at | ncg at or below it after | ncg at 180 % | times fewer: calls | distinct | best at |\n" + "|---" * 9 + "|")
    ratios, ahead, families = [], 0, {}
    for place in places:
        scene, key = Scene(place), f"{args.cost}|{place}"
        if key not in done:
            costs = genetic(scene, args.cost)
            done[key] = {"best": min(costs), "distinct": len(costs), "at": costs.index(min(costs)) + 1}
            with open(args.out, "w") as f:
                json.dump(done, f)
        ga = done[key]
        ours = [c for _, c in search(args.cost, "ncg", LIMIT, sample(), lambda x: scene.cost(x, args.cost))[0]]
        there = next((i + 1 for i, c in enumerate(ours) if c <= ga["best"]), None)
        times = [f"{n / there:.0f}" if there else "" for n in (CALLS, ga["distinct"], ga["at"])]
        ratios.append(ga["distinct"] / there if there else 0)
        ahead += there is not None
        families.setdefault("Middlebury" if place.startswith("middlebury") else "driving", []).append((ga, ours))
        print(f"| {place} | {100 * ga['best'] / 2**20:.3f} | {ga['distinct']} | {ga['at']} | {there or 'never'} | {100 * min(ours) / 2**20:.3f} | "
              + " | ".join(times) + " |", flush=True)
    print(f"\nncg at or below the GA's best within {LIMIT} evaluations on {ahead} of {len(places)} scenes; "
          f"at least 20 times fewer than the GA's distinct points on {sum(r >= 20 for r in ratios)}, median ratio {statistics.median(ratios):.0f}")
    for family, pairs in families.items():
        mean = lambda values: statistics.mean(values) * 100 / 2**20
        goal = mean(ga["best"] for ga, _ in pairs)
        there = next((n for n in range(1, LIMIT + 1) if mean(min(c[:n]) for _, c in pairs) <= goal), None)
        print(f"mean of {len(pairs)} {family} scenes: GA {goal:.3f} % with {statistics.mean(ga['distinct'] for ga, _ in pairs):.0f} distinct points; "
              f"ncg at or below it after {there or 'never'} evaluations, at {LIMIT}: {mean(min(c) for _, c in pairs):.3f} %")


if __name__ == "__main__":
    main()
