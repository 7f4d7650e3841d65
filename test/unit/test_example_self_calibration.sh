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
"$example" 10 192 "$work/recording"
