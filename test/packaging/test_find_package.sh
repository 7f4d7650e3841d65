#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# find_package(stadimeter) finds the installed library, and refuses a version that it is not.
. "$(dirname "$0")/common.sh"
install_library
consume "find_package(stadimeter $version REQUIRED)" -DCMAKE_PREFIX_PATH="$work/prefix"
echo 'find_package(stadimeter 99.0 REQUIRED)' >"$work/consumer/CMakeLists.txt"
if cmake -S "$work/consumer" -B "$work/consumer/other" -DCMAKE_PREFIX_PATH="$work/prefix" >"$work/log" 2>&1; then
    echo "FAILED: version 99.0 was found"
    exit 1
fi
