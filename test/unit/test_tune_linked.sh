#!/bin/sh
# SPDX-License-Identifier: MIT
# A program that names one method of the tuner gets that method's code alone from the archive.
set -eu
source=${STAD_SOURCE:-$(cd "$(dirname "$0")/../.." && pwd)}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT; trap 'exit 130' INT; trap 'exit 143' TERM
cd "$work"
for file in "$source"/lib/src/tune/*.c "$source/lib/src/base/log.c" "$source/lib/src/base/divide.c"; do
    "${CC:-cc}" -std=c99 -O1 -I"$source/lib/include" -I"$source/lib/src" -c "$file"
done
ar rc libtune.a ./*.o
status=0
check() { # method, what its program must hold, what it must not
    cat >main.c <<END
#include "stad/tune.h"
int main(void)
{
    static stad_tune t;
    stad_tune_config c;
    stad_point x = {{72, 288, 3, 10, 63, 1}};
    stad_tune_config_stereo(&c, STAD_TUNE_FOR_ANY);
    stad_tune_$1_init(&t, &c, &x);
    while (stad_tune_ask(&t, &x) == 1)
        stad_tune_$1_tell(&t, x.v[0]);
    return stad_tune_best(&t, &x, 0) != 0;
}
END
    "${CC:-cc}" -std=c99 -I"$source/lib/include" -o program main.c libtune.a
    symbols=$(nm --defined-only program | awk '{ print $NF }')
    for name in $2; do
        echo "$symbols" | grep -qx "$name" || { echo "$1: $name is missing"; status=1; }
    done
    for name in $3; do
        ! echo "$symbols" | grep -q "^$name" || { echo "$1: $name is linked, too"; status=1; }
    done
}
check descent stad_tune_descend "stad_tune_init stad_tune_wolfe stad_tune_paper stad_tune_sd stad_tune_hybrid stad_tune_cross stad_tune_ncg stad_tune_search"
check ncg "stad_tune_descend stad_tune_search stad_tune_cross" "stad_tune_init stad_tune_wolfe stad_tune_paper stad_tune_sd stad_tune_hybrid"
check paper stad_tune_wolfe_run "stad_tune_init stad_tune_ncg stad_tune_sd stad_tune_hybrid stad_tune_cross stad_tune_joint stad_tune_walk"
check sd stad_tune_wolfe_run "stad_tune_init stad_tune_ncg stad_tune_paper stad_tune_hybrid stad_tune_cross stad_tune_joint stad_tune_walk"
check hybrid "stad_tune_descend stad_tune_search stad_tune_cross" "stad_tune_init stad_tune_wolfe stad_tune_paper stad_tune_sd"
[ $status -eq 0 ] && echo "each method brings its own code alone"
exit $status
