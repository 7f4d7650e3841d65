#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# No build system at all: the compiler over lib/src, and a Makefile of four lines.
. "$(dirname "$0")/common.sh"
quietly "$cc" -std=c99 -O1 -I"$source_dir/lib/include" -I"$source_dir/lib/src" -I"$source_dir/port/isa/c" \
    "$source_dir"/lib/src/*/*.c "$work/main.c" -o "$work/main"
quietly "$work/main"
command -v make >/dev/null || exit 0
cat >"$work/Makefile" <<'EOF'
CFLAGS = -std=c99 -O1 -I$(STAD)/lib/include -I$(STAD)/lib/src -I$(STAD)/port/isa/c
OBJECTS = $(patsubst $(STAD)/%.c,%.o,$(wildcard $(STAD)/lib/src/*/*.c)) main.o
program: $(OBJECTS); $(CC) -o $@ $^
lib/%.o: $(STAD)/lib/%.c; mkdir -p $(@D) && $(CC) $(CFLAGS) -c -o $@ $<
EOF
ln -s "$source_dir" "$work/stad" # make knows no name with a space in it
quietly make -C "$work" -j 2 CC="$cc" STAD=stad
quietly "$work/program"
