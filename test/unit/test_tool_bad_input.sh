#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Bad input to `stad`: exit status, a message that names the culprit, and no half-written file.
set -u
stad=${STAD_BUILD:?}/stad
[ -x "$stad" ] || { echo "SKIPPED: $stad is not built"; exit 77; }
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT; trap 'exit 130' INT; trap 'exit 143' TERM
cd "$work" || exit 1
failures=0 checks=0

# expect STATUS REGEX ARGUMENT...: runs stad; the message must match, and no file may appear or change.
expect() {
    local status=$1 regex=$2 got before after
    shift 2
    before=$(find . -type f -exec sha256sum {} + | sort)
    "$stad" "$@" >stdout.tmp 2>stderr.tmp
    got=$?
    local message
    message=$(cat stderr.tmp)
    rm -f stdout.tmp stderr.tmp
    after=$(find . -type f -exec sha256sum {} + | sort)
    checks=$((checks + 1))
    if [ $got != "$status" ] || ! grep -qE -- "$regex" <<<"$message" || [ "$before" != "$after" ]; then
        failures=$((failures + 1))
        echo "FAILED: stad $*"
        echo "  exit status $got, expected $status; message must match: $regex"
        echo "  message: $message"
        [ "$before" = "$after" ] || diff <(echo "$before") <(echo "$after") | sed 's/^/  files: /'
    fi
}

# accept ARGUMENT...: must succeed.
accept() {
    checks=$((checks + 1))
    "$stad" "$@" >stdout.tmp 2>stderr.tmp || {
        failures=$((failures + 1))
        echo "FAILED: stad $* should succeed: $(cat stderr.tmp)"
    }
    rm -f stdout.tmp stderr.tmp
}

fail_check() { failures=$((failures + 1)); echo "FAILED: $*"; }

accept scene -o s --width 96 --height 48 --num-disparities 16 --plates 3
accept scene -o other --width 80 --height 48 --num-disparities 16 --plates 3
m=(match s/left.png s/right.png -o out.npy --num-disparities 16)
accept "${m[@]}"
cp out.npy disp.npy
rm out.npy
e=(eval disp.npy s/disp.pfm --min-disparity 0 --num-disparities 16)
t=(tune s/left.png s/right.png --truth s/disp.pfm --num-disparities 16 --max-evals 2)
accept "${e[@]}"
accept "${t[@]}"

### usage ###
expect 2 'usage' 
expect 2 'no command "mtach"' mtach
expect 2 'LEFT and RIGHT' match s/left.png
expect 2 'LEFT and RIGHT' match a b c -o out.npy
expect 2 '-o OUT' match s/left.png s/right.png
expect 2 "unrecognized option '--blok'" "${m[@]}" --blok 3
expect 2 'requires an argument' match s/left.png s/right.png -o
expect 2 '--mode fast.*sgbm, hh, 3way or hh4' "${m[@]}" --mode fast
expect 2 '--memory tiny.*fast or small' "${m[@]}" --memory tiny
expect 2 'disparity and --num-disparities' eval disp.npy s/disp.pfm
expect 2 '--threshold -1' "${e[@]}" --threshold -1
expect 2 '--truth FILE, --fiducials or --scenes' tune s/left.png s/right.png
expect 2 '--cost best' "${t[@]}" --cost best
expect 2 '--method newton' "${t[@]}" --method newton
expect 2 '--max-evals 0' "${t[@]}" --max-evals 0
expect 2 '--start p3' "${t[@]}" --start p3=4
expect 2 '--free mode' "${t[@]}" --free p1,mode
expect 2 '--width is wanted' plan
expect 2 '--width 0' plan --width 0 --height 10 --num-disparities 16

### each parameter outside its domain, and what OpenCV would make of it ###
expect 2 'num_disparities 15 .*multiple of 16' "${m[@]}" --num-disparities 15
expect 2 'num_disparities 0 ' "${m[@]}" --num-disparities 0
expect 2 'num_disparities -16 ' "${m[@]}" --num-disparities -16
expect 2 'num_disparities 8 ' "${m[@]}" --mode 3way --num-disparities 8
expect 2 'num_disparities 96 .*min_disparity 0 \+ num_disparities 96 leaves no column of a 96 pixel wide image' "${m[@]}" --num-disparities 96
expect 2 'min_disparity -2048 ' "${m[@]}" --min-disparity -2048
expect 2 'min_disparity 2040 .*2040 \+ num_disparities 16 is 2056; 2047 is the most' "${m[@]}" --min-disparity 2040
expect 2 'min_disparity 88 .*88 \+ num_disparities 16 leaves no column of a 96 pixel wide image' "${m[@]}" --min-disparity 88
expect 2 'min_disparity -96 .*-96 \+ num_disparities 16 leaves no column' "${m[@]}" --min-disparity -96
expect 2 'num_disparities 4096 .*2047 is the most' "${m[@]}" --num-disparities 4096
expect 2 '--min-disparity 40000: outside' "${m[@]}" --min-disparity 40000
expect 2 'block_size 4 .*make it 5' "${m[@]}" --block-size 4
expect 2 'block_size 0 .*make it 5' "${m[@]}" --block-size 0
expect 2 'block_size 0 .*make it 3' "${m[@]}" --block-size 0 --mode 3way
expect 2 'block_size 161 .*less than the 80 columns' "${m[@]}" --block-size 161
expect 2 'p1 0 .*make it 2' "${m[@]}" --p1 0
expect 2 'p1 32767 \(--p1\): must be in 1..32766$' "${m[@]}" --p1 32767
expect 2 'p2 5 .*make it 10' "${m[@]}" --p1 9 --p2 5
expect 2 '--p2 32768: outside' "${m[@]}" --p2 32768
expect 2 'disp12_max_diff 0 .*make it 1' "${m[@]}" --disp12-max-diff 0
expect 2 'disp12_max_diff -1 .*make it 1' "${m[@]}" --disp12-max-diff -1
expect 2 'pre_filter_cap 14 .*make it 15' "${m[@]}" --pre-filter-cap 14
expect 2 'pre_filter_cap 30 .*make it 31' "${m[@]}" --pre-filter-cap 30
expect 2 'uniqueness_ratio -1 .*make it 10' "${m[@]}" --uniqueness-ratio -1
expect 2 'uniqueness_ratio 100 .*must be in 0..99$' "${m[@]}" --uniqueness-ratio 100
expect 2 'speckle_window_size -1 .*make it 0' "${m[@]}" --speckle-window-size -1
expect 2 'speckle_range -1 .*in 0..134217727' "${m[@]}" --speckle-range -1
expect 2 'speckle_range 999999999 .*in 0..134217727 pixels of disparity, .*32 bits$' "${m[@]}" --speckle-range 999999999
expect 2 '--color and --gray' "${m[@]}" --color --gray
expect 2 '--color and --gray' "${m[@]}" --gray --color
expect 2 '--channels 2: must be 1 or 3' plan --width 96 --height 48 --num-disparities 16 --channels 2
expect 2 '--num-disparities 20: must be a multiple of 8' plan --width 96 --height 48 --num-disparities 20
expect 2 '--p1 7x: not a whole number' "${m[@]}" --p1 7x
expect 2 'block_size 4 ' "${t[@]}" --block-size 4
expect 2 '--start: block_size 4: ' "${t[@]}" --start block_size=4

### parameter files ###
echo '{"block_size": 5, "uniqueness": 3}' >typo.json
echo '{"block_size": 5.5}' >half.json
echo '{"block_size": 6}' >even.json
echo '{"block_size": ' >cut.json
echo '[5]' >list.json
expect 3 'typo.json: "uniqueness" is no parameter' "${m[@]}" --params typo.json
expect 3 'half.json: "block_size" must be a whole number' "${m[@]}" --params half.json
expect 2 'even.json: block_size 6: .*make it 7' "${m[@]}" --params even.json
expect 2 'match: block_size 8 \(--block-size\): .*make it 9' "${m[@]}" --params even.json --block-size 8
expect 2 'even.json: block_size 6: ' "${t[@]}" --params even.json
echo '{"p1": 8} trailing' >trailing.json
echo '{"p1": 8} {"p1": 9}' >two.json
printf '{"p1": 8}\0\n' >nul.json
echo '{"p1": 8, "p2": 90, "p1": 9}' >twice.json
echo '{"p1": 8, "mode": "hh", "mode": "sgbm"}' >twice_mode.json
echo '{"params": {"p1": 8}, "params": {"p1": 9}}' >twice_params.json
printf '\n{"p1": 8}\r\n\t \n' >blanks.json
expect 3 'trailing.json: no JSON: there is more behind its end, from byte 10' "${m[@]}" --params trailing.json
expect 3 'two.json: no JSON' "${m[@]}" --params two.json
expect 3 'nul.json: no JSON' "${m[@]}" --params nul.json
expect 3 'twice.json: "p1" is there twice' "${m[@]}" --params twice.json
expect 3 'twice_mode.json: "mode" is there twice' "${m[@]}" --params twice_mode.json
expect 3 'twice_params.json: "params" is there twice' "${m[@]}" --params twice_params.json
accept "${m[@]}" --params blanks.json
rm out.npy
expect 3 'cut.json' "${m[@]}" --params cut.json
expect 3 'list.json' "${m[@]}" --params list.json
expect 3 'none.json: No such file' "${m[@]}" --params none.json

### pictures ###
size=$(stat -c %s s/left.png)
for keep in 0 7 30 $((size / 2)) $((size - 14)) $((size - 1)); do
    head -c "$keep" s/left.png >cut.png
    expect 3 'cut.png: ' match cut.png s/right.png -o out.npy
done
{ head -c 60 s/left.png; printf 'XXXX'; tail -c +65 s/left.png; } >flipped.png
expect 3 'flipped.png: bad PNG' match flipped.png s/right.png -o out.npy
printf 'P5\n96 48\n255\nshort' >short.pgm
printf 'P5\n99999999999 48\n255\n' >huge.pgm
printf 'P5\n96 48\n31\n' >levels.pgm
{ printf 'P5\n96 48\n65535\n'; head -c 9216 /dev/zero; } >deep.pgm
expect 3 'short.pgm' match s/left.png short.pgm -o out.npy
expect 3 'huge.pgm' match s/left.png huge.pgm -o out.npy
expect 3 'levels.pgm: largest sample value 31' match s/left.png levels.pgm -o out.npy
expect 3 'deep.pgm: 16 bits' match deep.pgm deep.pgm -o out.npy
expect 3 'typo.json: not a picture' match typo.json s/right.png -o out.npy
expect 3 'none.png: No such file' match none.png s/right.png -o out.npy
expect 3 's: Is a directory' match s s/right.png -o out.npy
expect 3 's/left.png is 96 x 48, other/right.png is 80 x 48' match s/left.png other/right.png -o out.npy

### outputs ###
expect 2 'out.bmp: a disparity map is written as' match s/left.png s/right.png -o out.bmp
expect 2 'out.png: a .png holds' match s/left.png s/right.png -o out.png --num-disparities 16 --min-disparity -16
expect 2 'look.jpg: is written as .png' "${m[@]}" --preview look.jpg
expect 3 'nowhere/out.npy: cannot be written' match s/left.png s/right.png -o nowhere/out.npy --num-disparities 16
mkdir d.npy
expect 3 'd.npy: cannot be written: it is a folder' match s/left.png s/right.png -o d.npy --num-disparities 16
expect 3 'nowhere/t.json: cannot be written' "${t[@]}" --json nowhere/t.json
expect 3 'nowhere/p.h: cannot be written' "${t[@]}" --header nowhere/p.h
expect 3 'nowhere/r.html: cannot be written' "${t[@]}" --report nowhere/r.html
expect 3 'nowhere/r.html: cannot be written' "${e[@]}" --report nowhere/r.html
expect 2 '--focal 0: must be a number' "${e[@]}" --focal 0
expect 3 'could not be written|cannot be written' match s/left.png s/right.png -o full.npy --num-disparities 16 --preview nowhere/p.png
if [ -e /dev/full ]; then
    # A device of its own for root: a tool that renames onto a device must not be able to hit the machine's.
    if [ "$(id -u)" = 0 ]; then mknod full.npy c 1 7 2>/dev/null; else ln -s /dev/full full.npy; fi
    if [ -c full.npy ] && (: >full.npy) 2>/dev/null; then
        expect 3 'full.npy: cannot be written|full: cannot be written' match s/left.png s/right.png -o full.npy --num-disparities 16
    else
        echo "SKIPPED: no device can be made here"
    fi
    rm -f full.npy
    "$stad" "${e[@]}" >/dev/full 2>/dev/null
    [ $? = 3 ] || { failures=$((failures + 1)); echo "FAILED: a full standard output is not noticed"; }
    checks=$((checks + 1))
fi

# A disk that fills up midway: the old file stays as it was.
cp disp.npy kept.npy
old=$(sha256sum <kept.npy)
(trap '' XFSZ; ulimit -f 4; exec "$stad" match s/left.png s/right.png -o kept.npy --num-disparities 16 --p1 1) 2>stderr.tmp
[ $? = 3 ] && grep -q 'kept.npy: cannot be written: File too large' stderr.tmp && [ "$old" = "$(sha256sum <kept.npy)" ] ||
    { failures=$((failures + 1)); echo "FAILED: a full disk: $(cat stderr.tmp)"; }
checks=$((checks + 1))
rm stderr.tmp

### an output that is an input, or another output ###
ln -s s/left.png link.png
ln s/left.png hard.png
ln -s fresh.npy to_fresh.npy
expect 2 's/left.png: is the input s/left.png' match s/left.png s/right.png -o s/left.png --num-disparities 16
expect 2 'link.png: is the input s/left.png' match s/left.png s/right.png -o link.png --num-disparities 16
expect 2 'hard.png: is the input s/left.png' match s/left.png s/right.png -o hard.png --num-disparities 16
expect 2 's/../s/right.png: is the input s/right.png' "${m[@]}" --preview s/../s/right.png
expect 2 'two.png and ./two.png: two outputs in one file' match s/left.png s/right.png -o two.png --num-disparities 16 --preview ./two.png
expect 2 'fresh.npy and to_fresh.npy: two outputs in one file' match s/left.png s/right.png -o fresh.npy --num-disparities 16 --right to_fresh.npy
echo '{"p1": 100}' >small_params.json
expect 2 'small_params.json: is the input' "${t[@]}" --params small_params.json --json small_params.json
expect 2 's/disp.pfm: is the input' "${t[@]}" --json s/disp.pfm
expect 2 'both and both: two outputs' "${t[@]}" --json both --header both
expect 2 'disp.npy: is the input' "${e[@]}" --report disp.npy
mkdir rec && cp s/left.png rec/0_left.png && cp s/right.png rec/0_right.png
expect 2 'rec/0_left.png: is the input rec/0_left.png' simulate rec --num-disparities 16 --csv rec/0_left.png
mkfifo both.npy
exec 9<>both.npy
accept match s/left.png s/right.png -o both.npy --num-disparities 16 --right both.npy
exec 9>&-
rm hard.png both.npy

### links, pipes, and a standard output that is closed ###
accept match s/left.png s/right.png -o to_fresh.npy --num-disparities 16
[ -L to_fresh.npy ] && cmp -s fresh.npy disp.npy || fail_check "a link to a new file is not written through"
accept match s/left.png s/right.png -o to_fresh.npy --num-disparities 16
[ -L to_fresh.npy ] && cmp -s fresh.npy disp.npy || fail_check "a link to a file is not written through"
ln -s loop_b.npy loop_a.npy
ln -s loop_a.npy loop_b.npy
expect 3 'loop_a.npy: cannot be written: Too many levels' match s/left.png s/right.png -o loop_a.npy --num-disparities 16
mkfifo pipe.npy
timeout 20 cat pipe.npy >piped.npy &
accept match s/left.png s/right.png -o pipe.npy --num-disparities 16
wait $!
[ -p pipe.npy ] && cmp -s piped.npy disp.npy || fail_check "a pipe is not written as it is"
rm pipe.npy piped.npy fresh.npy to_fresh.npy loop_a.npy loop_b.npy
"$stad" "${m[@]}" >&- 2>stderr.tmp
[ $? = 0 ] && cmp -s out.npy disp.npy || fail_check "nothing to print and a closed standard output: $(cat stderr.tmp)"
"$stad" "${e[@]}" >&- 2>stderr.tmp
[ $? = 3 ] && grep -q 'output could not be written' stderr.tmp || fail_check "a closed standard output loses what is printed: $(cat stderr.tmp)"
"$stad" "${t[@]}" --json closed.json >&- 2>stderr.tmp
[ $? = 3 ] && grep -q '^}' closed.json && ! grep -q 'ncg on' closed.json || fail_check "a closed standard output and a file"
rm -f out.npy closed.json stderr.tmp

### an end by a limit or a signal leaves nothing beside the output ###
(ulimit -f 4; exec "$stad" match s/left.png s/right.png -o big.npy --num-disparities 16) 2>stderr.tmp
[ $? = 3 ] && grep -q 'big.npy: cannot be written: File too large' stderr.tmp && ! ls big.npy* >/dev/null 2>&1 ||
    fail_check "a limit on the size of files: $(cat stderr.tmp)"
"$stad" scene -o large --width 2048 --height 1024 --num-disparities 16 >/dev/null &
child=$!
for _ in $(seq 500); do ls large/*.png.* >/dev/null 2>&1 && break; sleep 0.01; done
ls large/*.png.* >/dev/null 2>&1 || echo "note: no file was caught under way"
kill -TERM $child
wait $child 2>/dev/null
[ $? = 143 ] && ! ls large/*.* 2>/dev/null | grep -q 'png\.\|pfm\.' || fail_check "a signal: $(ls large)"
rm -rf large rec stderr.tmp

### truth ###
head -c 100 s/disp.pfm >cut.pfm
head -c 200 disp.npy >cut.npy
printf 'PF\n96 48\n-1\n' >three.pfm
printf 'PK\003\004 and no archive at all, nothing' >bad.npz
expect 3 'cut.pfm: bad .pfm' eval disp.npy cut.pfm --min-disparity 0 --num-disparities 16
expect 3 'cut.npy: bad .npy' eval cut.npy s/disp.pfm --min-disparity 0 --num-disparities 16
expect 3 'three.pfm: a PFM of three channels' eval disp.npy three.pfm --min-disparity 0 --num-disparities 16
expect 3 'bad.npz: bad .npz' eval disp.npy bad.npz --min-disparity 0 --num-disparities 16
expect 2 's/left.png: truth of 8 bits; say with --truth-scale' eval disp.npy s/left.png --min-disparity 0 --num-disparities 16
expect 2 'is 96 x 48, the truth 80 x 48' eval disp.npy other/disp.pfm --min-disparity 0 --num-disparities 16
expect 3 'other/nonocc.png: the mask is 80 x 48' "${e[@]}" --mask other/nonocc.png
expect 2 'no pixel can be scored' eval disp.npy s/disp.pfm --min-disparity 0 --num-disparities 96
expect 2 'other/disp.pfm is 80 x 48' tune s/left.png s/right.png --truth other/disp.pfm --num-disparities 16

accept scene -o far --width 96 --height 48 --num-disparities 48 --plates 3
"$stad" tune far/left.png far/right.png --truth far/disp.pfm --num-disparities 16 --max-evals 1 >stdout.tmp 2>stderr.tmp
[ $? = 0 ] && grep -q 'far/left.png: [0-9.]* % of its truth lies outside the disparities searched, 0 .. 15' stderr.tmp ||
    fail_check "truth out of range: $(cat stderr.tmp)"
"$stad" "${t[@]}" >stdout.tmp 2>stderr.tmp && [ ! -s stderr.tmp ] || fail_check "truth within the range: $(cat stderr.tmp)"
rm stdout.tmp stderr.tmp

### lists of scenes ###
echo '[{"left": "s/left.png", "right": "s/right.png"}]' >no_truth.json
echo '[{"left": "s/left.png", "right": "s/right.png", "truth": "s/none.pfm"}]' >gone.json
echo '[]' >empty.json
expect 3 'no_truth.json: scene 0 has no file name "truth"' tune --scenes no_truth.json
expect 3 's/none.pfm: No such file' tune --scenes gone.json
echo '[{"left": "s/left.png", "right": "s/right.png", "truth": "s/disp.pfm"}], []' >more.json
expect 3 'more.json: no JSON' tune --scenes more.json
expect 3 'empty.json: not a JSON array' tune --scenes empty.json
expect 2 'scenes alone' tune s/left.png s/right.png --scenes gone.json

### the target as truth ###
accept scene -o q --target --frames 4 --width 320 --height 240
f=(tune q/003_left.png q/003_right.png --fiducials --max-evals 2)
accept "${f[@]}" --focal 192 --num-disparities 64
expect 2 'target is out of range: its marks have disparities [0-9.]+ .. [0-9.]+ px, .* searches 0 .. 15$' "${f[@]}" --focal 192 --num-disparities 16
expect 2 'out of range: .* searches 60 .. 123$' "${f[@]}" --focal 192 --num-disparities 64 --min-disparity 60
expect 2 'out of range: .* searches -100 .. -37$' "${f[@]}" --focal 192 --num-disparities 64 --min-disparity -100
expect 2 'out of range: .* searches -300 .. -237$' "${f[@]}" --focal 192 --num-disparities 64 --min-disparity -300
expect 2 'at disparities -3.* px: left and right are exchanged, or --min-disparity 0 must be lower$' tune q/003_right.png q/003_left.png --fiducials --focal 192 --num-disparities 64
expect 2 'too little of the target is in the columns .* from 288 on' "${f[@]}" --focal 192 --num-disparities 288
for focal in 60 100 400 1000; do
    expect 2 "with --focal $focal and the principal point .* no rectangular sheet" "${f[@]}" --focal $focal --num-disparities 64
done
expect 2 'the principal point 0,0 the marks make no rectangular sheet' "${f[@]}" --focal 192 --center 0,0 --num-disparities 64

### options that do nothing ###
expect 2 '--calibrate-at has no effect without --focal' simulate q --num-disparities 64 --calibrate-at 1
expect 2 '--baseline has no effect without --focal' simulate q --num-disparities 64 --baseline 0.1
expect 2 '--baseline has no effect without --report' simulate q --num-disparities 64 --focal 192 --baseline 0.1
expect 2 '--center has no effect without --focal' simulate q --num-disparities 64 --center 1,1
expect 2 '--budget has no effect without --focal' simulate q --num-disparities 64 --budget 9
expect 2 '--calibrate-at 4: the frames are 0..3' simulate q --num-disparities 64 --focal 192 --calibrate-at 4
expect 2 '--calibrate-at 3: the frames are 0..1' simulate q --num-disparities 64 --focal 192 --calibrate-at 3 --frames 2
expect 2 '--from 999: the frames are 0..3' simulate q --num-disparities 64 --noise 5 --from 999
expect 2 '--from has no effect without --noise' simulate q --num-disparities 64 --from 2
expect 2 '--side-by-side: q/000_left.png and q/000_right.png are a view each' simulate q --num-disparities 64 --side-by-side
expect 2 '--frames has no effect without --target' scene -o new --frames 2
expect 2 '--share has no effect without --target' scene -o new --share 60
expect 2 '--drift has no effect without --target' scene -o new --drift 1
expect 2 '--pgm has no effect without --target' scene -o new --pgm
expect 2 '--from has no effect without --target' scene -o new --from 1
expect 2 '--from has no effect without --drift' scene -o new --target --from 1
expect 2 '--from 9: the recording has frames 0..0' scene -o new --target --frames 1 --drift 1 --from 9
expect 2 '--plates has no effect with --target' scene -o new --target --plates 3
expect 2 '--min-disparity does not go with --target' scene -o new --target --min-disparity 1
expect 2 '--gain does not go with --target' scene -o new --target --gain 100
expect 2 '--center has no effect without --fiducials' "${t[@]}" --center 1,1
expect 2 '--focal has no effect without --fiducials' "${t[@]}" --focal 100
expect 2 '--baseline has no effect without --report' "${t[@]}" --focal 100 --baseline 1
expect 2 '--truth has no effect with --scenes' tune --scenes gone.json --truth s/disp.pfm
expect 2 '--truth-scale has no effect with' "${f[@]}" --focal 192 --truth-scale 2

### a folder that holds another scene ###
expect 3 'q: holds 00[0-9]_[a-z]+.(png|pfm) of another scene' scene -o q --target --frames 2 --width 160 --height 120
expect 3 'q: holds 00[0-9]_[a-z]+.(png|pfm) of another scene' scene -o q --width 96 --height 48
expect 3 'q: holds 00[0-9]_(left|right).png of another scene' scene -o q --target --frames 4 --width 160 --height 120 --pgm
expect 3 's: holds [a-z]+.(png|pfm) of another scene' scene -o s --target --frames 2 --width 160 --height 120
accept scene -o q --target --frames 5 --width 160 --height 120
expect 3 'disp.npy: cannot be' scene -o disp.npy --target

echo '{}' >nothing.json
expect 3 'nothing.json: there is no parameter in it' "${m[@]}" --params nothing.json
echo '{"params": {}}' >nothing.json
expect 3 'nothing.json: there is no parameter in it' "${m[@]}" --params nothing.json

### the sheet ###
expect 2 '--isa avx9: must be' bench --isa avx9
STAD_ISA=avx9 expect 2 'STAD_ISA avx9: must be' bench
STAD_ISA='' accept bench --width 64 --height 32 --frames 1 # empty is unset
expect 2 'sheet.txt: the suffix must be' sheet -o sheet.txt
expect 2 '--paper a44' sheet -o sheet.pdf --paper a44
expect 3 'nowhere/sheet.pdf: cannot be written' sheet -o nowhere/sheet.pdf
expect 3 'nowhere/sheet-1.svg: cannot be written' sheet -o nowhere/sheet.svg
accept sheet -o sheet.PDF --paper A4
accept sheet -o sheet.Svg --paper Letter
[ -s sheet-1.svg ] && cp sheet.PDF kept.pdf || fail_check "a suffix in capitals"
(ulimit -f 4; exec "$stad" sheet -o sheet.PDF --paper letter) 2>stderr.tmp
[ $? = 3 ] && grep -q 'sheet.PDF: cannot be written: File too large' stderr.tmp && cmp -s sheet.PDF kept.pdf ||
    fail_check "a full disk and the sheet: $(cat stderr.tmp)"
(ulimit -f 4; exec "$stad" sheet -o sheet.svg) 2>stderr.tmp
[ $? = 3 ] && grep -q 'sheet-1.svg: cannot be written: File too large' stderr.tmp || fail_check "a full disk and SVG: $(cat stderr.tmp)"
rm stderr.tmp

### the story asks for its folder first ###
if [ -x "$STAD_BUILD/stad-story" ]; then
    "$STAD_BUILD/stad-story" -o nowhere/x >stdout.tmp 2>stderr.tmp
    [ $? = 3 ] && [ ! -s stdout.tmp ] && grep -q 'nowhere/x/summary.json: cannot be written' stderr.tmp || fail_check "the story: $(cat stderr.tmp)"
    "$STAD_BUILD/stad-story" --help | grep -q '^usage: stad-story' || fail_check "the story's help"
    "$STAD_BUILD/stad-story" -x here >stdout.tmp 2>stderr.tmp
    [ $? = 2 ] && grep -q '^usage: stad-story' stderr.tmp || fail_check "an option that the story has not: $(cat stderr.tmp)"
    rm stdout.tmp stderr.tmp
fi

leftovers=$(find . -name '*.npy.*' -o -name '*.json.*' -o -name '*.png.*')
[ -z "$leftovers" ] || { failures=$((failures + 1)); echo "FAILED: left behind: $leftovers"; }
echo "$checks checks, $failures failed"
[ $failures = 0 ]
