#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The genetic algorithm at full length, 24 x 150 calls, against ncg at 150 evaluations.

    STAD_DATA=... tools/study/ga24x150.py [--cost chow] SCENE...            (default: Rocks2 and Cloth2)"""
import argparse

import rivals
from native import Native
from scenes import Scene, sample


class Calls:
    """Ends a rival after a number of calls instead of distinct evaluations."""

    def __init__(self, box, most):
        self.box, self.left, self.start = box, most, box.start

    def __call__(self, cube):
        self.left -= 1
        if self.left < 0:
            raise rivals.Spent
        return self.box(cube)


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    a.add_argument("--cost", default="chow")
    a.add_argument("scene", nargs="*", default=["middlebury2006/Rocks2", "middlebury2006/Cloth2"])
    args = a.parse_args()
    native = Native()
    for place in args.scene:
        scene = Scene(place, native)
        box = rivals.Box(lambda x: scene.cost(x, args.cost), 10**6, sample())
        try:
            rivals.ga(Calls(box, 24 * 150), 1, 24)
        except rivals.Spent:
            pass
        costs = [c for _, c in box.trace]
        ours = [c for _, c in native.tune(native.config(args.cost, "ncg", 150), sample(), lambda x: scene.cost(x, args.cost))[0]]
        there = next((i + 1 for i, c in enumerate(ours) if c <= min(costs)), None)
        print(f"{place}: GA {100 * min(costs) / 2**20:.3f} % at evaluation {costs.index(min(costs)) + 1} of {len(costs)} distinct; ncg there at {there}, "
              f"ends at {100 * min(ours) / 2**20:.3f} %")


if __name__ == "__main__":
    main()
