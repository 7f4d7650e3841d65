#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Table 1: every method on every scene, tuned on one cost with the same budget, and what it reached.

    STAD_DATA=... tools/study/table1.py [--cost chow,bad] [--family middlebury,driving] [--half design,report]
                                        [--method NAME,...] [--budget 150] [--out results.json] [--html FILE]

Runs what results.json does not hold yet, then prints the tables from it. All methods: same start (sample), same lattice,
budget counted in distinct evaluations. `to 2 %`: evaluations until the cost is within 2 % of the best that any method
reached on that scene; `never` counts as more than the budget. `gap`: to that best, at the budget."""
import argparse
import json
import os
import statistics
import sys
import time

from native import FAILED, METHODS, Native
import rivals
import scenes
from scenes import DEFAULT, Scene, measures, sample, split

OURS = {"ncg": ("ncg", True), "ncg-bare": ("ncg", False), "hybrid": ("hybrid", False), "ncg-paper": ("ncg-paper", False), "sd": ("sd", False)}
ORDER = ["ncg", "ncg-bare", "hybrid", "ncg-paper", "sd", "grid", "bobyqa", "nelder-mead", "cma-es", "tpe", "pso", "ga", "random"]


def run(native, scene, kind, method, budget):
    begin = time.time()
    if method in OURS:
        name, ladder = OURS[method]
        config = native.config(kind if ladder else "any", name, budget)
        config.seed = 1
        trace, n = native.tune(config, sample(), lambda x: scene.cost(x, kind))
        calls, iterations = n.calls, n.iterations
    else:
        box = rivals.run(method, lambda x: scene.cost(x, kind), sample(), budget)
        trace, calls, iterations = box.trace, box.calls, None
    best = min(trace, key=lambda p: p[1])
    return {"best": list(best[0]), "costs": [c for _, c in trace], "calls": calls, "iterations": iterations, "seconds": round(time.time() - begin, 1)}


def fill(results, path, args):
    native = Native()
    for kind in args.cost:
        for family in args.family:
            for half in args.half:
                for place in split(half, family):
                    todo = [m for m in args.method if f"{kind}|{place}|{m}" not in results]
                    if not todo:
                        continue
                    scene = Scene(place, native)
                    for m in todo:
                        results[f"{kind}|{place}|{m}"] = run(native, scene, kind, m, args.budget)
                        print(f"{kind} {place} {m}", file=sys.stderr)
                    part = path + ".part"
                    with open(part, "w") as f:
                        json.dump(results, f)
                    os.replace(part, path)


def first_within(costs, limit):
    return next((i + 1 for i, c in enumerate(costs) if c <= limit), float("inf"))


def text(v, digits=2):
    return "never" if v == float("inf") else f"{v:.{digits}f}" if digits else f"{v:g}"


def rows(results, kind, places, methods):
    """One row a method: medians and means over the scenes that it and all others have been run on."""
    loaded = {p: Scene(p) for p in places}
    have = [m for m in methods if all(f"{kind}|{p}|{m}" in results for p in places)]
    best = {p: min(min(r["costs"]) for k, r in results.items() if k.startswith(f"{kind}|{p}|")) for p in places}
    out = []
    for name, x in (("default", DEFAULT), ("sample", sample())):
        ms = [measures(loaded[p].counts(x)) for p in places]
        gaps = [100 * (loaded[p].cost(x, kind) / best[p] - 1) for p in places]
        out.append((name, ms, gaps, None, 1, 0))
    for m in have:
        rs = [results[f"{kind}|{p}|{m}"] for p in places]
        ms = [measures(loaded[p].counts(tuple(r["best"]))) for p, r in zip(places, rs)]
        gaps = [100 * (min(r["costs"]) / best[p] - 1) for p, r in zip(places, rs)]
        steps = [first_within(r["costs"], 1.02 * best[p]) for p, r in zip(places, rs)]
        its = [r["iterations"] for r in rs]
        out.append((m, ms, gaps, steps, statistics.mean(len(r["costs"]) for r in rs), None if None in its else statistics.mean(its)))
    return out


def markdown(kind, title, table):
    lines = [f"**{title}, tuned on {kind}**", "", "| method | bad % | chow % | RMSE px | density % | gap % | to 2 % (median) | reached | evaluations | iterations |",
             "|---|---|---|---|---|---|---|---|---|---|"]
    for name, ms, gaps, steps, n, its in table:
        mean = lambda key: statistics.mean(m[key] for m in ms)
        reach = f"{sum(s != float('inf') for s in steps)} of {len(steps)}" if steps else ""
        lines.append(f"| {name} | {mean('bad'):.2f} | {mean('chow'):.2f} | {mean('rmse'):.2f} | {mean('density'):.1f} | {statistics.mean(gaps):.2f} | "
                     f"{text(statistics.median(steps), 1) if steps else ''} | {reach} | {n:.0f} | {'' if its is None else format(its, '.0f')} |")
    return "\n".join(lines)


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    listed = lambda s: s.split(",")
    a.add_argument("--cost", type=listed, default=["chow", "bad"])
    a.add_argument("--family", type=listed, default=["middlebury", "driving"])
    a.add_argument("--half", type=listed, default=["design", "report"])
    a.add_argument("--method", type=listed, default=ORDER)
    a.add_argument("--budget", type=int, default=150)
    a.add_argument("--out", default="results.json")
    a.add_argument("--html")
    a.add_argument("--print-only", action="store_true")
    args = a.parse_args()
    results = json.load(open(args.out)) if os.path.exists(args.out) else {}
    if not args.print_only:
        fill(results, args.out, args)
    parts = [markdown(kind, f"{family}, {half} half ({len(split(half, family))} scenes)", rows(results, kind, split(half, family), args.method))
             for kind in args.cost for family in args.family for half in args.half]
    print("\n\n".join(parts))
    if args.html:
        from report import html
        html(args.html, results, args, parts)


if __name__ == "__main__":
    main()
