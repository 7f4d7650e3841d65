#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The tuner from Python: ladders by cost and channels, what it refuses, a search cut in two."""
import os
import subprocess
import sys

try:
    import numpy
except ImportError:
    print("SKIPPED: numpy is missing")
    sys.exit(77)

ROOT = os.environ.get("STAD_SOURCE") or os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path.insert(0, os.path.join(ROOT, "tools", "study"))
from package import stadimeter  # noqa: E402

START = dict(p1=72, p2=288, block_size=3, uniqueness_ratio=10, pre_filter_cap=63, disp12_max_diff=1)


def cost_of(point):
    return abs(point["p1"] - 40) / 4096 + abs(point["p2"] - 300) / 8192 + point["block_size"] / 64 + 1 / 128


def points(tuner, count):
    out = []
    while len(out) < count and (point := tuner.ask()) is not None:
        assert tuner.ask() == point, "asking twice gives the same point"
        out.append(point)
        tuner.tell(cost_of(point))
    return out


def test_tune_python_three_channels_scale_the_ladder():
    grey, colour = (points(stadimeter.Tuner(START, purpose="chow", channels=c), 5) for c in (1, 3))
    assert grey[0] == colour[0] == START
    for one, three in zip(grey[1:], colour[1:]):
        assert three == dict(one, p1=3 * one["p1"], p2=3 * one["p2"]), (one, three)


def test_tune_python_d1_takes_the_ladder_of_bad():
    assert points(stadimeter.Tuner(START, purpose="d1"), 4) == points(stadimeter.Tuner(START, purpose="bad"), 4)
    assert points(stadimeter.Tuner(START, purpose="any"), 2) != points(stadimeter.Tuner(START, purpose="bad"), 2)


def test_tune_python_state_resumes():
    whole = points(stadimeter.Tuner(START, budget=120, seed=7), 120)
    tuner = stadimeter.Tuner(START, budget=120, seed=7)
    first = points(tuner, 90)
    assert first + points(stadimeter.Tuner.restore(bytes(tuner)), 120) == whole and len(whole) == 120


def test_tune_python_refuses_by_name():
    tuner = stadimeter.Tuner(START)
    for word, call in (("channels", lambda: stadimeter.Tuner(START, channels=2)), ("budget", lambda: stadimeter.Tuner(START, budget=241)),
                       ("purpose", lambda: stadimeter.Tuner(START, purpose="rmse")), ("missing p2", lambda: stadimeter.Tuner({k: v for k, v in START.items() if k != "p2"})),
                       ("unknown blok", lambda: stadimeter.Tuner(dict(START, blok=3))), ("start: p2 = 2.5", lambda: stadimeter.Tuner(dict(START, p2=2.5))),
                       ("limits: p2 = (1, 40000)", lambda: stadimeter.Tuner(START, limits={"p2": (1, 40000)})),
                       ("limits: block_size = (0, 5)", lambda: stadimeter.Tuner(START, limits={"block_size": (0, 5)})),
                       ("'speed'", lambda: stadimeter.Tuner(START, cheap=["speed"])), ("seed", lambda: stadimeter.Tuner(START, seed=-1)), ("cost", lambda: tuner.tell(-1)),
                       ("p1", lambda: stadimeter.Tuner(START, limits={"p1": (9, 8)})),
                       ("state", lambda: stadimeter.Tuner.restore(bytes(4016))), ("state", lambda: stadimeter.Tuner.restore(b"\xff" * 4016))):
        try:
            call()
        except ValueError as error:
            assert word in str(error), (word, error)
        else:
            raise AssertionError(f"{word}: not refused")
    assert tuner.ask() == START, "a refused cost leaves the point pending"
    tuner.tell(stadimeter.FAILED)
    assert tuner.trace()[0][1] == stadimeter.FAILED


def test_tune_python_wrong_types_are_named():
    tuner = stadimeter.Tuner(START)
    for word, call in (("cost = None", lambda: tuner.tell(None)), ("cost = '1'", lambda: tuner.tell("1")), ("cost_q20 = 1.5", lambda: tuner.tell_q20(1.5)),
                       ("start = [72, 288]", lambda: stadimeter.Tuner([72, 288])), ("free = 'p1'", lambda: stadimeter.Tuner(START, free="p1")),
                       ("free = 3", lambda: stadimeter.Tuner(START, free=3)), ("cheap = 'p1'", lambda: stadimeter.Tuner(START, cheap="p1")),
                       ("budget = '3'", lambda: stadimeter.Tuner(START, budget="3")), ("seed = 1.5", lambda: stadimeter.Tuner(START, seed=1.5)),
                       ("patience = 'no'", lambda: stadimeter.Tuner(START, patience="no"))):
        try:
            call()
        except TypeError as error:
            assert word in str(error), (word, error)
        else:
            raise AssertionError(f"{word}: not refused")
    assert tuner.ask() == START


def test_tune_python_not_a_number_counts_as_failed():
    tuner = stadimeter.Tuner(START)
    tuner.tell(float("nan"))
    assert tuner.trace() == [(START, stadimeter.FAILED)] and tuner.ask() != START
    tuner.tell(numpy.float32("nan"))
    tuner.tell(numpy.float32(0.25))
    tuner.tell_q20(numpy.int32(7))
    assert [cost for _, cost in tuner.trace()] == [stadimeter.FAILED, stadimeter.FAILED, 0.25, 7 / 2**20]


def test_study_without_its_data_says_so_in_one_line():
    env = {name: value for name, value in os.environ.items() if name != "STAD_DATA"}
    for script, words in (("ladder.py", ()), ("ablation.py", ()), ("general.py", ()), ("table1.py", ()), ("ga24x150.py", ()), ("sharing.py", ("--matches",)),
                          ("presets/run.py", ()), ("presets/handicap.py", ()), ("calib_trials/run.py", ())):
        done = subprocess.run([sys.executable, os.path.join(ROOT, "tools", "study", script), *words], env=env, capture_output=True, text=True)
        if "ModuleNotFoundError" in done.stderr:  # what only studies need
            print(f"SKIPPED: {script}: {done.stderr.splitlines()[-1]}")
            continue
        assert done.returncode == 1 and done.stderr.count("\n") == 1 and "STAD_DATA names the folder of scenes" in done.stderr, (script, done.stderr)


for name, test in list(globals().items()):
    if name.startswith("test_"):
        test()
        print(f"{name}: PASS")
