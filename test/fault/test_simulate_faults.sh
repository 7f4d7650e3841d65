#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `stad simulate` on recordings of cameras at fault: a knock during a run, a drift, a view that is missing in the middle, a
# recording that ends too soon. Each is told in words, in JSON and CSV, and nothing is adopted on a rig that moved.
set -u
stad=${STAD_BUILD:?}/stad
[ -x "$stad" ] || { echo "SKIPPED: $stad is not built"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT; trap 'exit 130' INT; trap 'exit 143' TERM
cd "$work" || exit 1
failures=0
fail() { echo "FAILED: $*"; failures=$((failures + 1)); }
run() { "$stad" "$@" >out.txt 2>err.txt || fail "stad $*: $(cat err.txt)"; }
told() { grep -q -- "$1" "${2:-out.txt}" || fail "not told: $1: $(head -n 12 "${2:-out.txt}" | cut -c 1-200)"; }
width=320 head=15 # of a picture: its width, and the bytes before its pixels

# lower ROWS FILE: the picture that many rows lower, what falls out below comes in above
lower() {
    local bytes=$(($1 * width))
    { head -c $head "$2"; tail -c $bytes "$2"; tail -c +$((head + 1)) "$2" | head -c -$bytes; } >"$2.new" && mv "$2.new" "$2"
}

run scene -o clean --target --frames 70 --width $width --height 240 --pgm
board=(--num-disparities 64 --focal 192 --calibrate-at 1 --probation-frames 8 --noise 10)
run simulate clean "${board[@]}" --json clean.json
told '"outcome":.*"adopted"' clean.json

### the target lies below a search that begins above 0: no view was exchanged ###
run simulate clean --focal 192 --min-disparity 48 --num-disparities 32 --calibrate-at 1
told 'last fault: range'

### knocked after the first look ###
for rows in 1 12; do
    cp -r clean knocked
    for picture in knocked/*_right.pgm; do
        case $picture in */000_* | */001_*) ;; *) lower $rows "$picture" ;; esac
    done
    run simulate knocked "${board[@]}" --json knocked.json --csv knocked.csv --report knocked.html
    told 'run ended: rig failed, rig good -> good, last fault: rig'
    told '"outcome":.*"rig failed"' knocked.json
    told '"stored":.*null' knocked.json
    told ',rig,none$' knocked.csv
    told '"judge_after":.*null' knocked.json
    told '<td>&ndash; &rarr; &ndash; %</td>' knocked.html
    rm -r knocked
done

### drifted from the first frame on: corrected, and said so ###
cp -r clean drifted
for picture in drifted/*_right.pgm; do lower 2 "$picture"; done
run simulate drifted "${board[@]}" --json drifted.json --report drifted.html
told 'rig correct -> good'
told '^in use: .*right view corrected by [12].[0-9]* px'
told '^stored: .*right view corrected by [12].[0-9]* px'
told '"verdict_before":.*"correct"' drifted.json
told '"dy_px":' drifted.json
told 'Correction of the right view, stored: [12].[0-9]* px' drifted.html

### over before the probation is ###
run simulate clean "${board[@]}" --frames 30 --probation-frames 64
told 'its probation was not over at the last frame'

### a view is missing ###
cp -r clean gap
rm gap/003_right.pgm gap/005_left.pgm
"$stad" simulate gap --num-disparities 64 --frames 8 >out.txt 2>err.txt && fail "a missing view was not noticed"
told '003_right.pgm' err.txt
run simulate gap --num-disparities 64 --frames 8 --keep-going
told '6 frames of 320 x 240, 2 skipped'

[ $failures = 0 ] && echo "all as expected"
exit $((failures > 0))
