#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The page on self-calibration with something to see: a drawn recording of the target ends with an adopted set.
set -eu
example=${STAD_BUILD:?}/examples/example_05_self_calibration
if [ ! -x "$STAD_BUILD/stad" ] || [ ! -x "$example" ]; then
    echo "SKIPPED: stad or the example is not built"
    exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT; trap 'exit 130' INT; trap 'exit 143' TERM
"$STAD_BUILD/stad" scene -o "$work/recording" --target --pgm --frames 10 --width 320 --height 240 --noise 30 --seed 3
"$example" 10 192 "$work/recording" >"$work/said"
cat "$work/said"
grep -q "outcome: adopted, fault: none" "$work/said" || { echo "FAILED: outcome and fault are not said as words"; exit 1; }

# What is no frame of its size, or not there, is named and not matched.
"$STAD_BUILD/stad" scene -o "$work/large" --target --pgm --frames 2 --width 640 --height 480
for recording in large none; do
    status=0
    "$example" 2 192 "$work/$recording" >"$work/said" 2>&1 || status=$?
    [ $status -eq 1 ] && grep -q "$recording/000_left.pgm: " "$work/said" && ! grep -q outcome "$work/said" ||
        { echo "FAILED: $recording: status $status, $(cat "$work/said")"; exit 1; }
done
