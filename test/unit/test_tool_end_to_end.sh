#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What the commands of `stad` say must hang together: file formats, memory plans, tune and match, scene and eval.
set -u
stad=${STAD_BUILD:?}/stad
[ -x "$stad" ] || { echo "SKIPPED: $stad is not built"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT; trap 'exit 130' INT; trap 'exit 143' TERM
cd "$work" || exit 1
failures=0

fail() { echo "FAILED: $*"; failures=$((failures + 1)); }
run() { "$stad" "$@" || fail "stad $* ($?)"; }
same() { cmp -s "$1" "$2" || fail "$1 and $2 differ ($3)"; }
# number NAME FILE: the first number of that name in a JSON file
number() { tr -d ' \t\n' <"$2" | grep -o "\"$1\":[-0-9.e]*" | head -n 1 | cut -d: -f2; }
best_of() { tr -d ' \t\n' <"$1" | sed 's/.*"best":{//'; }
below() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a != "" && a <= b) }'; }

range=(--min-disparity 0 --num-disparities 32)
run scene -o a --width 200 --height 120 --num-disparities 32 --seed 7
run scene -o b --width 200 --height 120 --num-disparities 32 --seed 7
run scene -o c --width 200 --height 120 --num-disparities 32 --seed 8
for file in left.png right.png disp.pfm nonocc.png; do same a/$file b/$file "the same seed"; done
cmp -s a/left.png c/left.png && fail "another seed draws the same picture"

# The truth against itself: nothing wrong but its rounding to 1/16 px.
run eval a/disp.pfm a/disp.pfm "${range[@]}" --mask a/nonocc.png --json >self.json
below "$(number rmse self.json)" 0.02 || fail "rmse of the truth itself: $(number rmse self.json)"
[ "$(number chow self.json)" = 0 ] && [ "$(number density self.json)" = 1 ] || fail "the truth itself: $(cat self.json)"

# A match of it is good, the same in every format and memory plan, and seen so by eval.
for out in d.npy d.pfm d.png; do run match a/left.png a/right.png -o $out "${range[@]}"; done
for out in d.npy d.pfm d.png; do run eval $out a/disp.pfm "${range[@]}" --json >$out.json; done
same d.npy.json d.pfm.json "measures of .npy and .pfm"
same d.npy.json d.png.json "measures of .npy and .png"
below "$(number 1 d.npy.json)" 0.15 || fail "bad of a drawn scene: $(number 1 d.npy.json)"
for mode in sgbm hh 3way hh4; do
    run match a/left.png a/right.png -o fast.npy "${range[@]}" --mode $mode
    run match a/left.png a/right.png -o small.npy "${range[@]}" --mode $mode --memory small
    run match a/left.png a/right.png -o extras.npy "${range[@]}" --mode $mode --confidence sure.png --right right.npy --preview look.png
    same fast.npy small.npy "$mode, memory plans"
    same fast.npy extras.npy "$mode, with extras"
done
run match a/left.png a/right.png -o color.npy "${range[@]}" --color
same color.npy d.npy "three equal channels: every cost is three times as large, p1 and p2 too"

# What tune says of its best point is what match and eval find with it; twice the same search.
run tune a/left.png a/right.png --truth a/disp.pfm "${range[@]}" --start default --max-evals 25 --json t.json --header p.h >t.txt
run tune a/left.png a/right.png --truth a/disp.pfm "${range[@]}" --start default --max-evals 25 --json u.json >/dev/null
[ "$(grep -v seconds t.json)" = "$(grep -v seconds u.json)" ] || fail "two searches of the same pair differ"
run match a/left.png a/right.png -o best.npy --params t.json
run eval best.npy a/disp.pfm "${range[@]}" --json >best.json
best_of t.json >best.part
found=$(number 1 best.json) told=$(number bad best.part)
[ -n "$told" ] && [ "$found" = "$told" ] || fail "tune says bad $told, eval finds $found"
# The search counts wrong pixels by bounds, the measures by the score: the same but for the cost's rounding to 1 / 2^20.
for how in "--threshold 0" "--threshold 0.53" "--threshold 4095" "--min-disparity -9" "--min-disparity 7 --threshold 3" "--mask a/nonocc.png"; do
    # shellcheck disable=SC2086
    run tune a/left.png a/right.png --truth a/disp.pfm "${range[@]}" $how --max-evals 4 --json how.json >/dev/null
    best_of how.json >how.part
    awk -v a="$(number cost how.part)" -v b="$(number bad how.part)" 'BEGIN { exit !(a != "" && b != "" && (a - b) ^ 2 < 1e-12) }' ||
        fail "$how: the search says $(number cost how.part), the score $(number bad how.part)"
done
below "$told" "$(number bad t.json)" || fail "the best is worse than the start"
[ "$(number evaluations t.json)" = 25 ] || fail "evaluations: $(number evaluations t.json)"
if command -v cc >/dev/null; then
    echo '#include "p.h"
int main(void) { return stad_tuned_params.num_disparities == 32 && STAD_TUNED_MODE == 0 ? 0 : 1; }' >p.c
    cc -std=c99 -Wall -Werror -I"${STAD_SOURCE:?}/lib/include" p.c -o p && ./p || fail "the header of parameters"
fi

# A list of scenes: its own ranges, paths from its own folder.
mkdir lists
echo '[{"left": "../a/left.png", "right": "../a/right.png", "truth": "../a/disp.pfm", "mask": "../a/nonocc.png", "num_disparities": 32},
 {"left": "../c/left.png", "right": "../c/right.png", "truth": "../c/disp.pfm", "num_disparities": 48}]' >lists/two.json
run tune --scenes lists/two.json --max-evals 5 --cost chow --free p1,p2 --json two.out.json >/dev/null
[ "$(number scenes two.out.json)" = 2 ] || fail "a list of two scenes"

run plan --width 320 --height 240 --num-disparities 64 --json >plan.json
[ "$(grep -c '"total"' plan.json)" = 8 ] || fail "plan: four modes of two plans"
run bench --width 96 --height 64 --num-disparities 16 --frames 1 >bench.txt
[ "$(grep -c 'ns per pixel and disparity' bench.txt)" = 4 ] || fail "bench: four modes"
grep -q "^kernels: [a-z]" bench.txt || fail "bench: names its kernels"
run bench --width 96 --height 64 --num-disparities 24 --frames 1 >bench.txt
[ "$(grep -c 'ns per pixel and disparity' bench.txt)" = 3 ] || fail "bench: 3way is left out where it cannot"
for command in match eval tune plan scene bench; do
    "$stad" $command --help | grep -q 'Example: stad' || fail "stad $command --help has no example"
done
[ $failures = 0 ] && echo "all as expected"
