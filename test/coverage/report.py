#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""report.py COVERAGE FOLDER UNREACHED MIN - branch sides taken, a file a line; unexplained ones and stale explanations by line.

A line of UNREACHED: file, tab, text of the source line (trimmed), tab, the number of its sides not taken, tab, why."""
import collections
import json
import sys


def read(path, folder):
    """{file: {(line, columns, side): times taken}}; inline functions are counted over all files that hold them."""
    sides = collections.defaultdict(collections.Counter)
    for file in json.load(open(path))["data"][0]["files"]:
        if file["filename"].startswith(folder):
            for line, column, line_end, column_end, taken, not_taken, *_ in file["branches"]:
                place = sides[file["filename"][len(folder) + 1 :]]
                place[line, column, line_end, column_end, True] += taken
                place[line, column, line_end, column_end, False] += not_taken
    return sides


def listed(path):
    reasons = {}
    for text in open(path):
        if text.strip() and not text.startswith("#"):
            file, line, count, why = text.rstrip("\n").split("\t")
            reasons[file, line] = [int(count), why]
    return reasons


def main():
    coverage, folder, unreached, least = sys.argv[1:]
    sides, reasons = read(coverage, folder), listed(unreached)
    total = missed = bad = 0
    for path in sorted(sides):
        source = open(f"{folder}/{path}").read().splitlines()
        not_taken = collections.Counter(source[line - 1].strip() for (line, *_), n in sides[path].items() if n == 0)
        count, miss = len(sides[path]), sum(not_taken.values())
        total, missed = total + count, missed + miss
        print(f"{path:28} {count - miss:4} of {count:4} branch sides{'' if miss == 0 else f', {100 * (count - miss) / count:.1f} %'}")
        for text, n in not_taken.items():
            known = reasons.pop((path, text), None)
            if known is None or known[0] != n:
                print(f"    {n} not taken, {'unexplained' if known is None else f'{known[0]} explained'}: {text}")
                bad += 1
    for (path, text), _ in reasons.items():
        print(f"    explained but taken, or gone: {path}: {text}")
        bad += 1
    share = 100 * (total - missed) / total
    print(f"total: {total - missed} of {total} branch sides, {share:.2f} %; {missed} not taken; {bad} of these lines not as listed")
    return 0 if share >= float(least) and bad == 0 else 1


sys.exit(main())
