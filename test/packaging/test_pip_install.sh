#!/bin/bash
# SPDX-License-Identifier: MIT
# pip install ./tools/python in a fresh virtual environment, from a clean copy of the sources: imports, matches, is typed.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT; trap 'exit 130' INT; trap 'exit 143' TERM
python3 -m venv "$work/venv" 2>/dev/null || { echo "SKIPPED: python3 has no venv (Debian: python3-venv)"; exit 77; }
mkdir "$work/source"
(cd "$STAD_SOURCE" && git ls-files -z | xargs -0 tar -c --ignore-failed-read 2>/dev/null) | tar -x -C "$work/source"
"$work/venv/bin/pip" -q download --no-deps -d "$work/probe" "scikit-build-core>=0.8" >/dev/null 2>&1 ||
    { echo "SKIPPED: pip cannot fetch scikit-build-core here"; exit 77; }
"$work/venv/bin/pip" -q install "$work/source/tools/python"
cd "$work"
venv/bin/python - <<'END'
import os
import numpy as np
import stadimeter
frame = np.tile(np.arange(96, dtype=np.uint8) ** 2, (32, 1))
disparity = stadimeter.StereoSGBM_create(0, 16, 3).compute(frame, frame)
assert disparity.shape == (32, 96) and (disparity[:, 17:] == 0).mean() > 0.9, disparity
assert os.path.exists(os.path.join(os.path.dirname(stadimeter.__file__), "py.typed"))
print("stadimeter", stadimeter.__version__, "tier", stadimeter.tier())
END
