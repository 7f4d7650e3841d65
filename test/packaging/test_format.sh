#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Every C file is laid out as .clang-format has it: clang-format-19 -i FILE does it.
. "$(dirname "$0")/common.sh"
command -v clang-format-19 >/dev/null || skip "clang-format-19 is missing"
copy_source "$work/copy"
cd "$work/copy"
# The lines that clang-format would change.
layout() { { find lib port tools test examples -name '*.[ch]' -print0 | xargs -0 -n 32 -P 2 clang-format-19 --dry-run -Werror 2>&1 || true; } | grep ': error:' || true; }

[ -z "$(layout | tee /dev/stderr)" ] || { echo "FAILED: clang-format-19 -i would change these lines"; exit 1; }
printf 'int  two_blanks;\n' >lib/src/base/two_blanks.c
layout | grep -q 'two_blanks.c:1:4: error:' || { echo "FAILED: a line out of layout is not noticed"; exit 1; }
