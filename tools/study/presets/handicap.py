#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""By how much the target flatters each preset: the handicaps of lib/src/calib/presets.c, from the scenes that the presets come from.

    STAD_DATA=folder python3 tools/study/presets/handicap.py --program build/calib-trial [--json OUT]

For every trial and preset: log of the cost ratio on the rest of the scene (preset : sample) less the same on the target, one point added to every cost.
The handicap is the mean over trials, 1.2 times as far from none for safety, never below 5 %: a smaller gain on the target is no evidence. Also prints what picking with it would have given, and the
same with the handicaps of the other scenes only."""
import argparse
import json
import math
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "calib_trials"))
import run as trials  # noqa: E402
from importlib.util import module_from_spec, spec_from_file_location  # noqa: E402

spec = spec_from_file_location("derive", os.path.join(HERE, "run.py"))
derive = module_from_spec(spec)
spec.loader.exec_module(derive)
SAFETY = 1.2
LEAST = 1.05


def handicaps(rows):
    logs = [[math.log((set_[2] + 1) / (row["ladder"][0][2] + 1)) - math.log((set_[0] + 1) / (row["ladder"][0][0] + 1)) for set_ in row["ladder"]] for row in rows]
    return [1.0] + [max(LEAST, math.exp(SAFETY * sum(column) / len(column))) for column in list(zip(*logs))[1:]]


def picked(row, raised):
    """Bad share of the rest with what the target picks."""
    sets = row["ladder"]
    best = min(range(len(sets)), key=lambda i: (sets[i][0] + 1) * raised[i])
    return sets[best if (sets[best][1] + 1) * raised[best] <= sets[0][1] + 1 else 0][2]


def say(name, pairs):
    use, got = sum(u for u, _ in pairs), sum(g for _, g in pairs)
    print(f"{name}: {use / len(pairs):.2f} -> {got / len(pairs):.2f} %, worse by > .5 point in {sum(g - u > .5 for u, g in pairs)} of {len(pairs)}, "
          f"at most {max(g - u for u, g in pairs):+.2f}")


def main():
    args = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    args.add_argument("--program", default="build/calib-trial")
    args.add_argument("--json")
    args.add_argument("--again")
    args = args.parse_args()
    os.environ["STAD_PICK_ONLY"] = "1"
    if args.again:
        rows = json.load(open(args.again))
    else:
        meta = trials.manifest()
        rows = [trials.trial(args.program, meta[scene], scene, kind, 200 + i, 0) for i, scene in enumerate(derive.SCENES) for kind in trials.KINDS]
    if args.json:
        json.dump(rows, open(args.json, "w"))
    raised = handicaps(rows)
    print("raised by:", " ".join(f"{r - 1:.2f}" for r in raised[1:]))
    none = [1.0] * len(raised)
    say("without handicap", [(r["ladder"][0][2], picked(r, none)) for r in rows])
    say("with it", [(r["ladder"][0][2], picked(r, raised)) for r in rows])
    others = {scene: handicaps([r for r in rows if r["scene"] != scene]) for scene in {r["scene"] for r in rows}}
    say("with that of the other scenes", [(r["ladder"][0][2], picked(r, others[r["scene"]])) for r in rows])


if __name__ == "__main__":
    main()
