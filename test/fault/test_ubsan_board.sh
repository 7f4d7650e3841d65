#!/bin/sh
# SPDX-License-Identifier: MIT
# The Cortex-M7 firmware with a trap at every place where C leaves behaviour undefined, booted under emulation: the same hashes as
# always, and no trap. The traps are counted, so that a build without them does not pass.
set -eu
for tool in arm-none-eabi-gcc arm-none-eabi-objdump qemu-system-arm; do
    command -v $tool >/dev/null || { echo "SKIPPED: $tool is not installed"; exit 77; }
done
dir=$STAD_BUILD/ubsan-board
rm -rf "$dir"
unset CC
(cd "$STAD_SOURCE" && CFLAGS='-fsanitize=undefined -fsanitize-undefined-trap-on-error' cmake --preset mps2-an500-gcc -B "$dir" &&
    cmake --build "$dir" -j "$(nproc)" --target mcu kernels) >"$dir.log" 2>&1 || { tail -n 20 "$dir.log"; exit 1; }
traps=$(arm-none-eabi-objdump -d "$dir/examples/mcu/mcu" | grep -cw udf)
[ "$traps" -gt 500 ] || { echo "only $traps traps in the firmware"; exit 1; }
for program in mcu/run-mcu run-kernels; do
    timeout 300 "$dir/examples/$program" >"$dir.run" 2>&1 || { tail -n 20 "$dir.run"; exit 1; }
    [ "$(tail -n 1 "$dir.run")" = "done" ] || { tail -n 20 "$dir.run"; exit 1; }
    grep '^sum' "$dir.run"
done
echo "$traps traps, none taken"
