#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# stadimeter.pc says how to compile and link, and which version this is.
. "$(dirname "$0")/common.sh"
command -v pkg-config >/dev/null || skip "pkg-config is missing (Debian: pkg-config)"
install_library
PKG_CONFIG_PATH=$(dirname "$(find "$work/prefix" -name stadimeter.pc)")
export PKG_CONFIG_PATH
[ "$(pkg-config --modversion stadimeter)" = "$version" ] || { echo "FAILED: version $(pkg-config --modversion stadimeter), not $version"; exit 1; }
# shellcheck disable=SC2046  # flags
quietly "$cc" -std=c99 -O2 "$work/main.c" $(pkg-config --cflags --libs stadimeter) -o "$work/main"
quietly "$work/main"
