#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Labels, counts and costs against a second implementation: numpy on whole images, written from the definitions of
docs/TUNING.md in floating point and by brute force. Random scenes; a difference prints its seed. STAD_DATA adds a real one."""
import os
import sys

try:
    import numpy as np
except ImportError:
    print("SKIPPED: numpy is missing")
    sys.exit(77)

ROOT = os.environ.get("STAD_SOURCE") or os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path.insert(0, os.path.join(ROOT, "tools", "study"))
import costs  # noqa: E402
from package import stadimeter  # noqa: E402

NONE = -2**31


def labels(truth, known):
    """Brute force: pixel by pixel, against every other pixel of its row."""
    h, w = truth.shape
    out = np.zeros((h, w), np.uint8)
    for y in range(h):
        xs = np.flatnonzero(known[y])
        at = xs - truth[y, xs]
        low, high = np.floor(at), np.ceil(at)
        for i, x in enumerate(xs):
            column = np.ceil(at[i] - 0.5)  # a half goes left, away from the nearer column
            nearer = truth[y, xs] - truth[y, x] > 1
            hidden = np.any(nearer & ((low == column) | (high == column)))
            out[y, x] = 2 if hidden or column < 0 or column >= w else 1
    return out


def expected(disp, truth, known, label, disparities, threshold):
    d, none = disp / 16.0, disp < 0
    inside = np.arange(disp.shape[1])[None, :] >= disparities
    seen, hidden = known & inside & (label == 1), known & inside & (label == 2)
    error = np.abs(d - truth)
    wrong = (error > threshold) & ~none
    d1 = (error > 3) & (error > 0.05 * np.abs(truth)) & ~none
    matched = seen & ~none
    n = dict(visible=seen.sum(), occluded=hidden.sum(), wrong_visible=(wrong & seen).sum(), wrong_occluded=(wrong & hidden).sum(),
             missing_visible=(none & seen).sum(), missing_occluded=(none & hidden).sum(), d1_visible=(d1 & seen).sum(), d1_occluded=(d1 & hidden).sum())
    bad = (n["wrong_visible"] + n["missing_visible"]) / max(n["visible"], 1)
    chow = (2 * n["wrong_visible"] + 2 * n["wrong_occluded"] + n["missing_visible"]) / max(2 * (n["visible"] + n["occluded"]), 1)
    rmse = np.sqrt(np.mean(error[matched] ** 2)) if matched.any() else 0.0
    return n, bad, chow, rmse


def compare(name, disp, truth, known, disparities, threshold):
    q16 = np.where(known, np.rint(np.where(known, truth, 0) * 65536), NONE).astype(np.int32)
    label = stadimeter.label(q16)
    want = labels(truth, known)
    failures = [] if np.array_equal(label, want) else [f"labels differ at {np.argwhere(label != want)[:3].tolist()}"]
    n, bad, chow, rmse = expected(disp, truth, known, want, disparities, threshold)
    scorer = stadimeter.Scorer(disparities, threshold=threshold)
    scorer.add(disp, q16, label)
    counts = scorer.counts()
    failures += [f"{k}: {counts[k]} for {v}" for k, v in n.items() if counts[k] != v]
    for cost, value in (("bad", bad), ("chow", chow)):
        if n["visible"] and abs(scorer.cost(cost) - value) > 2**-20:
            failures.append(f"cost {cost}: {scorer.cost(cost)} for {value}")
    for cost in ("bad", "chow", "d1"):
        if n["visible"] and costs.cost_q20(counts, cost) != scorer.cost(cost) * 2**20:
            failures.append(f"the study's cost {cost}: {costs.cost_q20(counts, cost)} for {scorer.cost(cost) * 2**20}")
    if abs(scorer.rmse() - rmse) > 0.002:
        failures.append(f"rmse: {scorer.rmse()} for {rmse}")
    if failures:
        print(f"FAIL {name}: " + "; ".join(failures))
    return not failures


def random_scene(seed):
    """Planes at several depths in 1/8 px, holes in the truth, a disparity map with errors and gaps."""
    rng = np.random.default_rng(seed)
    h, w, disparities = int(rng.integers(1, 12)), int(rng.integers(20, 120)), 16
    truth = np.repeat(rng.integers(0, 16 * 8, (h, w // 7 + 1)) / 8.0, 7, axis=1)[:, :w]
    known = rng.random((h, w)) < 0.9
    disp = np.rint(truth * 16 + rng.normal(0, 20, (h, w)) * (rng.random((h, w)) < 0.5)).astype(np.int16)
    disp[(rng.random((h, w)) < 0.1) | (disp < 0)] = -16
    return disp, truth, known, disparities, float(rng.choice([0.5, 1, 2, 3]))


def main():
    good, runs = 0, 300
    for seed in range(runs):
        good += compare(f"seed {seed}", *random_scene(seed))
    if os.path.exists(os.path.join(os.environ.get("STAD_DATA", ""), "MANIFEST.json")):
        from scenes import Scene, sample
        s = Scene("middlebury2003/cones")
        known = s.truth != NONE
        runs += 1
        good += compare("cones", s.disparity(sample()), s.truth / 65536.0, known, s.disparities, 1.0)
    else:
        print("SKIPPED the real scene: STAD_DATA names no folder with MANIFEST.json")
    print(f"{good} of {runs} alike")
    sys.exit(good != runs)


if __name__ == "__main__":
    main()
