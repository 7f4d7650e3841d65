#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Derives lib/src/calib/presets.c from the design scenes, without the two that the calibration trials use.

    STAD_DATA=folder python3 tools/study/presets/run.py --program build/preset-derive [--evaluations 120]

Prints the derived sets, what each costs under every kind of degradation (share of the sample parameters' bad pixels), and the
seven of them that together leave the least under the kind that is worst off: the table for the library."""
import argparse
import itertools
import json
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from data_folder import entries  # noqa: E402

DATA = os.environ.get("STAD_DATA", "")
SCENES = ("middlebury2003/cones", "middlebury2005/Dolls", "middlebury2006/Aloe", "middlebury2006/Bowling2", "middlebury2006/Cloth1", "middlebury2006/Wood1",
          "middlebury2014/Motorcycle")
PRESETS = 7


def main():
    args = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    args.add_argument("--program", default="build/preset-derive")
    args.add_argument("--evaluations", type=int, default=120)
    args = args.parse_args()
    meta = {s["path"]: s for s in entries(DATA) if "path" in s}
    command = [args.program, str(args.evaluations)]
    for scene in SCENES:
        folder = os.path.join(DATA, scene)
        truth, mask = os.path.join(folder, "disp.pfm"), os.path.join(folder, "nonocc.png")
        command += [f"{folder}/left.png", f"{folder}/right.png", truth if os.path.exists(truth) else f"{folder}/disp.png",
                    str(meta[scene]["numDisparities"]), mask if os.path.exists(mask) else "-"]
    sets = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    kinds = [k for k in sets if k != "all"]
    print(f"{'':10s} " + " ".join(f"{k:>9s}" for k in kinds))
    for name, s in sets.items():
        print(f"{name:10s} " + " ".join(f"{v:9.3f}" for v in s["under"]), s["point"])
    def left(group):
        best = [min(sets[name]["under"][k] for name in group) for k in range(len(kinds))]
        return sum(best) / len(best)
    group = min(itertools.combinations(sets, PRESETS), key=left)
    print(f"seven of nine: {', '.join(group)}: mean {left(group):.4f}, all nine {left(tuple(sets)):.4f}")
    for name in group:
        point = sets[name]["point"]
        point[4] |= 1  # the matcher wants an odd cap
        print(f'    {{"{name}", {{{{{", ".join(map(str, point))}}}}}}},')


if __name__ == "__main__":
    main()
