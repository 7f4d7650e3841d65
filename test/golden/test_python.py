#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The Python package against cv2 in one process: same signature, same arrays, and what it refuses. Needs numpy and cv2."""
import inspect
import os
import random
import subprocess
import sys

SOURCE, BUILD = os.environ["STAD_SOURCE"], os.environ["STAD_BUILD"]
try:
    import numpy as np
    import cv2
except ImportError as error:
    print(f"SKIPPED: {error}: the Python package is not compared with cv2 (pip install opencv-python-headless)")
    sys.exit(77)

FOLDER = os.path.join(BUILD, "python")
QUIET = {"check": True, "stdout": subprocess.DEVNULL}
subprocess.run(["cmake", "-S", os.path.join(SOURCE, "tools/python"), "-B", FOLDER], **QUIET)
subprocess.run(["cmake", "--build", FOLDER], **QUIET)
os.environ["STADIMETER_LIBRARY"] = os.path.join(FOLDER, "libstadimeter_native.so")
sys.path.insert(0, os.path.join(SOURCE, "tools/python/src"))
import stadimeter  # noqa: E402

cv2.setNumThreads(1)
SEED = int(os.environ.get("STAD_SEED", "1"))
GETTERS = ("MinDisparity", "NumDisparities", "BlockSize", "P1", "P2", "Disp12MaxDiff", "PreFilterCap", "UniquenessRatio",
           "SpeckleWindowSize", "SpeckleRange", "Mode")


def pair(width, height, channels, shift, seed):
    noise = np.random.default_rng(seed)
    base = cv2.GaussianBlur(noise.integers(0, 256, (height, width + 64, channels), np.uint8), (5, 5), 1.2)
    base = base.reshape(height, width + 64, channels)
    left, right = base[:, :width], base[:, shift:width + shift]
    right = np.clip(right.astype(int) + noise.integers(-6, 7, right.shape), 0, 255).astype(np.uint8)
    return [np.ascontiguousarray(v[:, :, 0] if channels == 1 else v) for v in (left, right)]


def refused(words, call, *args, kind=ValueError, **named):
    try:
        call(*args, **named)
    except kind as error:
        assert words in str(error), f"{call}: said {error!r}, not {words!r}"
        return
    raise AssertionError(f"{call}{args}{named}: not refused")


def test_signature_is_opencvs():
    ours = list(inspect.signature(stadimeter.StereoSGBM_create).parameters)
    told = cv2.StereoSGBM_create.__doc__.split(")")[0].replace("StereoSGBM_create(", "")
    theirs = [name.strip(" [],") for name in told.replace("]", "").split("[") if name.strip(" [],")]
    assert ours[:len(theirs)] == theirs, (ours, theirs)
    values = [3, 32, 7, 11, 99, 2, 31, 5, 50, 2, 3]
    a, b = stadimeter.StereoSGBM_create(*values), cv2.StereoSGBM_create(*values)
    c, d = stadimeter.StereoSGBM_create(), cv2.StereoSGBM_create()
    for name in GETTERS:
        assert getattr(a, "get" + name)() == getattr(b, "get" + name)(), name
        assert getattr(c, "get" + name)() == getattr(d, "get" + name)(), name + " by default"
        getattr(c, "set" + name)(getattr(b, "get" + name)())
        assert getattr(c, "get" + name)() == getattr(b, "get" + name)(), "set" + name
    for name in dir(cv2):
        if "STEREO_SGBM_MODE" in name or name.startswith("StereoSGBM_MODE"):
            assert getattr(stadimeter, name) == getattr(cv2, name), name


def test_random_parameters_give_cv2s_arrays():
    draw = random.Random(SEED)
    kept = stadimeter.StereoSGBM_create()
    for case in range(80):
        channels = draw.choice((1, 1, 3))
        count = draw.choice((16, 32, 48))
        args = dict(minDisparity=draw.choice((0, 0, -8, 5)), numDisparities=count, blockSize=draw.choice((0, 1, 3, 4, 5, 9)),
                    P1=draw.choice((0, 8, 200, 1500)), P2=draw.choice((0, 30, 240, 6000)), disp12MaxDiff=draw.choice((-1, 0, 1, 3)),
                    preFilterCap=draw.choice((0, 31, 63)), uniquenessRatio=draw.choice((0, 5, 15)),
                    speckleWindowSize=draw.choice((0, 40)), speckleRange=draw.choice((0, 1, 2)), mode=draw.choice((0, 1, 2, 3)))
        if args["mode"] == 2 and args["blockSize"] == 0:
            args["blockSize"] = 3
        left, right = pair(draw.randint(90, 200), draw.randint(20, 70), channels, draw.randint(0, 20), case)
        expected = cv2.StereoSGBM_create(**args).compute(left, right)
        for name in GETTERS:
            getattr(kept, "set" + name)(args[name[0].lower() + name[1:] if name not in ("P1", "P2") else name])
        for matcher in (kept, stadimeter.StereoSGBM_create(memory="small", **args)):
            got = matcher.compute(left, right)
            assert got.dtype == np.int16 and got.shape == expected.shape
            assert np.array_equal(got, expected), f"case {case} of STAD_SEED={SEED}: {args}, {left.shape}: " \
                f"{int((got != expected).sum())} pixels differ"


def test_views_need_no_copy_and_give_the_same():
    left, right = pair(160, 60, 3, 9, 5)
    m = stadimeter.StereoSGBM_create(0, 32, 5)
    views = {"a channel": (left[:, :, 1], right[:, :, 1]), "a crop": (left[7:50, 11:140], right[7:50, 11:140]),
             "upside down": (left[::-1], right[::-1]), "mirrored": (left[:, ::-1], right[:, ::-1]), "every second row": (left[::2], right[::2])}
    for name, (a, b) in views.items():
        expected = cv2.StereoSGBM_create(0, 32, 5).compute(np.ascontiguousarray(a), np.ascontiguousarray(b))
        assert np.array_equal(m.compute(a, b), expected), name


def test_given_output_is_used_and_workspace_kept():
    left, right = pair(150, 50, 1, 7, 6)
    m = stadimeter.StereoSGBM_create(numDisparities=32)
    whole = np.full((50, 200), -7, np.int16)
    out = m.compute(left, right, whole[:, 20:170])
    assert out.base is whole and np.array_equal(out, m.compute(left, right))
    assert (whole[:, :20] == -7).all() and (whole[:, 170:] == -7).all()
    before = m._work.ctypes.data
    m.compute(left, right)
    assert m._work.ctypes.data == before
    assert m.counts()["considered"] == 50 * (150 - 32)


def test_frames_in_parallel_come_in_order():
    pairs = [pair(120, 40, 1, 3 + i, i) for i in range(7)]
    one = cv2.StereoSGBM_create(0, 32, 5)
    for got, (left, right) in zip(stadimeter.compute_frames(iter(pairs), jobs=3, numDisparities=32, blockSize=5), pairs):
        assert np.array_equal(got, one.compute(left, right))


def test_bad_input_is_refused_by_name():
    make = stadimeter.StereoSGBM_create
    left, right = pair(100, 40, 1, 5, 1)
    refused("numDisparities = 17", make(0, 17).compute, left, right)
    refused("numDisparities = 112", make(0, 112).compute, left, right)
    refused("blockSize = 0 in mode SGBM_3WAY", make(blockSize=0, mode=2).compute, left, right)
    refused("P1 = 40000", make, P1=40000)
    refused("mode = 4", make, mode=4)
    refused("blockSize must be an integer", make, blockSize=3.5, kind=TypeError)
    refused("uniquenessRatio = 100", make(uniquenessRatio=100).compute, left, right)
    refused("speckleRange = -1", make(speckleWindowSize=9, speckleRange=-1).compute, left, right)
    refused("right: its shape", make().compute, left, right[:-1])
    refused("left: pixels must be uint8", make().compute, left.astype(float), right)
    refused("right: must be H x W", make().compute, left, np.zeros((40, 100, 4), np.uint8))
    refused("disparity: must be an int16", make().compute, left, right, np.zeros((40, 100), np.float32))
    refused("memory = 'tiny'", make, memory="tiny")
    refused("counts", make().counts)


def test_score_and_tuner_work_together():
    left, right = pair(200, 80, 1, 12, 3)
    truth = np.full((80, 200), 12.0, np.float32)

    def cost(point):
        found = stadimeter.StereoSGBM_create(0, 32, **stadimeter.as_opencv(point)).compute(left, right)
        scorer = stadimeter.Scorer(32)
        scorer.add(found, truth)
        return scorer.cost()

    start = dict(p1=2, p2=5, block_size=1, uniqueness_ratio=35, pre_filter_cap=15, disp12_max_diff=1)
    t = stadimeter.tune(cost, start, budget=25)
    point, best = t.best()
    trace = t.trace()
    assert trace[0][0] == start and best == min(c for _, c in trace) and best < trace[0][1] and best == cost(point)
    found = stadimeter.StereoSGBM_create(0, 32, **stadimeter.as_opencv(start)).compute(left, right)[:, 32:] / 16.0
    assert abs(trace[0][1] - ((found < 0) | (np.abs(found - 12) > 1)).mean()) < 1e-6, "the cost by the library and by numpy"
    half = stadimeter.Tuner(start, budget=25)
    for _, c in trace[:10]:
        half.ask()
        half.tell(c)
    resumed = stadimeter.Tuner.restore(bytes(half))
    for p, c in trace[10:]:
        assert resumed.ask() == p
        resumed.tell(c)
    assert resumed.ask() is None and bytes(resumed) == bytes(t)
    refused("'nothing'", stadimeter.Tuner, start, free=["nothing"])
    refused("start: missing p2", stadimeter.Tuner, {k: v for k, v in start.items() if k != "p2"})
    refused("budget = 999", stadimeter.Tuner, start, budget=999)
    refused("cost", stadimeter.Tuner(start).tell, -1)
    refused("search is over", resumed.tell, 0.5)
    refused("truth", stadimeter.Scorer(32).add, np.zeros((4, 4), np.int16), np.zeros((4, 5), np.float32))


def main():
    failed = 0
    tests = [(name, test) for name, test in globals().items() if name.startswith("test_")]
    for name, test in tests:
        try:
            test()
            print(f"{name}: ok")
        except Exception as error:  # a test that breaks is a test that fails
            failed += 1
            print(f"{name}:FAIL: {type(error).__name__}: {error}")
    print(f"cv2 {cv2.__version__}, numpy {np.__version__}, tier {stadimeter.tier()}: {len(tests) - failed} of {len(tests)} passed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
