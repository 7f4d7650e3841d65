#!/bin/sh
# SPDX-License-Identifier: MIT
# The matcher's contexts under valgrind: no byte read before it was written, none outside, none lost.
set -eu
command -v valgrind >/dev/null || { echo "SKIPPED: valgrind is not installed"; exit 77; }
test=$STAD_BUILD/test/test_property_extras
[ -x "$test" ] || { echo "SKIPPED: test_property_extras is not built"; exit 77; }
for isa in c avx2; do # whatever the CPU has up to avx2
    STAD_ISA=$isa valgrind -q --error-exitcode=9 --leak-check=full "$test"
done
