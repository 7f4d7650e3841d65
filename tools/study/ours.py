# SPDX-License-Identifier: MIT
"""The tuner of this library under the names of the tables, run like a rival: on costs in Q20, with its trace."""
from package import stadimeter

# name in the tables -> method, whether it brings the ladder of its cost, what it takes for cheap
SHARED = ("uniqueness_ratio", "disp12_max_diff")
OURS = {"ncg": ("ncg", True, ()), "ncg-shared": ("ncg", True, SHARED), "ncg-bare": ("ncg", False, ()), "hybrid": ("hybrid", False, ()),
        "ncg-paper": ("ncg-paper", False, ()), "sd": ("sd", False, ())}
NAMES = ("p1", "p2", "block_size", "uniqueness_ratio", "pre_filter_cap", "disp12_max_diff")


def search(kind, method, budget, start, cost_of, seed=1, channels=1):
    """Runs a search to its end. cost_of(tuple) -> Q20. The trace [(point, cost)] and the tuner's counts."""
    name, ladder, cheap = OURS[method]
    tuner = stadimeter.Tuner(dict(zip(NAMES, start)), purpose=kind if ladder else "any", method=name, budget=budget, seed=seed,
                             channels=channels, cheap=cheap)
    trace = []
    while (point := tuner.ask()) is not None:
        x = tuple(point[n] for n in NAMES)
        trace.append((x, cost_of(x)))
        tuner.tell_q20(trace[-1][1])
    return trace, tuner.counts()


def best_of(trace):
    return min(trace, key=lambda entry: entry[1])
