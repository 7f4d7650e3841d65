#!/bin/sh
# SPDX-License-Identifier: MIT
# The build with STAD_CHECKED stops where a caller breaks what the headers leave to it: one broken call of each module must abort,
# the same call unbroken must not.
set -eu
dir=$STAD_BUILD/checked
mkdir -p "$dir"
cat >"$dir/calls.c" <<'EOF'
#include <stdlib.h>
#include <string.h>

#include "base/arith.h"
#include "kernel/kernel.h"
#include "stad/stad.h"

static uint8_t work[400000] STAD_ALIGNED, pix[64 * 64];
static int16_t words[64];

static void match(int broken)
{
    const stad_geometry g = {64, 64, 1, 16, 3, 100, 63, STAD_MODE_SGBM, STAD_MEMORY_FAST};
    stad_params p;
    stad_match m;
    stad_params_default(&p, 16);
    if (stad_match_init(&m, &g, work, sizeof work) != STAD_OK || stad_match_begin(&m, &p) != STAD_OK)
        exit(3);
    stad_match_push(&m, pix, broken ? NULL : pix);
}

static void monitor(int broken)
{
    const stad_match_counts counts = {100, 50, 0, 0, 0, 0};
    stad_monitor m;
    memset(&m, 0, sizeof m);
    if (!broken)
        stad_monitor_init(&m, NULL);
    stad_monitor_frame(&m, &counts);
}

static void score(int broken)
{
    stad_score_config c;
    stad_score s;
    memset(&s, 0, sizeof s);
    stad_score_config_init(&c, STAD_SCORE_BAD, 0, 16);
    if (!broken)
        stad_score_begin(&s, &c);
    stad_score_row(&s, 0, words, NULL, pix, 0);
}

static void mark(int broken)
{
    const stad_image image = stad_image_packed(pix, 64, 64, 1);
    stad_mark out[4];
    stad_mark_find(&image, NULL, broken ? NULL : out, 4, work, sizeof work);
}

static void rig(int broken)
{
    stad_rig r;
    stad_rig_stream s;
    memset(&s, 0, sizeof s);
    stad_rig_identity(&r, 64, 64);
    if (!broken)
        stad_rig_begin(&s, &r, 1, 4, work, sizeof work);
    stad_rig_pull(&s, pix);
}

static void truth(int broken)
{
    static int32_t row[64];
    static stad_truth t;
    stad_truth_init(&t, 64, 64, 0, 16, 1);
    stad_truth_row(&t, 0, 64, row, broken ? NULL : pix);
}

static void store(int broken)
{
    const stad_flash none = {0};
    stad_setup s;
    stad_store_load(&none, broken ? NULL : &s);
}

static void loop(int broken)
{
    static stad_calib c;
    static stad_request r;
    const stad_geometry g = {64, 64, 1, 16, 11, 4000, 127, STAD_MODE_SGBM, STAD_MEMORY_FAST};
    const stad_camera camera = {200 * 256, 32 * 256, 32 * 256};
    stad_calib_config config;
    stad_setup s;
    memset(&s, 0, sizeof s);
    s.width = s.height = 64;
    s.channels = 1;
    stad_params_sample(&s.params, 16, 3, 1);
    stad_rig_identity(&s.rig, 64, 64);
    stad_calib_config_default(&config, &g, stad_target_relief(), &camera);
    if (!broken && stad_calib_init(&c, &config, &s) != STAD_OK)
        exit(3);
    stad_calib_want(&c, &r);
}

static void depth(int broken)
{
    uint16_t mm[4];
    const stad_depth d = {1000, 0, -16};
    stad_depth_row(&d, broken ? NULL : words, 4, mm);
}

static void kernel(int broken)
{
    const stad_check_job job = {words, words, 0, broken ? 65 : 64, 64, 0, 1};
    stad_check_row_c(&job);
}

static void verb(int broken)
{
    volatile int32_t v = broken ? 32768 : 32767;
    narrow_i16(v);
}

int main(int argc, char **argv)
{
    void (*const calls[])(int) = {match, monitor, score, mark, rig, truth, store, loop, depth, kernel, verb};
    const int count = (int)(sizeof calls / sizeof calls[0]), i = argc > 2 ? atoi(argv[1]) : count;
    if (i >= count)
        return 2;
    calls[i](atoi(argv[2]));
    return 0;
}
EOF
# shellcheck disable=SC2046
${CC:-cc} -std=c99 -O1 -DSTAD_CHECKED -I"$STAD_SOURCE/lib/include" -I"$STAD_SOURCE/lib/src" -I"$STAD_SOURCE/port/isa/c" \
    "$STAD_SOURCE"/lib/src/*/*.c "$dir/calls.c" -o "$dir/calls"
failed=0
number=0
for call in match monitor score mark rig truth store loop depth kernel verb; do
    status=0
    "$dir/calls" $number 0 || status=$?
    [ $status -eq 0 ] || { echo "FAILED: a sound call of $call ends with $status"; failed=1; }
    status=0
    (ulimit -c 0; "$dir/calls" $number 1) 2>"$dir/log" || status=$?
    [ $status -eq 134 ] || { echo "FAILED: a broken call of $call ends with $status"; failed=1; }
    grep -o 'Assertion.*' "$dir/log" | sed "s/^/$call: /" || true
    number=$((number + 1))
done
status=0
"$dir/calls" $number 0 || status=$?
[ $status -eq 2 ] || { echo "FAILED: not every call was tried"; failed=1; }
exit $failed
