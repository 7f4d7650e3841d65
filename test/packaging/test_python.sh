#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The Python package, installed by pip with its extra `study`: beside cv2 in one process, marks and simulation against the tool,
# a study on a cluster that loses a worker; and mypy --strict finds nothing in its types.
. "$(dirname "$0")/common.sh"
[ -x "${STAD_BUILD:?}/stad" ] || skip "$STAD_BUILD/stad is not built"
venv_with python numpy opencv-python-headless dask distributed pillow mypy 'scikit-build-core>=0.8'
copy_source "$work/source"
quietly "$venv/bin/pip" -q install --no-build-isolation --force-reinstall --no-deps "$work/source/tools/python"
cd "$work"
failures=0
for test in test_opencv test_board test_study; do
    if "$venv/bin/python" -W error::DeprecationWarning "$work/source/test/python/$test.py" >"$work/$test.log" 2>&1; then
        echo "$test: $(grep -h '^Ran' "$work/$test.log" | tr '\n' ' ')"
    else
        cat "$work/$test.log"
        failures=$((failures + 1))
    fi
done
cp -r "$source_dir/tools/python/src/stadimeter" "$work/stadimeter"
"$venv/bin/mypy" --strict -p stadimeter >"$work/log" 2>&1 || { cat "$work/log"; failures=$((failures + 1)); }
cat >use.py <<'END'
import numpy as np
import stadimeter
left = np.zeros((8, 64), np.uint8)
wrong: str = stadimeter.StereoSGBM_create(0, 16, 3).compute(left, left)
END
{ "$venv/bin/mypy" --strict use.py 2>&1 || true; } | grep -q 'Incompatible types in assignment' || { echo "FAILED: a user's mistake in types is not seen"; failures=$((failures + 1)); }
[ $failures = 0 ]
