#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""tools/study/calib_trials/run.py: a part of its table has the rows of the whole; without data it says so in a line."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(os.environ.get("STAD_SOURCE", pathlib.Path(__file__).resolve().parent.parent.parent))
SCRIPT = ROOT / "tools/study/calib_trials/run.py"
SET = '{"bad": 1, "outcome": 0, "evaluations": 1}'
TRIAL = f"""#!/bin/sh
echo "$1 $5 $6" >>"$TRIALS"
echo '{{"kind": "clean", "in_use": 2, "default": {SET}, "strict": {SET}, "none": {SET}, "pick": {SET}}}'
"""  # a stand-in for the program that notes picture, kind and seed
sys.dont_write_bytecode = True
sys.path.insert(0, str(SCRIPT.parent))
import run as trials  # noqa: E402


def rows(work, *options):
    """What the program was asked for: (picture, kind, seed) a row."""
    noted = work / "trials"
    noted.unlink(missing_ok=True)
    subprocess.run([sys.executable, SCRIPT, "--program", work / "trial", "--kinds", "clean,blur", *options], check=True,
                   stdout=subprocess.DEVNULL, env={**os.environ, "STAD_DATA": str(work), "TRIALS": str(noted)})
    return noted.read_text().splitlines()


def said(data, *options):
    done = subprocess.run([sys.executable, SCRIPT, *options], capture_output=True, text=True, env={**os.environ, "STAD_DATA": data})
    return done.returncode, done.stderr.splitlines()


with tempfile.TemporaryDirectory() as folder:
    work = pathlib.Path(folder)
    (work / "trial").write_text(TRIAL)
    (work / "trial").chmod(0o755)
    (work / "MANIFEST.json").write_text(json.dumps([{"path": s, "numDisparities": 64} for s in trials.SCENES]))
    whole = rows(work)
    assert len(whole) == 2 * len(trials.SCENES), whole
    assert len({row.split()[2] for row in whole}) == len(trials.SCENES), f"scenes share a seed: {whole}"
    for i, scene in enumerate(trials.SCENES):
        part = rows(work, "--scenes", scene)
        assert part == whole[2 * i:2 * i + 2], f"--scenes {scene}: {part}, in the whole {whole[2 * i:2 * i + 2]}"
    for data, options, word in (("", (), "STAD_DATA"), (folder + "/none", (), "STAD_DATA"), (folder, ("--scenes", "atlantis"), "atlantis"),
                                (folder, ("--kinds", "fog"), "fog")):
        status, lines = said(data, *options)
        assert status == 1 and len(lines) == 1 and word in lines[0], (data, options, status, lines)
