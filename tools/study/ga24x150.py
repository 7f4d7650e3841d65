#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The genetic algorithm at full length, 24 x 150 calls, against ncg with a twentieth of its evaluations.

    STAD_DATA=... tools/study/ga24x150.py [--cost chow] [--family middlebury,driving] [--seed N,...] [--ga-seed N] [--scatter N]
                                           [--out ga.json] [SCENE...]

Same start, variables, box, lattice and memo. `ncg` brings the ladder of its cost, `ncg-bare` brings nothing: it knows what the GA
knows. Each may take up to 180 distinct evaluations, a twentieth of 3600; *after* is when it is at or below the GA's best. --seed:
of ncg; the table is of the first, the means are told for each. --scatter: how much the cost of N points differs that lie at random
within 3 % of ncg's end in P1 and P2."""
import argparse
import json
import os
import random
import statistics

import rivals
from ours import best_of, search
from scenes import Scene, sample, split

CALLS, LIMIT = 24 * 150, 180
METHODS = ("ncg", "ncg-bare")


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


def percent(cost):
    return 100 * cost / 2**20


def first_at(costs, goal):
    return next((i + 1 for i, c in enumerate(costs) if c <= goal), None)


def scatter(scene, kind, end, count):
    """Standard deviation of the cost close to a point, in percent of it."""
    draw = random.Random(1).uniform
    costs = [scene.cost((round(end[0] * (1 + draw(-.03, .03))), round(end[1] * (1 + draw(-.03, .03)))) + end[2:], kind) for _ in range(count)]
    return 100 * statistics.stdev(costs) / statistics.mean(costs)


def tell_mean(family, method, seed, pairs):
    mean = lambda values: percent(statistics.mean(values))
    goal = mean(ga["best"] for ga, _ in pairs)
    there = first_at([mean(min(c[:n]) for _, c in pairs) for n in range(1, LIMIT + 1)], goal)
    below = sum(min(c) <= ga["best"] for ga, c in pairs)
    print(f"mean of {len(pairs)} {family} scenes: GA {goal:.3f} % with {statistics.mean(ga['distinct'] for ga, _ in pairs):.0f} distinct points; {method}, seed {seed}: "
          f"at or below it after {there or 'never'} evaluations, at {LIMIT}: {mean(min(c) for _, c in pairs):.3f} %; at or below it on {below} scenes")


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    listed = lambda s: s.split(",")
    a.add_argument("--cost", default="chow")
    a.add_argument("--family", type=listed, default=["middlebury", "driving"])
    a.add_argument("--seed", type=listed, default=["1"])
    a.add_argument("--ga-seed", type=int, default=1)
    a.add_argument("--scatter", type=int, default=0)
    a.add_argument("--out", default="ga.json")
    a.add_argument("scene", nargs="*")
    args = a.parse_args()
    done = json.load(open(args.out)) if os.path.exists(args.out) else {}
    places = args.scene or [p for f in args.family for h in ("report", "design") for p in split(h, f)]
    print("| scene | GA % | distinct | best at |" + "".join(f" {m}: after | at {LIMIT} % |" for m in METHODS) + "\n" + "|---" * 8 + "|")
    pairs, spread = {}, []
    for place in places:
        scene, key = Scene(place), f"{args.cost}|{place}|{args.ga_seed}"
        if key not in done:
            costs = genetic(scene, args.cost, args.ga_seed)
            done[key] = {"best": min(costs), "distinct": len(costs), "at": costs.index(min(costs)) + 1}
            with open(args.out, "w") as f:
                json.dump(done, f)
        ga, cells = done[key], ""
        for seed in args.seed:
            for method in METHODS:
                trace = search(args.cost, method, LIMIT, sample(), lambda x: scene.cost(x, args.cost), seed=int(seed))[0]
                ours = [c for _, c in trace]
                if args.scatter and method == METHODS[0] and seed == args.seed[0]:
                    spread.append(f"{place} {scatter(scene, args.cost, best_of(trace)[0], args.scatter):.3f} %")
                pairs.setdefault(("Middlebury" if place.startswith("middlebury") else "driving", method, seed), []).append((ga, ours))
                cells += f" {first_at(ours, ga['best']) or 'never'} | {percent(min(ours)):.3f} |" if seed == args.seed[0] else ""
        print(f"| {place} | {percent(ga['best']):.3f} | {ga['distinct']} | {ga['at']} |{cells}", flush=True)
    print()
    for (family, method, seed), found in pairs.items():
        tell_mean(family, method, seed, found)
    if spread:
        print("scatter: " + ", ".join(spread))


if __name__ == "__main__":
    main()
