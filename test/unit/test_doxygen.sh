#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The API reference is made without a warning: everything public is documented. An undocumented function is noticed.
set -u
command -v doxygen >/dev/null || { echo "SKIPPED: doxygen is missing (Debian: doxygen)"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT; trap 'exit 130' INT; trap 'exit 143' TERM
mkdir -p "$work/lib" "$work/tools"
cp -r "$STAD_SOURCE/lib/include" "$work/lib"
cp -r "$STAD_SOURCE/tools/docs" "$work/tools"
cd "$work" || exit 1
reference() {
    mkdir -p out
    { cat "$STAD_SOURCE/Doxyfile"; echo "OUTPUT_DIRECTORY = out"; echo "WARN_AS_ERROR = FAIL_ON_WARNINGS"; } | doxygen - >out/log 2>&1
}
reference || { echo "FAILED:"; sed "s,$work/,," out/log; exit 1; }
[ -s out/html/match_8h.html ] && grep -q 'stad_match_push' out/html/match_8h.html || { echo "FAILED: no page of stad/match.h"; exit 1; }
echo 'int stad_depth_undocumented(void);' >>lib/include/stad/depth.h
reference && { echo "FAILED: an undocumented function goes unnoticed"; exit 1; }
grep -q stad_depth_undocumented out/log || { echo "FAILED: an undocumented function is not named"; cat out/log; exit 1; }
