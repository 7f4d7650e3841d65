#!/bin/sh
# SPDX-License-Identifier: MIT
# The matcher under libFuzzer with the sanitizers, STAD_FUZZ_SECONDS long (default 20), from the seed it prints.
set -eu
command -v clang-19 >/dev/null || { echo "SKIPPED: clang-19 is not installed"; exit 77; }
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT INT TERM
root=$STAD_SOURCE
if ! echo 'int LLVMFuzzerTestOneInput(const unsigned char *d, unsigned long n); int LLVMFuzzerTestOneInput(const unsigned char *d, unsigned long n) { (void)d; (void)n; return 0; }' |
    clang-19 -x c -fsanitize=fuzzer,address,undefined - -o "$out/try" 2>/dev/null; then
    echo "SKIPPED: clang-19 has no fuzzer library (libclang-rt-19-dev)"
    exit 77
fi
clang-19 -std=c99 -O1 -g -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all -DSTAD_CHECKED -I"$root/lib/include" \
    -I"$root/lib/src" -I"$root/port/isa/c" -I"$root/test" "$root"/lib/src/base/*.c "$root"/lib/src/kernel/*.c \
    "$root"/lib/src/match/*.c "$root"/test/support/scene.c "$root"/test/support/case.c "$root"/test/support/subject.c \
    "$root"/test/support/reference.c "$root/test/fuzz/fuzz_match.c" -o "$out/fuzz"
seed=$(date +%s)
echo "seed $seed"
mkdir "$out/corpus"
"$out/fuzz" -seed="$seed" -max_len=400 -max_total_time="${STAD_FUZZ_SECONDS:-20}" -artifact_prefix="$out/" -print_final_stats=1 \
    "$out/corpus" >"$out/log" 2>&1 || { tail -n 60 "$out/log"; for f in "$out"/crash-* "$out"/oom-* "$out"/timeout-*; do [ -f "$f" ] && base64 "$f"; done; exit 1; }
grep -E 'stat::number_of_executed|cov:' "$out/log" | tail -n 2
