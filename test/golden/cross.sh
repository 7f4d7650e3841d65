#!/bin/sh
# SPDX-License-Identifier: MIT
# golden/cross.sh CC QEMU [FLAG...] - builds the matcher, the golden test and Unity statically with a cross compiler, with no
# configure step at all, and runs it under user-mode emulation. 77: compiler or emulator is not installed.
set -eu
cc=$1 qemu=$2
shift 2
command -v "$cc" >/dev/null || { echo "SKIPPED: $cc is not installed"; exit 77; }
command -v "$qemu" >/dev/null || { echo "SKIPPED: $qemu is not installed"; exit 77; }
[ -n "${UNITY_DIR:-}" ] || { echo "SKIPPED: Unity is missing (test/setup gets it)"; exit 77; }
root=$(cd "$(dirname "$0")/../.." && pwd)
support=$root/test/support
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT; trap 'exit 130' INT; trap 'exit 143' TERM
"$cc" -std=c99 -O2 -static "$@" -I"$root/lib/include" -I"$root/lib/src" -I"$root/port/isa/c" -I"$root/test" -I"$UNITY_DIR" \
    "$root"/lib/src/base/*.c "$root"/lib/src/kernel/*.c "$root"/lib/src/match/*.c \
    "$support/scene.c" "$support/case.c" "$support/subject.c" "$support/reference.c" "$support/fixture.c" \
    "$root/test/golden/test_golden.c" "$UNITY_DIR/unity.c" -o "$out/golden"
"$qemu" "$out/golden"
