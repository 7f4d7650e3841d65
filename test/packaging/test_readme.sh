#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The code blocks of README.md compile, and its commands run.
. "$(dirname "$0")/common.sh"
block() { awk -v kind="$1" '$0 == "```" kind { inside = 1; next } $0 == "```" { inside = 0 } inside' "$source_dir/README.md"; }

block c >"$work/readme.c"
[ -s "$work/readme.c" ] || { echo "FAILED: README.md has no C"; exit 1; }
quietly "$cc" -std=c99 -pedantic -Wall -Wextra -Werror -I"$source_dir/lib/include" -c "$work/readme.c" -o "$work/readme.o"

# In a folder that looks like the source, with the tool that is built already in place of a build.
mkdir "$work/tree"
for part in lib port examples; do ln -s "$source_dir/$part" "$work/tree/$part"; done
[ -x "${STAD_BUILD:?}/stad" ] || skip "$STAD_BUILD/stad is not built"
mkdir "$work/tree/build"
ln -s "$STAD_BUILD/stad" "$work/tree/build/stad"
block sh | grep -v '^cmake ' >"$work/readme.sh"
[ "$(grep -c stad "$work/readme.sh")" -ge 5 ] || { echo "FAILED: README.md has no commands"; exit 1; }
cd "$work/tree"
quietly bash -eu "$work/readme.sh"
for file in one_pair disp.npy disp.png tuned.json tuned.html better.npy; do
    [ -s "$file" ] || { echo "FAILED: $file was not written"; exit 1; }
done
