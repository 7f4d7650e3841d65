#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What keeping winners saves: a search of `stad tune` with --share 3 against --share 0 and against as many plain matches.

    STAD_DATA=... tools/study/sharing.py [--stad build/stad] [--cost bad] [--disparities 64] [--evals 60] [--rounds 5] [SCENE ...]
    STAD_DATA=... tools/study/sharing.py --matches [--cost bad]

Both searches must ask for the same points. Processor seconds of the whole process, pictures read and all, the least of the rounds,
the two in turn; `alone`: of the evaluations alone, what a search of one point takes left out; `matches`: `stad bench` at the scene's
size, times the evaluations. `served`: points that differ from one of
those kept, the best two and the last, in uniqueness_ratio and disp12_max_diff alone.

--matches: what settling costs. ncg with and without, 150 evaluations on every scene at its own size: medians of the evaluations, and
of the matches that these need, until within 2 % of the better of the two; mean distance to it after 60 evaluations, 40 matches
and at the end."""
import argparse
import itertools
import json
import math
import os
import resource
import statistics
import subprocess
import tempfile

from data_folder import entries
from ours import search
from scenes import Scene, sample, split

HERE = os.path.dirname(os.path.abspath(__file__))
DATA = os.environ.get("STAD_DATA", "")
KEPT = 3  # what `stad tune` keeps when it is not told
SCENES = ["middlebury2014/Motorcycle"] + [f"middlebury{s}" for s in (
    "2001/venus 2003/cones 2005/Dolls 2005/Laundry 2005/Moebius 2006/Aloe 2006/Bowling1 2006/Bowling2 2006/Cloth1 2006/Cloth2 "
    "2006/Lampshade1 2006/Monopoly 2006/Plastic 2006/Rocks2 2006/Wood1 2006/Wood2").split()]


def run(command):
    """Output and processor seconds of a process."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    out = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return out, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def matched(points):
    """For each point whether it needs a match of its own."""
    kept, out = {}, []  # the least cost of each; the worst gives way
    for (p1, p2, block, _, cap, _), cost in points:
        sums = (p1, p2, block, cap)
        out.append(sums not in kept)
        if out[-1] and len(kept) == KEPT:
            del kept[max(kept, key=kept.get)]
        kept[sums] = min(cost, kept.get(sums, cost))
    return out


def served(cost, trace):
    """The tool's JSON holds costs; the tuner, told these, asks for the same points again."""
    told = iter(trace)
    points, _ = search(cost, "ncg-shared" if cost == "bad" else "ncg", len(trace), sample(), lambda _: round(next(told)[1] * 2**20), seed=0)
    return matched(points).count(False)


def settling(cost):
    print("| scenes | method | evaluations to 2 % | matches to 2 % | gap at 60 evaluations % | at 40 matches % | at 150 evaluations % |\n|---|---|---|---|---|---|---|")
    for family in ("middlebury", "driving"):
        for half in ("design", "report"):
            rows = {"ncg": [], "ncg-shared": []}
            for place in split(half, family):
                scene = Scene(place)
                runs = {m: search(cost, m, 150, sample(), lambda x: scene.cost(x, cost))[0] for m in rows}
                best = min(c for points in runs.values() for _, c in points)
                for m, points in runs.items():
                    need = list(itertools.accumulate(matched(points)))
                    reached = next((i for i, (_, c) in enumerate(points) if c <= 1.02 * best), None)
                    gap = lambda some: 100 * (min(c for _, c in some) / best - 1)
                    rows[m].append((math.inf if reached is None else reached + 1, math.inf if reached is None else need[reached], gap(points[:60]),
                                    gap([p for p, n in zip(points, need) if n <= 40]), gap(points)))
            for m, of_scenes in rows.items():
                columns = list(zip(*of_scenes))
                print(f"| {family}, {half} | {m} | {statistics.median(columns[0]):g} | {statistics.median(columns[1]):g} | "
                      + " | ".join(f"{statistics.mean(c):.2f}" for c in columns[2:]) + " |", flush=True)


def measure(args, place, json_path):
    folder = os.path.join(DATA, place)
    truth = os.path.join(folder, "disp.pfm")
    truth = truth if os.path.exists(truth) else os.path.join(folder, "disp.png")
    mask = os.path.join(folder, "nonocc.png")
    command = [args.stad, "tune", os.path.join(folder, "left.png"), os.path.join(folder, "right.png"), "--truth", truth, "--cost", args.cost,
               "--num-disparities", str(args.disparities), "--json", json_path]
    command += ["--mask", mask] if os.path.exists(mask) else []
    meta = {s["path"]: s for s in entries(DATA)}[place]
    bench = [args.stad, "bench", "--mode", "sgbm", "--width", str(meta["W"]), "--height", str(meta["H"]), "--num-disparities", str(args.disparities),
             "--frames", "15"]
    times, traces, frames, single = {0: [], KEPT: []}, {}, [], []
    for _ in range(args.rounds):
        single.append(run(command + ["--max-evals", "1"])[1])
        for share in times:
            times[share].append(run(command + ["--max-evals", str(args.evals), "--share", str(share)])[1])
            traces[share] = json.load(open(json_path))["trace"]
        frames.append(float(run(bench)[0].split(" ms")[0].split()[-1]) / 1000)
    assert traces[0] == traces[KEPT], "sharing changed the search"
    without, shared, plain = min(times[0]), min(times[KEPT]), min(frames) * len(traces[0])
    alone = (shared - min(single)) * len(traces[0]) / (len(traces[0]) - 1)
    print(f"| {place.split('/')[-1]} {meta['W']} x {meta['H']} | {len(traces[0])} | {served(args.cost, traces[KEPT])} | {plain:.2f} | {without:.2f} | {shared:.2f} | {alone:.2f} | "
          f"{shared / without:.2f} | {shared / plain:.2f} | {alone / plain:.2f} |", flush=True)
    return shared / without, shared / plain, alone / plain


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    a.add_argument("scenes", nargs="*", default=SCENES)
    a.add_argument("--stad", default=os.path.join(HERE, "..", "..", "build", "stad"))
    a.add_argument("--cost", default="bad")
    a.add_argument("--disparities", type=int, default=64)
    a.add_argument("--evals", type=int, default=60)
    a.add_argument("--rounds", type=int, default=5)
    a.add_argument("--matches", action="store_true")
    args = a.parse_args()
    if args.matches:
        return settling(args.cost)
    print("| scene | points | served | matches s | without s | with s | alone s | with / without | with / matches | alone / matches |\n|---|---|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as work:
        ratios = [measure(args, place, os.path.join(work, "tuned.json")) for place in args.scenes]
    mean = lambda column: math.exp(sum(math.log(r[column]) for r in ratios) / len(ratios))
    print(f"| geometric mean |  |  |  |  |  |  | {mean(0):.2f} | {mean(1):.2f} | {mean(2):.2f} |")


if __name__ == "__main__":
    main()
