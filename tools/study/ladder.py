#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Which start ladder serves costs and frames it was not fitted for: d1, and frames of 3 channels.

    STAD_DATA=... tools/study/ladder.py

Design scenes, 100 evaluations. For each ladder: median of the evaluations to within 2 % of the best of the runs compared, and
the mean distance to it after 30 and 100."""
import statistics

from ours import search
from scenes import Scene, sample

INDOORS = ["middlebury2003/cones", "middlebury2006/Aloe", "middlebury2006/Wood1", "middlebury2006/Bowling2", "middlebury2005/Dolls"]
DRIVING = ["kitti2015/000007_10", "kitti2015/000010_10", "kitti2012/000000_10"]


def compare(title, places, cost, ladders, colour=False):
    """ladders: name -> (purpose or None for none, channels the ladder is scaled for)."""
    runs = {name: [] for name in ladders}
    for place in places:
        scene, start = Scene(place, colour), sample(channels=3 if colour else 1)
        traces = {name: [c for _, c in search(purpose or "any", "ncg", 100, start, lambda x: scene.cost(x, cost), channels=channels)[0]]
                  for name, (purpose, channels) in ladders.items()}
        best = min(min(t) for t in traces.values())
        for name, t in traces.items():
            to2 = next((i + 1 for i, c in enumerate(t) if c <= 1.02 * best), float("inf"))
            runs[name].append((to2, 100 * (min(t[:30]) / best - 1), 100 * (min(t) / best - 1)))
    for name, rows in runs.items():
        to2, at30, at100 = zip(*rows)
        middle = statistics.median(to2)
        print(f"| {title} | {cost} | {name} | {'never' if middle == float('inf') else f'{middle:g}'} | {statistics.mean(at30):.2f} | {statistics.mean(at100):.2f} |", flush=True)


def main():
    print("| scenes | cost | ladder | to 2 % | gap at 30 % | gap at 100 % |\n|---|---|---|---|---|---|")
    for title, places in (("5 indoors", INDOORS), ("3 driving", DRIVING)):
        compare(title, places, "d1", {"none": (None, 1), "of bad": ("bad", 1), "of chow": ("chow", 1)})
    for cost in ("chow", "bad"):
        compare("5 indoors, 3 channels", INDOORS, cost, {"none": (None, 1), "as for grey": (cost, 1), "P1, P2 times 3": (cost, 3)}, True)


if __name__ == "__main__":
    main()
