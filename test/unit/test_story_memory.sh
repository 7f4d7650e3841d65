#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The story without memory for what it takes at its start, one piece after the other, and for the first frame's map: each time it ends
# with a message and status 3.
set -eu
story=${STAD_BUILD:?}/stad-story
if [ ! -x "$story" ]; then
    echo "SKIPPED: stad-story is not built"
    exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT; trap 'exit 130' INT; trap 'exit 143' TERM
cat >"$work/scarce.c" <<'END'
#include <stddef.h>
#include <stdlib.h>
void *__libc_malloc(size_t), *__libc_calloc(size_t, size_t);
static int is_denied(size_t bytes) /* the SCARCE_AT-th of SCARCE_FROM to SCARCE_TO bytes */
{
    static int count;
    const char *at = getenv("SCARCE_AT"), *from = getenv("SCARCE_FROM"), *to = getenv("SCARCE_TO");
    return at && bytes >= (size_t)atol(from) && bytes <= (size_t)atol(to) && ++count == atoi(at);
}
void *malloc(size_t bytes) { return is_denied(bytes) ? NULL : __libc_malloc(bytes); }
void *calloc(size_t n, size_t each) { return is_denied(n * each) ? NULL : __libc_calloc(n, each); }
END
if ! "${CC:-cc}" -shared -fPIC -O1 -fno-builtin "$work/scarce.c" -o "$work/scarce.so" 2>"$work/log"; then
    echo "SKIPPED: no library that denies memory can be made: $(tail -1 "$work/log")"
    exit 77
fi

# denied AT FROM TO: the story when that piece is not to be had
denied() {
    local status=0
    SCARCE_AT=$1 SCARCE_FROM=$2 SCARCE_TO=$3 LD_PRELOAD=$work/scarce.so timeout 120 "$story" -o "$work/out" >"$work/told" 2>"$work/complaint" || status=$?
    if [ $status != 3 ] || ! grep -q '^stad-story: not enough memory' "$work/complaint"; then
        echo "FAILED: piece $1 of $2 to $3 bytes: status $status, $(cat "$work/complaint")"
        exit 1
    fi
}

for piece in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15; do # nine pictures, then a world's six arrays
    denied $piece 150000 1000000
done
denied 1 345600 345600 # a map of 480 x 360
echo "16 pieces of memory that are not to be had are told"
