#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `stad simulate`: every layout of a recording gives the same log; a drawn recording of the target ends with a better set in
# the store; frames that cannot be read stop it, or are skipped, and nothing that was done is lost.
set -u
stad=${STAD_BUILD:?}/stad
[ -x "$stad" ] || { echo "SKIPPED: $stad is not built"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT; trap 'exit 130' INT; trap 'exit 143' TERM
cd "$work" || exit 1
failures=0
fail() { echo "FAILED: $*"; failures=$((failures + 1)); }
run() { "$stad" "$@" >out.txt 2>err.txt || fail "stad $*: $(cat err.txt)"; }
# refuse STATUS REGEX ARGUMENT...
refuse() {
    local status=$1 regex=$2 got
    shift 2
    "$stad" simulate "$@" >out.txt 2>err.txt
    got=$?
    [ $got = "$status" ] && grep -qE -- "$regex" err.txt || fail "stad simulate $*: status $got, $(cat err.txt)"
}
number() { tr -d ' \t\n' <"$2" | grep -o "\"$1\":[-0-9.e]*" | head -n 1 | cut -d: -f2; }

run scene -o rec --target --frames 10 --width 320 --height 240 --noise 30 --seed 3
[ "$(ls rec | wc -l)" = 40 ] || fail "a recording of ten frames has four files each"
range=(--num-disparities 64 --learn-frames 3)

### layouts ###
mkdir -p kitti/image_0 kitti/image_1 euroc/mav0/cam0/data euroc/mav0/cam1/data two/left two/right
for i in 000 001 002 003; do
    cp rec/${i}_left.png kitti/image_0/$i.png; cp rec/${i}_right.png kitti/image_1/$i.png
    cp rec/${i}_left.png euroc/mav0/cam0/data/$i.png; cp rec/${i}_right.png euroc/mav0/cam1/data/$i.png
    cp rec/${i}_left.png two/left/$i.png; cp rec/${i}_right.png two/right/$i.png
done
run simulate rec "${range[@]}" --frames 4 --csv rec.csv
for layout in kitti euroc two; do
    run simulate $layout "${range[@]}" --csv $layout.csv
    cmp -s rec.csv $layout.csv || fail "the layout $layout gives another log"
done
[ "$(wc -l <rec.csv)" = 5 ] || fail "a log of four frames"
head -c 38400 /dev/urandom >frames.raw
run simulate frames.raw --size 160x120 --num-disparities 16 --csv raw.csv
[ "$(wc -l <raw.csv)" = 2 ] || fail "a raw file of one pair"
mkdir wide
{ printf 'P5\n320 120\n255\n'; cat frames.raw; } >wide/0.pgm
run simulate wide --side-by-side --num-disparities 16

### the whole loop ###
run simulate rec "${range[@]}" --focal 192 --calibrate-at 1 --evaluations 20 --budget 40 --probation-frames 0 --json loop.json --report loop.html
grep -q '"outcome":.*"adopted"' loop.json || fail "nothing was adopted: $(cat out.txt)"
before=$(number judge_before loop.json) after=$(number judge_after loop.json)
awk -v a="$before" -v b="$after" 'BEGIN { exit !(b < a) }' || fail "the adopted set is no better on the other pose: $before $after"
grep -q '"stored":.*null' loop.json && fail "nothing was stored"
grep -q 'run ended: adopted' out.txt || fail "the outcome is not told"
grep -q '</html>' loop.html || fail "no report"
run simulate rec "${range[@]}" --focal 192 --calibrate-at 1 --evaluations 20 --budget 40 --probation-frames 0 --json again.json
[ "$(grep -v seconds loop.json)" = "$(grep -v seconds again.json)" ] || fail "two simulations of the same recording differ"

### cameras at fault are told at once, with or without a target to look for; what ended and when, by frame ###
cp -r rec ill
cp ill/003_left.png ill/003_right.png                                           # one camera for both
cp ill/005_left.png ill/006_left.png; cp ill/005_left.png ill/007_left.png      # a frozen view
run simulate ill "${range[@]}" --csv ill.csv --json ill.json --report ill.html
[ "$(sed 's/.*,//' ill.csv | tr '\n' ' ')" = "live_fault none none none same none none frozen frozen none none " ] ||
    fail "faults of live frames: $(sed 's/.*,//' ill.csv | tr '\n' ' ')"
tr -d ' \t\n' <ill.json | grep -q '"live_faults":\[{"frame":3,"last_frame":3,"fault":"same"},{"frame":6,"last_frame":7,"fault":"frozen"}\]' ||
    fail "faults of live frames in JSON: $(cat ill.json)"
grep -q 'Camera fault in the frames 6 to 7: frozen' ill.html || fail "the report tells of no camera"
run simulate ill "${range[@]}" --focal 192 --calibrate-at 0 --probation-frames 0 --budget 12 --evaluations 12
[ "$(sed -n 's/^frame [0-9]*: \([a-z]* [a-z]*\).*/\1/p' out.txt | tr '\n' ' ')" = "camera fault run ended camera fault " ] ||
    fail "not by frame: $(cat out.txt)"
run simulate rec "${range[@]}" --focal 192 --calibrate-at 1 --frames 2 --json open.json
tr -d ' \t\n' <open.json | grep -q '"run_under_way":{"phase":"other","fault":"none","evaluations":0,"tune_before":null,"tune_after":null,' ||
    fail "the run under way: $(cat open.json)"
grep -q '"run_under_way":.*null' loop.json || fail "no run is under way after its end"

### what ends after the last frame has the number of the last frame played ###
run simulate rec "${range[@]}" --focal 192 --calibrate-at 1 --budget 12 --probation-frames 0 --frames 6 --json six.json
[ "$(sed -n 's/^frame \([0-9]*\): run ended.*/\1/p' out.txt)" = 5 ] && [ "$(number frame six.json)" = 5 ] || fail "a frame never played: $(cat out.txt)"

### every run is told, however many: a scheduled look every 300 frames, at black ones ###
truncate -s $((20000 * 2 * 48 * 32)) black.raw
run simulate black.raw --size 48x32 --num-disparities 16 --focal 40 --json black.json
[ "$(grep -c 'run ended' out.txt)" = 66 ] && [ "$(grep -c '"outcome"' black.json)" = 66 ] || fail "$(grep -c 'run ended' out.txt) looks of 66 are told"

### the same on the host, from one pair ###
run tune rec/002_left.png rec/002_right.png --fiducials --focal 192 --num-disparities 64 --max-evals 30 --json marks.json
start=$(number bad marks.json) best=$(tr -d ' \t\n' <marks.json | sed 's/.*"best":{//' | grep -o '"bad":[0-9.e-]*' | cut -d: -f2)
awk -v a="$start" -v b="$best" 'BEGIN { exit !(b < a) }' || fail "tuned on the target: bad $start, then $best"
for set in start best; do
    params=() && [ $set = best ] && params=(--params marks.json)
    run match rec/008_left.png rec/008_right.png -o $set.npy --num-disparities 64 "${params[@]}"
    run eval $set.npy rec/008_disp.pfm --min-disparity 0 --num-disparities 64 --mask rec/008_nonocc.png --json
    number 1 out.txt >$set.bad
done
awk -v a="$(cat start.bad)" -v b="$(cat best.bad)" 'BEGIN { exit !(b < a) }' ||
    fail "what was tuned on the target is worse on the whole of another frame: $(cat start.bad best.bad)"
run scene -o tall --target --frames 3 --width 320 --height 240 --seed 3 --pgm
for view in left right; do # the rows below the principal point, which lies above the picture then
    { printf 'P5\n320 115\n255\n'; tail -c $((115 * 320)) tall/002_$view.pgm; } >low_$view.pgm
done
run tune low_left.pgm low_right.pgm --fiducials --focal 192 --center 159.5,-5.5 --num-disparities 64 --max-evals 1 --json low.json
awk -v a="$(number bad low.json)" 'BEGIN { exit !(a > 0 && a < 0.03) }' || fail "a principal point off the picture: $(cat out.txt)"
run scene -o sunk --target --frames 1 --width 320 --height 240 --drift 2
"$stad" tune sunk/000_left.png sunk/000_right.png --fiducials --focal 192 2>err.txt >out.txt
[ $? = 1 ] && grep -q 'the rows of the two views differ' err.txt || fail "a sunk camera is not refused: $(cat err.txt)"
"$stad" tune rec/002_left.png rec/002_left.png --fiducials 2>err.txt >out.txt
[ $? = 2 ] && grep -q -- '--focal' err.txt || fail "--fiducials without --focal"
"$stad" tune rec/002_right.png rec/002_left.png --fiducials --focal 192 2>err.txt >out.txt
[ $? = 2 ] && grep -q 'left and right are exchanged' err.txt || fail "exchanged views: $(cat err.txt)"
"$stad" tune rec/002_left.png rec/002_left.png --fiducials --focal 192 2>err.txt >out.txt
[ $? = 2 ] && grep -q 'the same picture twice' err.txt || fail "the same picture twice: $(cat err.txt)"
run scene -o plain --width 320 --height 240 --plates 3
"$stad" tune plain/left.png plain/right.png --fiducials --focal 192 2>err.txt >out.txt
[ $? = 3 ] && grep -q '0 marks on the left' err.txt || fail "a pair without marks: $(cat err.txt)"

### an alarm ###
run simulate rec "${range[@]}" --noise 25 --from 6 --json alarm.json
tr -d ' \t\n' <alarm.json | grep -q '"alarms":\[[67]\]' || fail "noise from frame 6 on raises no alarm"
run simulate rec "${range[@]}" --json calm.json
tr -d ' \t\n' <calm.json | grep -q '"alarms":\[\]' || fail "a steady recording raises an alarm"

### the set in use, matched with ###
run match rec/008_left.png rec/008_right.png -o used.npy --params loop.json
used=$(tr -d ' \t\n' <loop.json | sed 's/.*"in_use":{"params":\({[^}]*}\).*/\1/')
echo "$used" >used.json
run match rec/008_left.png rec/008_right.png -o same.npy --params used.json
cmp -s used.npy same.npy || fail "--params with what simulate wrote is not the set in use"
echo "{\"in_use\": {\"params\": $used, \"corrected\": true}}" >used.json
run match rec/008_left.png rec/008_right.png -o same.npy --params used.json
grep -q 'used.json: these parameters are for a corrected right view' err.txt || fail "a correction is lost without a word"

### a signal: what was done is written, as whole files ###
set -m # or children in the background would ignore SIGINT
for signal in INT TERM; do
    rm -f cut.*
    mkfifo gate
    rm -rf long && cp -r rec long && rm long/004_right.png && ln -s "$PWD/gate" long/004_right.png
    "$stad" simulate long "${range[@]}" --csv cut.csv --json cut.json --report cut.html >cut.out 2>cut.err &
    child=$!
    exec 3>gate # opens when the simulation has come to frame 4
    kill -$signal $child
    rm long/004_right.png && cp rec/004_right.png long # the report reads a frame again
    cat rec/004_right.png >&3
    exec 3>&-
    wait $child 2>/dev/null
    status=$?
    [ $status = $((128 + $(kill -l $signal))) ] || fail "SIG$signal: status $status"
    [ "$(wc -l <cut.csv)" = 6 ] || fail "SIG$signal: $(wc -l <cut.csv) lines of 5 frames"
    grep -q '"stopped":.*"interrupted after 5 of 10 frames"' cut.json && grep -q '</html>' cut.html || fail "SIG$signal: half a file"
    grep -q 'interrupted after 5 of 10' cut.err && grep -q '^5 frames' cut.out || fail "SIG$signal: not told: $(cat cut.err)"
    ls | grep -qE '^cut\.(csv|json|html)\.' && fail "SIG$signal: left beside: $(ls)"
    rm gate
done
set +m

### bad input ###
refuse 3 'nowhere: .*(No such|cannot be read)' nowhere
refuse 3 'no stereo frames found' wide
refuse 2 'frames.raw is a file: frames in one file go with --size' frames.raw
refuse 3 'no whole number of pairs' frames.raw --size 161x120
refuse 2 '--size 12: must be' frames.raw --size 12
refuse 2 'block_size 4' rec --block-size 4
refuse 3 'nowhere/x.csv: cannot be written' rec --csv nowhere/x.csv
refuse 2 '--cost rmse' rec --cost rmse
cp -r kitti bad
head -c 3000 kitti/image_1/002.png >bad/image_1/002.png
refuse 3 'image_1/002.png: bad PNG' bad "${range[@]}" --csv bad.csv --json bad.json
[ "$(head -n 3 bad.csv)" = "$(head -n 3 rec.csv)" ] && [ "$(wc -l <bad.csv)" = 3 ] || fail "what was done before the bad frame is lost"
grep -q '"stopped":.*image_1/002.png' bad.json && grep -q '"learning":.*true' bad.json || fail "the JSON of a cut run looks whole"
"$stad" simulate bad "${range[@]}" --keep-going --csv bad.csv >out.txt 2>err.txt || fail "--keep-going stops"
grep -q 'skipped: .*image_1/002.png' err.txt && grep -q '^3 frames of 320 x 240, 1 skipped' out.txt || fail "a skipped frame is not told, or counted"
[ "$(wc -l <bad.csv)" = 5 ] && grep -q '^2,skipped,' bad.csv || fail "the log of a recording with a bad frame"
run scene -o small --width 96 --height 48 --num-disparities 16 --plates 2
rm -r bad && cp -r kitti bad && cp small/left.png bad/image_0/003.png && cp small/right.png bad/image_1/003.png
refuse 3 'frame 3 is 96 x 48, those before were 320 x 240' bad "${range[@]}"
rm -r bad && cp -r kitti bad && rm bad/image_1/001.png
refuse 3 'image_1/001.png: No such file' bad "${range[@]}"
"$stad" simulate bad "${range[@]}" --keep-going >out.txt 2>err.txt && grep -q '1 skipped' out.txt || fail "a missing right frame"
run scene -o large --width 2056 --height 48 --num-disparities 16 --plates 2
refuse 2 'frames of 2056 x 48 px: the board takes 16 to 2048 px a side' large --num-disparities 16
refuse 2 'no board for frames of 320 x 240 px, --focal 5000' rec --num-disparities 64 --focal 5000
[ $failures = 0 ] && echo "all as expected"
