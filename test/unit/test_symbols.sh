#!/bin/sh
# SPDX-License-Identifier: MIT
# What libstadimeter.a needs from outside: memcpy, memset (and memmove where a compiler finds one in a loop), no allocator,
# no stdio, no writable global, no name without stad_; and not one float in lib/src, which -mgeneral-regs-only refuses to compile.
set -eu
archive=$STAD_BUILD/lib/libstadimeter.a
status=0
allowed='memcpy|memset|memmove|strlen|strcmp|strncmp|_GLOBAL_OFFSET_TABLE_|__stack_chk_fail|__assert_fail'

# No name of an application can clash with one of the library's.
bare=$(nm -g --defined-only "$archive" | awk 'NF == 3 && $3 !~ /^stad_/ { print $3 }')
if [ -n "$bare" ]; then
    echo "names without stad_:" $bare
    status=1
fi

# The run-time dispatch of port/isa/x86 is the one documented exception.
dispatch='getenv|strtol|__cpu_model|__cpu_indicator_init'
own=$(nm --defined-only "$archive" | awk 'NF == 3 { print $3 }' | sort -u)
foreign=$(nm --undefined-only "$archive" | awk 'NF == 2 { print $2 }' | sort -u | grep -vxE "$allowed" | grep -vxF "$own" || true)
stray=$(echo "$foreign" | grep -vxE "$dispatch" || true)
if [ -n "$stray" ]; then
    echo "symbols from outside:" $stray
    status=1
fi
writable=$(objdump -t "$archive" | awk '
    / file format / { object = $1 }
    NF > 4 && ($(NF - 2) == ".data" || $(NF - 2) == ".bss" || $(NF - 2) == "*COM*") && $NF !~ /^\./ &&
        object !~ /dispatch/ { print object $NF }')
if [ -n "$writable" ]; then
    echo "writable globals:" $writable
    status=1
fi

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT; trap 'exit 130' INT; trap 'exit 143' TERM
case $(uname -m) in
x86_64 | aarch64)
    for file in "$STAD_SOURCE"/lib/src/*/*.c; do
        "${CC:-cc}" -std=c99 -O0 -mgeneral-regs-only -I"$STAD_SOURCE/lib/include" -I"$STAD_SOURCE/lib/src" \
            -I"$STAD_SOURCE/port/isa/c" -c "$file" -o "$out/x.o" || status=1
    done
    ;;
*) echo "SKIPPED on $(uname -m): the compile without floating-point registers" ;;
esac
words=$(grep -nwE 'float|double|malloc|calloc|free|printf' "$STAD_SOURCE"/lib/src/*/*.[ch] | grep -vE ':[0-9]+: *(/?\*|//)|/\*.*(float|double|malloc|free)' || true)
if [ -n "$words" ]; then
    echo "$words"
    status=1
fi
[ $status -eq 0 ] && echo "no foreign symbol, no writable global, no float"
exit $status
