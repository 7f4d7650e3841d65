#!/bin/sh
# SPDX-License-Identifier: MIT
# test_tool_sheet.sh - stad sheet: the same bytes each time, true scale, what is refused.
set -eu
stad=$STAD_BUILD/stad
[ -x "$stad" ] || { echo "SKIPPED: no stad in $STAD_BUILD"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT; trap 'exit 130' INT; trap 'exit 143' TERM
cd "$work"
die() { echo "FAILED: $*"; exit 1; }

for paper in a4 letter; do
    "$stad" sheet -o one.pdf --paper $paper
    "$stad" sheet -o two.pdf --paper $paper
    cmp one.pdf two.pdf || die "$paper: two runs differ"
    "$stad" sheet -o s.svg --paper $paper
    "$stad" sheet -o t.svg --paper $paper
    for page in s-*.svg; do cmp "$page" "t-${page#s-}" || die "$paper: two runs differ in $page"; done
    grep -aq "/Count $(ls s-*.svg | wc -l) " one.pdf || die "$paper: PDF and SVG have different numbers of pages"
done

"$stad" sheet -o a4.pdf --paper a4
grep -aq 'MediaBox \[0 0 841.890 595.276\]' a4.pdf || die "a4 is not 297 x 210 mm"
"$stad" sheet -o letter.pdf --paper letter
grep -aq 'MediaBox \[0 0 791.972 612.000\]\|MediaBox \[0 0 792.000 612.000\]' letter.pdf || die "letter is not 11 x 8.5 in"
"$stad" sheet -o s.svg
grep -q 'width="297.000mm" height="210.000mm" viewBox="0 0 297.000 210.000"' s-1.svg || die "SVG is not in millimetres"
python3 - <<'PY' || die "the ruler is not 100 mm"
import re
lines = [tuple(map(float, m)) for m in re.findall(r'<line x1="([\d.]+)" y1="([\d.]+)" x2="([\d.]+)" y2="([\d.]+)"', open("s-1.svg").read())]
raise SystemExit(not any(abs(abs(y2 - y1) - 100) < 1e-9 and x1 == x2 for x1, y1, x2, y2 in lines))
PY

refused() { want=$1; shift; status=0; "$stad" sheet "$@" 2>err || status=$?; [ "$status" = "$want" ] || die "stad sheet $*: $status, not $want"; [ -s err ] || die "no word about $*"; }
refused 2
refused 2 -o x.png
refused 2 -o x.pdf --paper a5
refused 2 -o x.pdf --target cube
refused 2 -o x.pdf more
refused 3 -o missing/x.pdf
refused 3 -o missing/x.svg
refused 3 -o s-1.svg/x.pdf
grep -q "Not a directory" err || die "a file as a folder: $(cat err)"
status=0; "$stad" simulate . --size 16x16 --num-disparities 16 2>err || status=$?
[ $status -eq 2 ] && grep -q "is a folder" err || die "simulate: a folder with --size: $status, $(cat err)"
echo "sheet: same bytes, true scale"
