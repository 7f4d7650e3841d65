#!/bin/sh
# SPDX-License-Identifier: MIT
# Real scenes against OpenCV, every mode and memory plan. SCENES=all takes every scene of the data folder, two blocks and
# colour too; otherwise two small ones.
set -eu
data=${STAD_DATA:-$STAD_SOURCE/../shared/data}
verify=$STAD_BUILD/stad-verify
[ -d "$data" ] || { echo "SKIPPED: no real scenes at $data (set STAD_DATA)"; exit 77; }
[ -x "$verify" ] || { echo "SKIPPED: no OpenCV, stad-verify is not built"; exit 77; }

check() { # folder option...
    folder=$1
    shift
    echo "$folder $*"
    "$verify" "$folder/left.png" "$folder/right.png" --mode all "$@"
}

if [ "${SCENES:-two}" != all ]; then
    check "$data/middlebury2003/cones" --num-disparities 64
    check "$data/middlebury2001/venus" --num-disparities 32 --block-size 5 --color --speckle-window-size 100 --speckle-range 2
    exit 0
fi
for left in "$data"/*/*/left.png; do
    folder=$(dirname "$left")
    check "$folder" --num-disparities 64
    check "$folder" --num-disparities 64 --block-size 9 --color --speckle-window-size 100 --speckle-range 2
    check "$folder" --num-disparities 128 --min-disparity -16 --p1 2 --p2 5 --pre-filter-cap 15 --uniqueness-ratio 0
done
