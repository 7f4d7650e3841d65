#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""`stad tune`: its best is never worse than the start it was given, a signal loses nothing, its JSON says how to repeat it,
and what it would pass over in silence it refuses."""
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

STAD = Path(os.environ["STAD_BUILD"]) / "stad"
NAMES = ["p1", "p2", "block_size", "uniqueness_ratio", "pre_filter_cap", "disp12_max_diff"]


def stad(*words, status=0):
    done = subprocess.run([str(w) for w in (STAD, *words)], capture_output=True, text=True)
    assert done.returncode == status, f"stad {words}: {done.returncode}, expected {status}: {done.stderr}"
    return done.stdout, done.stderr


def tune(*words, pair="small", status=0):
    return stad("tune", f"{pair}/left.png", f"{pair}/right.png", "--truth", f"{pair}/disp.pfm", "--num-disparities", 64, *words,
                status=status)


# A start that the lattice moves: with p2 free it is kept at sqrt(2) * p1 or more, and caps are odd.
OFF_LATTICE = ("--cost", "chow", "--free", "p2", "--start", "p1=1000,p2=1200", "--json", "t.json", "--report", "t.html")


def test_tune_start_off_the_lattice_stays_unless_beaten():
    table, _ = tune(*OFF_LATTICE)
    found = json.loads(Path("t.json").read_text())
    assert found["best"] == found["start"] and found["best"]["params"]["p2"] == 1200, found["best"]
    assert all(cost >= found["start"]["cost"] for _, cost, _, _ in found["trace"]), "the case shows nothing: something was better"
    assert "nothing better than the start was found" in table and " lower" not in table, table
    assert "nothing better than the start was found" in Path("t.html").read_text()
    table, _ = tune(*OFF_LATTICE[:4], "--start", "p1=100,p2=400", "--max-evals", 1)
    assert table.endswith("s\n") and " 1 evaluation, " in table, table


def test_tune_scenes_and_fiducials_keep_the_start():
    Path("list.json").write_text(json.dumps([SCENE, SCENE]))
    stad("tune", "--scenes", "list.json", *OFF_LATTICE)
    found = json.loads(Path("t.json").read_text())
    assert found["best"] == found["start"] and found["best"]["params"]["p2"] == 1200, found["best"]
    stad("scene", "-o", "sheet", "--target", "--frames", 4, "--width", 320, "--height", 240)
    for p1 in range(20, 2000, 180):  # wherever it leads: never worse
        stad("tune", "sheet/003_left.png", "sheet/003_right.png", "--fiducials", "--focal", 192, "--num-disparities", 64, "--free", "p2",
             "--start", f"p1={p1},p2={p1 + 2}", "--max-evals", 4, "--json", "t.json")
        found = json.loads(Path("t.json").read_text())
        assert found["best"]["cost"] <= found["start"]["cost"], f"p1 {p1}: {found['best']} from {found['start']}"


def test_tune_json_says_how_to_repeat_it():
    tune("--seed", 4294967295, "--free", "p1,p2", "--max-evals", 30, "--json", "t.json")
    found = json.loads(Path("t.json").read_text())
    assert (found["seed"], found["budget"], found["free"], found["cost"]) == (4294967295, 30, ["p1", "p2"], "bad"), found
    assert found["stopped"] is None
    assert [row[0] for row in found["trace"]] == list(range(1, 31)) and all(list(row[3]) == NAMES for row in found["trace"])
    point = min(found["trace"], key=lambda row: row[1])[3]
    assert point == {name: found["best"]["params"][name] for name in NAMES}, "the least of the trace is not the best"
    assert "--seed 4294967296" in tune("--seed", 4294967296, status=2)[1]


def refused(pattern, status, *words):
    """In one line, and nothing is written."""
    _, errors = stad(*words, status=status)
    assert re.search(pattern, errors) and errors.count("\n") == 1, f"stad {words}: {errors!r}, expected {pattern!r}"
    assert not Path("never.json").exists()


SCENE = {"left": "small/left.png", "right": "small/right.png", "truth": "small/disp.pfm", "num_disparities": 64}


def test_tune_list_faults_are_named():
    def list_of(second, says, status=3):
        Path("faulty.json").write_text(second if isinstance(second, str) else json.dumps([SCENE, second]))
        refused(says, status, "tune", "--scenes", "faulty.json", "--json", "never.json", "--max-evals", 1)

    for key, values in (("num_disparities", (32.5, 0, -16, 4096, "64", None)), ("min_disparity", (-0.5, -2048, 2048, True)),
                        ("truth_scale", (0, -4, 1e9, "4"))):
        for value in values:
            list_of({**SCENE, key: value}, f'faulty.json: scene 1: "{key}" must be a')
    list_of({**SCENE, "num_disparites": 64}, 'faulty.json: scene 1: "num_disparites" is no key of a scene')
    list_of({**SCENE, "truth_scale": 4}, 'faulty.json: scene 1: "truth_scale" has no effect: small/disp.pfm holds pixels')
    list_of({**SCENE, "num_disparities": 31}, "scene 1: faulty.json: num_disparities 31: must be a positive multiple of 16", 2)
    list_of({**SCENE, "num_disparities": 112, "min_disparity": 16}, "scene 1: faulty.json: .*leaves no column", 2)
    list_of(7, "faulty.json: scene 1 is no JSON object")
    one = json.dumps(SCENE)[:-1]
    list_of(f'[{one}}}, {one}, "left": "other.png"}}]', 'faulty.json: scene 1: "left" is there twice')
    list_of('[\n{"left": "a.png",\n "right": "b.png",,}]', "faulty.json: no JSON: see line 3$")
    Path("fine.json").write_text(json.dumps([{**SCENE, "min_disparity": 0}, SCENE]))
    stad("tune", "--scenes", "fine.json", "--max-evals", 1)


def test_tune_options_that_conflict_are_refused():
    pair = ("tune", "small/left.png", "small/right.png", "--truth", "small/disp.pfm", "--num-disparities", 64, "--max-evals", 1)
    stad(*pair, "--json", "all.json")
    Path("some.json").write_text('{"p1": 50, "p2": 200, "block_size": 5}')
    for says, words in (("--start default has no effect: all.json and the options hold every", ("--params", "all.json", "--start", "default")),
                        ("--start block_size=7 and --block-size 5: one of them", ("--block-size", 5, "--start", "block_size=7")),
                        ("--start default and --start sample: one of them", ("--start", "default", "--start", "sample")),
                        ("--start default and --start sample: one of them", ("--start", "sample,default")),
                        ("--start p1: it is there twice", ("--start", "p1=5", "--start", "p1=6")),
                        ("--truth-scale has no effect: small/disp.pfm holds pixels", ("--truth-scale", 4)),
                        ("--start p1=99999: outside -32768..32767", ("--start", "p1=99999")),
                        ("--start p1=few: not a whole number", ("--start", "p1=few")),
                        ("--start: block_size 4: must be odd", ("--start", "block_size=4")),
                        ("-: an output is a file's name", ("--json", "-"))):
        refused(says, 2, *pair, *words)
    assert not Path("-").exists()
    stad(*pair, "--params", "some.json", "--start", "default,p1=60", "--json", "t.json")
    start = json.loads(Path("t.json").read_text())["start"]["params"]
    assert (start["p1"], start["block_size"], start["uniqueness_ratio"]) == (60, 5, 0), f"--start over the file over default: {start}"


def test_tune_missing_words_and_truth_are_told():
    refused("tune: LEFT and RIGHT are missing$", 2, "tune")
    refused("tune: RIGHT is missing", 2, "tune", "small/left.png", "--truth", "small/disp.pfm")
    refused("small/left.png: all of its truth lies outside the disparities searched, -64 .. -1", 2, "tune", "small/left.png", "small/right.png",
            "--truth", "small/disp.pfm", "--num-disparities", 64, "--min-disparity", -64)


def catches(child, number):
    """Waits until the process catches the signal: its search has begun then."""
    for _ in range(6000):
        status = Path(f"/proc/{child.pid}/status").read_text()
        if int(status.split("SigCgt:")[1].split()[0], 16) >> (number - 1) & 1:
            return
        assert child.poll() is None, "ended before the search began"
        time.sleep(0.005)
    raise AssertionError(f"signal {number} is never caught")


def test_tune_signal_writes_what_was_found():
    stad("scene", "-o", "big", "--width", 960, "--height", 720, "--num-disparities", 128)
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        words = (STAD, "tune", "big/left.png", "big/right.png", "--truth", "big/disp.pfm", "--num-disparities", "128", "--mode", "hh", "--max-evals",
                 "240", "--json", "cut.json", "--header", "cut.h", "--report", "cut.html")
        child = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, preexec_fn=lambda: signal.signal(number, signal.SIG_DFL))
        catches(child, number)
        time.sleep(0.3)
        child.send_signal(number)
        table, errors = child.communicate(timeout=120)
        assert child.returncode == 128 + number, (number, child.returncode, errors)
        found = json.loads(Path("cut.json").read_text())
        n = found["evaluations"]
        assert n < 240 and len(found["trace"]) == n and found["stopped"] == f"interrupted after {n} of 240 evaluations", found["stopped"]
        assert found["stopped"] in table and table.splitlines()[2].startswith("best") and found["stopped"] in errors, (table, errors)
        assert found["stopped"] in Path("cut.h").read_text() and found["stopped"] in Path("cut.html").read_text()
        for name in ("cut.json", "cut.h", "cut.html"):
            Path(name).unlink()


def main():
    if not STAD.exists():
        print(f"SKIPPED: {STAD} is not built")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        stad("scene", "-o", "small", "--width", 120, "--height", 80)
        for name, test in list(globals().items()):
            if name.startswith("test_"):
                test()
                print(f"{name}: PASS")
        os.chdir("/")
    return 0


if __name__ == "__main__":
    sys.exit(main())
