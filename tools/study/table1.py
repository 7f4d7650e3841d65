#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Table 1: every method on every scene, tuned on one cost with the same budget, and what it reached.

    STAD_DATA=... tools/study/table1.py [--cost chow,bad] [--family middlebury,driving] [--method NAME,...] [--aside NAME,...]
                                        [--budget 150] [--out results.json] [--csv FILE] [--html FILE] [--figures FOLDER]

Runs what results.json does not hold yet, then prints the tables from it: means over all open scenes of a family, distance
and speed on design and report scenes apart, and every scene's cost. All methods: same start (sample), same lattice, budget
counted in distinct evaluations. `gap`: to the best that any method of the table reached on that scene, at the budget; the
methods set aside, by default two variants of ncg, are in the table but are no goal. `to 2 %`: median of the evaluations until
within 2 % of it. `seconds`: distinct evaluations times the processor seconds of one on that scene (measured in this run, median
of ten points); what a method takes to think is not counted."""
import argparse
import csv
import json
import os
import statistics
import sys
import time

import rivals
from costs import measures
from ours import OURS, best_of, search
from scenes import DEFAULT, Scene, sample, split

ORDER = ["ncg", "ncg-shared", "ncg-bare", "hybrid", "ncg-paper", "sd", "grid", "bobyqa", "nelder-mead", "cma-es", "tpe", "pso", "ga", "random"]
VARIANTS = ["ncg-shared", "ncg-bare"]
HALVES = ("design", "report")
NEVER = float("inf")


def run(scene, kind, method, budget):
    """One search."""
    cost_of = lambda x: scene.cost(x, kind)
    if method in OURS:
        trace, n = search(kind, method, budget, sample(), cost_of)
        calls, iterations = n["calls"], n["iterations"]
    else:
        box = rivals.run(method, cost_of, sample(), budget)
        trace, calls, iterations = box.trace, box.calls, box.rounds
    return {"best": list(best_of(trace)[0]), "costs": [c for _, c in trace], "calls": calls, "iterations": iterations}


def fill(results, path, args):
    for family in args.family:
        for place in split("report", family) + split("design", family):
            todo = [(k, m) for k in args.cost for m in args.method if f"{k}|{place}|{m}" not in results]
            if not todo and f"seconds|{place}" in results:
                continue
            scene = Scene(place)
            for kind, m in todo:
                begin = time.time()
                results[f"{kind}|{place}|{m}"] = run(scene, kind, m, args.budget)
                print(f"{kind} {place} {m} {time.time() - begin:.1f} s", file=sys.stderr, flush=True)
            some = [tuple(results[f"chow|{place}|{m}"]["best"]) for m in args.method if f"chow|{place}|{m}" in results]
            results[f"seconds|{place}"] = scene.seconds_of_one(([DEFAULT, sample()] + some)[:10])
            with open(path + ".part", "w") as f:
                json.dump(results, f)
            os.replace(path + ".part", path)


def first_within(costs, limit):
    return next((i + 1 for i, c in enumerate(costs) if c <= limit), NEVER)


def best_cost(results, kind, place, aside):
    """The best cost of any method on a scene, but of those set aside."""
    return min(min(r["costs"]) for k, r in results.items() if k.startswith(f"{kind}|{place}|") and k.split("|")[2] not in aside)


def entry(results, scene, kind, method, aside):
    """What a method reached on a scene: a dict of the columns."""
    best, one = best_cost(results, kind, scene.path, aside), results[f"seconds|{scene.path}"]
    if method in ("default", "sample"):
        x = DEFAULT if method == "default" else sample()
        r = {"best": x, "costs": [scene.cost(x, kind)], "iterations": 0}
    else:
        r = results[f"{kind}|{scene.path}|{method}"]
    n = len(r["costs"])
    return dict(measures(scene.counts(tuple(r["best"]))), iterations=r["iterations"], evaluations=n, seconds=n * one,
                gap=100 * (min(r["costs"]) / best - 1), to2=first_within(r["costs"], 1.02 * best), point=tuple(r["best"]))


def table(results, kind, family, methods, aside):
    """method -> half -> entries, for the methods that were run on every scene of the family."""
    places = {h: split(h, family) for h in HALVES}
    scenes = {p: Scene(p) for h in HALVES for p in places[h]}
    whole = [m for m in methods if all(f"{kind}|{p}|{m}" in results for p in scenes)]
    return {m: {h: {p: entry(results, scenes[p], kind, m, aside) for p in places[h]} for h in HALVES} for m in ["default", "sample"] + whole}


def median_text(entries):
    m = statistics.median(e["to2"] for e in entries.values())
    return "never" if m == NEVER else f"{m:g}"


def means(kind, family, tab):
    count = sum(len(v) for v in tab["default"].values())
    lines = [f"**{family}, all {count} open scenes, tuned on {kind}**", "",
             "| method | bad % | chow % | RMSE px | density % | iterations | evaluations | seconds | gap %: design | report | to 2 %: design | report |",
             "|---|---|---|---|---|---|---|---|---|---|---|---|"]
    for m, halves in tab.items():
        every = [e for h in HALVES for e in halves[h].values()]
        mean = lambda key, digits: f"{statistics.mean(e[key] for e in every):.{digits}f}"
        gaps = [f"{statistics.mean(e['gap'] for e in halves[h].values()):.2f}" for h in HALVES]
        tuned = m not in ("default", "sample")
        reach = [median_text(halves[h]) if tuned else "" for h in HALVES]
        rounds = mean("iterations", 0) if any(e["iterations"] for e in every) else ""
        lines.append(f"| {m} | {mean('bad', 2)} | {mean('chow', 2)} | {mean('rmse', 2)} | {mean('density', 1)} | {rounds} | {mean('evaluations', 0)} | "
                     f"{mean('seconds', 2)} | {' | '.join(gaps)} | {' | '.join(reach)} |")
    return "\n".join(lines)


def by_scene(kind, family, tab):
    lines = [f"**{family}, {kind} in percent after tuning on it, scene by scene** (r: report scene)", "",
             "| scene | " + " | ".join(tab) + " |", "|---" * (len(tab) + 1) + "|"]
    for h in HALVES:
        for place in tab["default"][h]:
            name = (place if family == "driving" else place.split("/")[1]) + (" (r)" if h == "report" else "")
            lines.append(f"| {name} | " + " | ".join(f"{tab[m][h][place][kind]:.2f}" for m in tab) + " |")
    return "\n".join(lines)


def write_csv(path, tables):
    columns = ("bad", "chow", "rmse", "density", "iterations", "evaluations", "seconds", "gap", "to2")
    with open(path, "w", newline="") as f:
        out = csv.writer(f, lineterminator="\n")
        out.writerow(("cost", "family", "half", "scene", "method") + columns + ("p1", "p2", "block_size", "uniqueness_ratio", "pre_filter_cap", "disp12_max_diff"))
        for (kind, family), tab in tables.items():
            for m, halves in tab.items():
                for h in HALVES:
                    for place, e in halves[h].items():
                        values = [f"{e[c]:.4g}" if isinstance(e[c], float) else e[c] for c in columns]
                        out.writerow([kind, family, h, place, m] + ["" if v == "inf" else v for v in values] + list(e["point"]))


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    listed = lambda s: s.split(",")
    a.add_argument("--cost", type=listed, default=["chow", "bad"])
    a.add_argument("--family", type=listed, default=["middlebury", "driving"])
    a.add_argument("--method", type=listed, default=ORDER)
    a.add_argument("--aside", type=listed, default=VARIANTS)
    a.add_argument("--budget", type=int, default=150)
    a.add_argument("--out", default="results.json")
    a.add_argument("--csv")
    a.add_argument("--html")
    a.add_argument("--figures")
    args = a.parse_args()
    results = json.load(open(args.out)) if os.path.exists(args.out) else {}
    fill(results, args.out, args)
    tables = {(k, f): table(results, k, f, args.method, args.aside) for k in args.cost for f in args.family}
    parts = [show(k, f, tab) for show in (means, by_scene) for (k, f), tab in tables.items()]
    print("\n\n".join(parts))
    if args.csv:
        write_csv(args.csv, tables)
    if args.html or args.figures:
        import report
        report.write(results, args, parts)


if __name__ == "__main__":
    main()
