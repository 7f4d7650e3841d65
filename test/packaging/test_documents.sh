#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The code blocks of README.md and of every other page compile or run: documents.py, in a copy of the source.
. "$(dirname "$0")/common.sh"
command -v python3 >/dev/null || skip "python3 is missing"
[ -x "${STAD_BUILD:?}/stad" ] || skip "$STAD_BUILD/stad is not built"
copy_source "$work/tree"
mkdir "$work/tree/build"
ln -s "$STAD_BUILD/stad" "$work/tree/build/stad"

# Python with the package, where pip can be had; its blocks are said to be left out otherwise.
python=''
if (venv_with documents numpy pillow) >/dev/null; then
    venv_with documents numpy pillow
    quietly cmake -S "$work/tree/tools/python" -B "$work/native" -DCMAKE_C_COMPILER="$cc"
    quietly cmake --build "$work/native" -j 2
    export STADIMETER_LIBRARY="$work/native/libstadimeter_native.so" PYTHONPATH="$work/tree/tools/python/src"
    python=$venv/bin/python
fi
python3 "$source_dir/test/packaging/documents.py" "$work/tree" ${python:+"$python"}
