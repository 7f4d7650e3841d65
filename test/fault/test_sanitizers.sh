#!/bin/sh
# SPDX-License-Identifier: MIT
# Unit, kernel and property tests once more under AddressSanitizer and UndefinedBehaviorSanitizer, every arithmetic verb
# asserting its range (STAD_CHECKED).
set -eu
dir=$STAD_BUILD/sanitized
flags='-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer'
cmake -S "$STAD_SOURCE" -B "$dir" -DCMAKE_BUILD_TYPE=Debug -DSTAD_CHECKED=ON -DSTAD_BUILD_EXAMPLES=OFF -DSTAD_BUILD_TOOLS=OFF \
    -DCMAKE_C_FLAGS="$flags" -DCMAKE_CXX_FLAGS="$flags" -DUNITY_DIR="$UNITY_DIR" >"$dir.log" 2>&1 ||
    { tail -n 20 "$dir.log"; exit 1; }
targets=$(cmake --build "$dir" --target help | sed -n 's/^\.\.\. \(test_[a-z0-9_]*\)$/\1/p')
# shellcheck disable=SC2086
cmake --build "$dir" -j "$(nproc)" --target $targets >>"$dir.log" 2>&1 || { grep -A5 error "$dir.log" | head -n 40; exit 1; }
cd "$dir"
ctest -L '^(unit|kernel|property|fault)$' -R '/test_' -E 'sanitizers|valgrind|ubsan|symbols|floors|tool|cross|example' \
    -j "$(nproc)" --output-on-failure --timeout 900
