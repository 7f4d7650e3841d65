#!/bin/sh
# SPDX-License-Identifier: MIT
# The golden trajectory under -O0 and -O3, with clang, and on AArch64 and big-endian PowerPC under qemu-user. A compiler or an
# emulator that is not there is named as UNAVAILABLE; without any cross run the test counts as skipped.
set -eu
source=${STAD_SOURCE:-$(cd "$(dirname "$0")/../.." && pwd)}
unity=${UNITY_DIR:-}
[ -f "$unity/unity.c" ] || { echo "SKIPPED: UNITY_DIR does not hold unity.c"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT; trap 'exit 130' INT; trap 'exit 143' TERM
run() { # name, emulator, compiler, flags
    command -v "$3" >/dev/null 2>&1 || { echo "$1: UNAVAILABLE ($3)"; return 0; }
    [ -z "$2" ] || command -v "$2" >/dev/null 2>&1 || { echo "$1: UNAVAILABLE ($2)"; return 0; }
    # shellcheck disable=SC2086
    "$3" -std=c99 $4 -DUNITY_SUPPORT_64 -DUNITY_EXCLUDE_FLOAT -I"$unity" -I"$source/lib/include" -I"$source/lib/src" -o "$work/t" \
        "$source/test/unit/test_tune_golden.c" "$unity/unity.c" "$source"/lib/src/tune/*.c "$source/lib/src/base/log.c" "$source/lib/src/base/divide.c"
    $2 "$work/t" >"$work/out" || { cat "$work/out"; echo "$1: FAILED"; exit 1; }
    echo "$1: same trajectory"
    [ -z "$2" ] || crossed=yes
}
crossed=
run "x86 or host -O0" "" "${CC:-cc}" "-O0"
run "x86 or host -O3" "" "${CC:-cc}" "-O3"
run "clang -O2" "" clang-19 "-O2"
for level in -O0 -O3; do
    run "AArch64 $level" qemu-aarch64 aarch64-linux-gnu-gcc "$level -static"
    run "PowerPC big-endian $level" qemu-ppc powerpc-linux-gnu-gcc "$level -static"
done
[ -n "$crossed" ] || { echo "SKIPPED: no foreign core could be run"; exit 77; }
