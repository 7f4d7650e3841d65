# SPDX-License-Identifier: MIT
# Sourced by the packaging tests: a scratch folder, and the library installed into a prefix there.
# A consumer is the first example, compiled and run outside the source tree.
set -euo pipefail
source_dir=${STAD_SOURCE:-$(cd "$(dirname "$0")/../.." && pwd)}
cc=${CC:-cc}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT; trap 'exit 130' INT; trap 'exit 143' TERM
cp "$source_dir/examples/01_one_pair.c" "$work/main.c"
version=$(sed -n 's/.*define STAD_VERSION  *"\(.*\)"/\1/p' "$source_dir/lib/include/stad/config.h")

skip() { echo "SKIPPED: $*"; exit 77; }

quietly() { "$@" >"$work/log" 2>&1 || { cat "$work/log"; echo "FAILED: $*"; exit 1; }; }

install_library() {
    quietly cmake -S "$source_dir" -B "$work/build" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_COMPILER="$cc" \
        -DCMAKE_INSTALL_PREFIX="$work/prefix" -DSTAD_BUILD_TOOLS=OFF -DSTAD_BUILD_TESTS=OFF -DSTAD_BUILD_EXAMPLES=OFF
    quietly cmake --build "$work/build" -j 2
    quietly cmake --install "$work/build"
}

# consume LISTS: a CMake project of main.c with these lines in the middle, built and run.
consume() {
    mkdir "$work/consumer"
    cp "$work/main.c" "$work/consumer"
    {
        echo 'cmake_minimum_required(VERSION 3.25)'
        echo 'project(consumer LANGUAGES C)'
        printf '%s\n' "$1"
        echo 'add_executable(main main.c)'
        echo 'target_link_libraries(main PRIVATE stadimeter::stadimeter)'
    } >"$work/consumer/CMakeLists.txt"
    quietly cmake -S "$work/consumer" -B "$work/consumer/build" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_COMPILER="$cc" "${@:2}"
    quietly cmake --build "$work/consumer/build" -j 2
    quietly "$work/consumer/build/main"
    # a library inside a project brings no tools, tests or examples along
    [ ! -e "$work/consumer/build/stad" ] || { echo "FAILED: the tools were built too"; exit 1; }
}

# venv_with NAME PACKAGE...: a virtual environment with these Python packages, kept in the build folder; sets $venv.
venv_with() {
    venv=${STAD_BUILD:-$work}/venv-$1
    shift
    [ -e "$venv/complete" ] && return
    rm -rf "$venv"
    python3 -m venv "$venv" 2>/dev/null || skip "python3 has no venv (Debian: python3-venv)"
    "$venv/bin/pip" -q install "$@" >"$work/log" 2>&1 || skip "pip cannot install $* here"
    touch "$venv/complete"
}

# A copy of what git knows of the source, or of all of it.
copy_source() {
    mkdir -p "$1"
    if git -C "$source_dir" rev-parse HEAD >/dev/null 2>&1; then
        (cd "$source_dir" && git ls-files -z --cached --others --exclude-standard | { xargs -0 ls -d 2>/dev/null || true; } | tar -c -T -) | tar -x -C "$1"
    else
        cp -r "$source_dir/." "$1"
    fi
}
