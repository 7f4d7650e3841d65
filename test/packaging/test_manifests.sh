#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Every manifest says the version of stad/config.h, the CMSIS-Pack lists every file, and the script that sees to it does.
. "$(dirname "$0")/common.sh"
command -v python3 >/dev/null || skip "python3 is missing"
quietly "$source_dir/tools/release/manifests" --check
copy_source "$work/copy"
cd "$work/copy"
check() { tools/release/manifests --check >"$work/log"; }
failed() { echo "FAILED: $*"; cat "$work/log"; exit 1; }

quietly tools/release/manifests --set 7.8.9
for file in lib/include/stad/config.h tools/python/src/stadimeter/_version.py idf_component.yml library.json Doxyfile ./*.pdsc; do
    grep -q '7\.8\.9' "$file" || failed "$file does not say the version that was set"
    if grep -qF "\"$version\"" "$file"; then failed "$file still says $version"; fi
done
grep -q 'STAD_VERSION_MINOR 8' lib/include/stad/config.h || failed "the parts of the version"
check || failed "what was just written is not right"
sed -i 's/7\.8\.9/7.8.8/' library.json
if check; then failed "a manifest of another version is not noticed"; fi
grep -q '^library.json' "$work/log" || failed "the manifest of another version is not named"
quietly tools/release/manifests
echo 'int stad_one_more;' >lib/src/base/one_more.c
if check; then failed "a source file that the pack does not list is not noticed"; fi
if tools/release/manifests --set 1.2 2>/dev/null; then failed "1.2 was taken for a version"; fi
