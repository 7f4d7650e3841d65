#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The loop on rendered targets in open scenes: ten scenes x eight kinds of degradation, one trial each.

    STAD_DATA=folder python3 tools/study/calib_trials/run.py --program build/calib-trial [--json OUT] [--full N] [--scenes A,B]

The target is composited into the scene, marks are found by the detector, truth comes from them; bad shares (1 px) are of the scene
outside the target, which the loop never sees. None of the scenes had a part in the presets (tools/study/presets). `full` is ncg on the scene's own truth (150 evaluations)."""
import argparse
import json
import math
import os
import subprocess
import sys

DATA = os.environ.get("STAD_DATA", "")
SCENES = ("middlebury2001/venus", "middlebury2005/Moebius", "middlebury2006/Bowling1", "middlebury2006/Cloth2", "middlebury2006/Lampshade1",
          "middlebury2006/Monopoly", "middlebury2006/Rocks2", "middlebury2006/Wood2", "middlebury2005/Laundry", "middlebury2006/Plastic")
KINDS = ("clean", "noise-5", "noise-10", "noise-20", "gain", "vignette", "low-light", "blur")
RULES = ("default", "strict", "none", "pick")


def trial(program, meta, scene, kind, seed, full):
    folder = os.path.join(DATA, scene)
    mask = os.path.join(folder, "nonocc.png")
    truth = os.path.join(folder, "disp.pfm")
    command = [program, f"{folder}/left.png", f"{folder}/right.png", truth if os.path.exists(truth) else f"{folder}/disp.png",
               str(meta["numDisparities"]), str(KINDS.index(kind)), str(seed), mask if os.path.exists(mask) else "-", str(full)]
    out = subprocess.run(command, capture_output=True, text=True)
    if out.returncode:
        sys.exit(f"{' '.join(command)}: {out.stderr}")
    row = json.loads(out.stdout)
    row["scene"] = scene
    return row


def manifest():
    """What the data folder says of each scene."""
    path = os.path.join(DATA, "MANIFEST.json")
    try:
        return {s["path"]: s for s in json.load(open(path)) if "path" in s}
    except OSError as error:
        sys.exit(f"{path}: {error.strerror}; STAD_DATA names the folder of scenes")


def chosen(given, whole):
    """The members of a list that were asked for."""
    names = given.split(",")
    for name in names:
        if name not in whole:
            sys.exit(f"{name}: not one of {', '.join(whole)}")
    return names


def mean(values):
    values = list(values)
    return sum(values) / len(values) if values else float("nan")


def table(rows):
    """Per kind: bad share in use, with full truth, and with each rule: bad, worse by > .5 point, worst change."""
    with_full = all("full" in r for r in rows)
    print(f"{'':10s} {'in use':>7s} {'full':>7s}" + "".join(f" | {rule:>8s} {'gain':>6s} {'>.5':>4s} {'worst':>6s}" for rule in RULES))
    for kind in KINDS + ("all",):
        part = [r for r in rows if kind in ("all", r["kind"])]
        if not part:
            continue
        use = mean(r["in_use"] for r in part)
        full = mean(r["full"]["bad"] for r in part) if with_full else float("nan")
        line = f"{kind:10s} {use:7.2f} {full:7.2f}"
        for rule in RULES:
            bad = mean(r[rule]["bad"] for r in part)
            change = [r[rule]["bad"] - r["in_use"] for r in part]
            line += f" | {bad:8.2f} {100 * (use - bad) / (use - full):5.0f}% {sum(c > .5 for c in change):4d} {max(change):+6.2f}"
        print(line)
    print("evaluations:", ", ".join(f"{rule} {mean(r[rule]['evaluations'] for r in rows):.1f} (most {max(r[rule]['evaluations'] for r in rows)})" for rule in RULES))


def margins(rows):
    """What another margin for tuned sets would adopt: `none` tunes from the pick and adopts always; where its pick is that of the default
    rule, its judgement and its rest tell what any margin would have made of it."""
    same = [r["none"]["preset"] == r["pick"]["preset"] for r in rows]
    gain = [r["pick"]["judge"][1] - r["none"]["judge"][1] for r in rows]
    sigma = [100 * math.sqrt(max(r["pick"]["judge"][1] / 100 * (1 - r["pick"]["judge"][1] / 100), 0) * 100 / max(r["pixels"], 1)) for r in rows]
    use, full = mean(r["in_use"] for r in rows), mean(r["full"]["bad"] for r in rows)
    print(f"\ntuned sets by other margins ({sum(same)} of {len(rows)} trials start from the same pick)")
    for name, points, sigmas in (("none is adopted", 1e9, 0), ("all are", -1e9, 0), ("not worse", 0, 0), ("1 point", 1, 0), ("2 points", 2, 0),
                                 ("1 sigma", 0, 1), ("2 sigma", 0, 2), ("2 points and 3 sigma", 2, 3)):
        taken = [s and g >= max(points, sigmas * d if sigmas else -1e9) for s, g, d in zip(same, gain, sigma)]
        bad = [r["none" if t else "pick"]["bad"] for r, t in zip(rows, taken)]
        change = [r["none"]["bad"] - r["pick"]["bad"] for r, t in zip(rows, taken) if t]
        print(f"{name:22s} {mean(bad):6.2f} {100 * (use - mean(bad)) / (use - full):4.0f}%  adopted {sum(taken):2d}: better by > .5 point "
              f"{sum(c < -.5 for c in change):2d}, worse by > .5 point {sum(c > .5 for c in change):2d}")


def main():
    args = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    args.add_argument("--program", default="build/calib-trial")
    args.add_argument("--json")
    args.add_argument("--full", type=int, default=150)
    args.add_argument("--scenes", default=",".join(SCENES))
    args.add_argument("--kinds", default=",".join(KINDS))
    args.add_argument("--again", help="print the table of a JSON file")
    args = args.parse_args()
    if args.again:
        rows = json.load(open(args.again))
        table(rows)
        if all("full" in r for r in rows):
            margins(rows)
        return
    scenes, kinds, meta = chosen(args.scenes, SCENES), chosen(args.kinds, KINDS), manifest()
    rows = []
    for scene in scenes:
        seed = SCENES.index(scene) + 1  # a part of the table has the rows of the whole
        for kind in kinds:
            rows.append(trial(args.program, meta[scene], scene, kind, seed, args.full))
            r = rows[-1]
            print(scene, kind, f"{r['in_use']:.2f}", *(f"{rule} {r[rule]['bad']:.2f} o{r[rule]['outcome']}" for rule in RULES),
                  f"full {r['full']['bad']:.2f}" if "full" in r else "", flush=True)
        if args.json:
            json.dump(rows, open(args.json, "w"))
    table(rows)
    if all("full" in r for r in rows):
        margins(rows)


if __name__ == "__main__":
    main()
