#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The HTML reports in headless Chromium, by Playwright: they render, the sliders move, the console stays silent.
. "$(dirname "$0")/common.sh"
[ -x "${STAD_BUILD:?}/stad" ] || skip "$STAD_BUILD/stad is not built"
command -v chromium >/dev/null || command -v chromium-browser >/dev/null || skip "Chromium is missing (Debian: chromium)"
venv_with playwright playwright
quietly "$venv/bin/python" "$source_dir/test/unit/test_tool_report.py"
grep -q SKIPPED "$work/log" && { cat "$work/log"; exit 77; }
cat "$work/log"
