#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `stad simulate --jobs N`: the same bytes as one frame at a time, where the set changes on the way, where the monitor alarms, where
# frames are bad, where the recording is shorter than the jobs; and no thread treads on another (helgrind, where valgrind is there).
set -u
stad=${STAD_BUILD:?}/stad
[ -x "$stad" ] || { echo "SKIPPED: $stad is not built"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT; trap 'exit 130' INT; trap 'exit 143' TERM
cd "$work" || exit 1
failures=0
fail() { echo "FAILED: $*"; failures=$((failures + 1)); }
# play NAME ARGUMENT...: the log, the answer without its seconds, what was printed and the exit status.
play() {
    local name=$1
    shift
    "$stad" simulate "$@" --csv "$name.csv" --json "$name.all" >"$name.out" 2>"$name.err"
    echo $? >"$name.status"
    grep -v '"seconds"' "$name.all" >"$name.json"
    sed -i '1s/, [0-9.]* a second//' "$name.out"
}
compare() { # WHAT JOBS ARGUMENT...
    local what=$1 jobs=$2 kind
    shift 2
    play one "$@"
    play many "$@" --jobs "$jobs"
    for kind in csv json out err status; do
        cmp -s one.$kind many.$kind || fail "$what: with $jobs jobs another .$kind: $(diff one.$kind many.$kind | head -n 4)"
    done
}

"$stad" scene -o rec --target --frames 14 --width 320 --height 240 --noise 30 --seed 3 >/dev/null
loop=(rec --num-disparities 64 --learn-frames 3 --focal 192 --calibrate-at 1 --evaluations 20 --budget 40 --probation-frames 0)
for jobs in 2 3 50; do
    compare "a set adopted on the way" $jobs "${loop[@]}"
done
grep -q '"adopted"' one.json || fail "nothing was adopted: this compares too little"
compare "an alarm" 4 rec --num-disparities 64 --learn-frames 3 --noise 25 --from 9 --frames 12
grep -q 'asks for a recalibration' one.out || fail "no alarm: this compares too little"
head -c 3000 rec/006_right.png >cut.png && mv cut.png rec/006_right.png
compare "a bad frame" 4 "${loop[@]}"
[ "$(cat one.status)" = 3 ] && [ "$(wc -l <one.csv)" = 7 ] || fail "a bad frame does not stop it where it is"
compare "a bad frame left out" 4 "${loop[@]}" --keep-going
"$stad" simulate rec --jobs 0 2>many.err && fail "no jobs at all"
grep -q -- '--jobs 0: must be a whole number in 1..256' many.err || fail "no word about --jobs 0: $(cat many.err)"
if command -v valgrind >/dev/null; then
    # the tier of kernels is found once, by whoever comes first: every thread writes the same number
    printf '{\n tier\n Helgrind:Race\n fun:stad_x86_tier\n}\n' >tier.supp
    STAD_ISA=c valgrind -q --tool=helgrind --suppressions=tier.supp --error-exitcode=9 \
        "$stad" simulate rec --num-disparities 16 --frames 5 --jobs 3 >out 2>err || fail "helgrind: $(head -n 40 err)"
else
    echo "helgrind left out: valgrind is missing"
fi
[ $failures = 0 ] && echo "all as expected"
