#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Generalisation: one parameter set tuned on all design scenes of a family together, measured on its report scenes.

    STAD_DATA=... tools/study/general.py [--cost chow,bad] [--family middlebury,driving] [--budget 60]

The cost of a point is the mean over the design scenes. Printed: the mean cost in percent with default, sample and that set, on
the design scenes (in-sample) and on the report scenes, beside what tuning each report scene alone would give."""
import argparse

from ours import best_of, search
from scenes import DEFAULT, Scene, sample, split


def mean_cost(scenes, x, kind):
    return sum(s.cost(x, kind) for s in scenes) / len(scenes)


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    listed = lambda s: s.split(",")
    a.add_argument("--cost", type=listed, default=["chow", "bad"])
    a.add_argument("--family", type=listed, default=["middlebury", "driving"])
    a.add_argument("--budget", type=int, default=60)
    args = a.parse_args()
    print("| tuned on | scenes | default % | sample % | tuned together % | tuned one by one % | parameters |\n|---|---|---|---|---|---|---|")
    for kind in args.cost:
        for family in args.family:
            halves = {h: [Scene(p) for p in split(h, family)] for h in ("design", "report")}
            trace, _ = search(kind, "ncg", args.budget, sample(), lambda x: round(mean_cost(halves["design"], x, kind)))
            x = best_of(trace)[0]
            for half, scenes in halves.items():
                alone = 0
                for s in scenes:
                    one, _ = search(kind, "ncg", args.budget, sample(), lambda y: s.cost(y, kind))
                    alone += best_of(one)[1] / len(scenes)
                values = [mean_cost(scenes, y, kind) for y in (DEFAULT, sample(), x)] + [alone]
                print(f"| {kind} | {family}, {half} ({'in-sample' if half == 'design' else 'not seen'}) | "
                      + " | ".join(f"{100 * v / 2**20:.2f}" for v in values) + f" | {x if half == 'design' else ''} |", flush=True)


if __name__ == "__main__":
    main()
