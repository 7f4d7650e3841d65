#!/bin/sh
# SPDX-License-Identifier: MIT
# Frama-C's value analysis of each prove_*.c with the library files it names: no alarm may remain (out of bounds, overflow,
# narrowing that loses bits, uninitialised reads) for any input of the stated ranges. One alarm fails the test.
set -eu
command -v frama-c >/dev/null || { echo "SKIPPED: frama-c is not installed"; exit 77; }
status=0
for proof in "$STAD_SOURCE"/test/proof/prove_*.c; do
    sources=$(sed -n 's/.*SOURCES: \(.*\) \*\//\1/p' "$proof" | tr ' ' '\n' | sed "s,^,$STAD_SOURCE/lib/src/,")
    # shellcheck disable=SC2086
    log=$(frama-c -eva -eva-precision 3 -warn-signed-downcast \
        -cpp-extra-args="-I$STAD_SOURCE/lib/include -I$STAD_SOURCE/lib/src -I$STAD_SOURCE/port/isa/c -I$STAD_SOURCE/test" \
        "$proof" $sources 2>&1) || { echo "$log" | tail -n 20; exit 1; }
    if echo "$log" | grep -q ' 0 alarms generated'; then
        echo "$(basename "$proof" .c): 0 alarms, $(echo "$log" | grep -o '[0-9]* statements reached')"
    else
        echo "$(basename "$proof" .c): ALARMS"
        echo "$log" | grep -A2 'eva:alarm' || echo "$log" | tail -n 20
        status=1
    fi
done
exit $status
