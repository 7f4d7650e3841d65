#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures the fiducial marks, the truth and the rig's correction; prints every figure of docs/CALIBRATION.md
and docs/studies/CORNERS.md.

    tools/study/marks/run [SECTION ...] [--data DIR] [--frames N]

Sections: size detect clutter images time truth rig chessboard. Without any: all. Frames are rendered with fixed seeds; `images`, `rig`
and `chessboard` read the open scenes of DIR (MANIFEST.json) and are skipped without it. The comparison is libapriltag with full
resolution, one thread and the same 2 bits of correction; corners on real pictures: agree.py."""
import argparse
import ctypes as C
import glob
import json
import math
import os
import subprocess
import sys
import tempfile

import cv2
import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))
from data_folder import entries  # noqa: E402

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..', '..'))


def build():
    sources = [f for m in ('base', 'mark', 'truth', 'rig') for f in sorted(glob.glob(f'{ROOT}/lib/src/{m}/*.c'))]
    sources += sorted(glob.glob(f'{ROOT}/tools/scene/target_*.c')) + [f'{ROOT}/tools/study/marks/shim.c']
    out = os.path.join(tempfile.mkdtemp(), 'shim.so')
    subprocess.check_call(['cc', '-std=gnu99', '-O2', '-shared', '-fPIC', f'-I{ROOT}/lib/include', f'-I{ROOT}/lib/src',
                           f'-I{ROOT}/tools', *sources, '-o', out, '-lapriltag', '-lm'])
    return C.CDLL(out)


class Scene(C.Structure):
    _fields_ = [(n, C.c_int32) for n in 'width height relief room seed supersample'.split()] + \
               [(n, C.c_double) for n in 'f baseline psf dy roll scale x y z pitch yaw turn'.split()]


class Rig(C.Structure):
    _fields_ = [('a', C.c_int32), ('b', C.c_int32), ('c', C.c_int32), ('w', C.c_int16), ('h', C.c_int16)]


def ptr(a):
    return a.ctypes.data_as(C.c_void_p)


def scene(**kw):
    s = Scene(width=320, height=240, relief=0, room=0, seed=1, supersample=4, f=352, baseline=60, psf=.8, z=528)
    for k, v in kw.items():
        setattr(s, k, v)
    return s


def render(s):
    shape = (s.height, s.width)
    left, right, d = (np.zeros(shape, np.float32) for _ in range(3))
    label, which = np.zeros(shape, np.uint8), np.zeros(shape, np.uint8)
    corners = np.zeros((4, 4, 4))
    LIB.study_render(C.byref(s), None, ptr(left), ptr(right), ptr(d), ptr(label), ptr(which), None, ptr(corners))
    return left, right, d, label, which, corners


def expose(grey, noise, seed, black=30, white=220):
    grey, out = grey.copy(), np.zeros(grey.shape, np.uint8)
    LIB.study_expose(ptr(grey), grey.size, C.c_double(black), C.c_double(white), C.c_double(noise), seed, ptr(out))
    return out


def find(image, reference=False, refined=True, decimate=1, sigma=0):
    rows, image = np.zeros((64, 10)), np.array(image, order='C')  # a copy: libapriltag blurs in place
    call = LIB.study_find_reference if reference else LIB.study_find
    LIB.study_reference_settings(refined, C.c_double(decimate), C.c_double(sigma))
    count = call(ptr(image), image.shape[1], image.shape[0], ptr(rows), 64)
    return {int(r[0]): r[2:].reshape(4, 2) for r in rows[:max(count, 0)]}


# ---------------------------------------------------------------------------------------------------------------------------


def size():
    for w, h in ((320, 240), (640, 480)):
        print(f'size    {w}x{h}: workspace {LIB.study_bytes(w, h)} bytes')


def visible(corners, w, h, edge):
    x, y = corners[..., 0::2], corners[..., 1::2]
    return x.min() > edge and x.max() < w - 1 - edge and y.min() > edge and y.max() < h - 1 - edge


def detect_cell(side, noise, psf, frames):
    wide = side > 40
    w, h, f = (640, 480, 704) if wide else (320, 240, 352)
    rng = np.random.default_rng(side * 100 + noise)
    sums = {k: dict(found=0, views=0, off=[], p95=[], wrong=0) for k in ('ours', 'libapriltag')}
    done = 0
    while done < frames:
        s = scene(width=w, height=h, f=f, z=f * 48 / side, psf=psf, pitch=rng.uniform(-.5, .5), yaw=rng.uniform(-.5, .5),
                  turn=rng.uniform(-.35, .35), x=rng.uniform(10, 50), y=rng.uniform(-10, 10), seed=done + 1)
        left, right, d, _, which, corners = render(s)
        if not visible(corners, w, h, 1.25 * side / 8 + 2):
            continue
        done += 1
        views = expose(left, noise, 2 * done + 7), expose(right, noise, 2 * done + 8)
        for name, m in sums.items():
            marks = [find(v, name != 'ours') for v in views]
            m['views'] += 8
            m['wrong'] += sum(t not in range(4) for found in marks for t in found)
            m['found'] += sum(t in found for found in marks for t in range(4))
            points = []
            for t in range(4):
                if t in marks[0] and t in marks[1]:
                    measured = marks[0][t][:, 0] - marks[1][t][:, 0]
                    m['off'] += list(measured - (corners[t, :, 0] - corners[t, :, 2]))
                    points += [(*marks[0][t][k], measured[k]) for k in range(4)]
            if len(points) == 16:
                p = np.array(points)
                a = np.linalg.lstsq(np.c_[p[:, :2], np.ones(16)], p[:, 2], rcond=None)[0]
                y, x = np.nonzero(which)
                m['p95'].append(np.percentile(abs(a[0] * x + a[1] * y + a[2] - d[y, x]), 95) * 16)
    text = ' | '.join(f"{k} found {100 * m['found'] / m['views']:5.1f} % rms {np.sqrt(np.mean(np.square(m['off'] or [np.nan]))):.3f} "
                      f"p95 {np.mean(m['p95'] or [np.nan]):.2f}/16 wrong {m['wrong']}" for k, m in sums.items())
    print(f'detect  side {side:2d} noise {noise} psf {psf}: {text}  ({frames} frames)', flush=True)


def detect():
    for noise, psf in ((3, .8), (6, 1.2)):
        for side in (16, 24, 32, 48):
            detect_cell(side, noise, psf, ARGS.frames if side <= 40 else max(ARGS.frames // 3, 1))


def clutter():
    """Rooms, and on them squares with a black border and random cells: what looks most like a mark and is none."""
    found = frames = 0
    rng = np.random.default_rng(77)
    for i in range(500):
        if i % 10 == 0:
            left, right, *_ = render(scene(relief=-1, room=40, seed=i + 1, supersample=2))
        image = (left if i % 2 else right).copy()
        for _ in range(8):
            cells = rng.integers(0, 2, (10, 10)).astype(np.float32) * 255
            cells[1:9, 1:9][[0, -1]] = 0
            cells[1:9, 1:9][:, [0, -1]] = 0
            cells[[0, -1]] = cells[:, [0, -1]] = 255
            angle, side = rng.uniform(0, 2 * math.pi), rng.uniform(2.5, 6)
            c, s = side * math.cos(angle), side * math.sin(angle)
            to = np.float32([[c, -s, rng.uniform(0, 320)], [s, c, rng.uniform(0, 240)]])
            patch = cv2.warpAffine(cells, to, (320, 240), flags=cv2.INTER_NEAREST)
            cover = cv2.warpAffine(np.ones_like(cells), to, (320, 240), flags=cv2.INTER_NEAREST)
            image = np.where(cover > 0, patch, image)
        image = cv2.GaussianBlur(image, (0, 0), .8)
        marks = find(expose(image, 3, i))
        frames, found = frames + 1, found + len(marks)
    print(f'clutter {found} marks in {frames} frames')


def images():
    files = sorted(glob.glob(f'{ARGS.data}/**/*.p[ngp][gm]', recursive=True))
    if not files:
        return print('images  SKIPPED: no data')
    looked = found = 0
    for name in files:
        image = cv2.imread(name, cv2.IMREAD_GRAYSCALE)
        if image is None or max(image.shape) > 2048 or min(image.shape) < 16:
            continue
        looked, found = looked + 1, found + len(find(image))
    print(f'images  {found} marks in {looked} images of the open scenes')


def time():
    for w, h in ((320, 240), (640, 480)):
        frames = []
        for i in range(8):
            s = scene(width=w, height=h, f=1.1 * w, z=500, relief=1, room=14, seed=i + 1, pitch=.4, turn=.08 * i - .3)
            frames.append(expose(render(s)[i % 2], 3, i))
        stack, ours, theirs = np.array(frames), C.c_double(), C.c_double()
        LIB.study_time(ptr(stack), len(frames), w, h, 20, C.byref(ours), C.byref(theirs))
        print(f'time    {w}x{h}: {1e3 * ours.value:.3f} ms, libapriltag {1e3 * theirs.value:.3f} ms, '
              f'ratio {ours.value / theirs.value:.3f}')


def truth():
    for relief, name in ((0, 'flat board'), (1, 'relief')):
        rng = np.random.default_rng(5 + relief)
        p95, mean, tables, done = [], [], np.zeros((3, 3), int), 0
        while done < ARGS.frames // 2:
            s = scene(relief=relief, room=10, seed=done + 1, pitch=rng.uniform(.2, .7), yaw=rng.uniform(-.25, .25),
                      turn=rng.uniform(-.3, .3), x=rng.uniform(0, 50), y=rng.uniform(-15, 15), z=rng.uniform(430, 560))
            left, right, d, label, which, corners = render(s)
            if not visible(corners, 320, 240, 8):
                continue
            done += 1
            a, b = expose(left, 3, done * 2), expose(right, 3, done * 2 + 1)
            got, mine = np.zeros(a.shape), np.zeros(a.shape, np.uint8)
            status = LIB.study_truth(ptr(a), ptr(b), C.byref(s), 64, 1, ptr(got), ptr(mine))
            if status < 0:
                print(f'truth   {name} frame {done}: status {status}')
                continue
            off = abs(got - d)[mine > 0]
            p95.append(np.percentile(off, 95) * 16)
            mean.append(off.mean() * 16)
            area = which.astype(bool) & (np.arange(320) >= 64)[None]
            for i in range(3):
                for k in range(3):
                    tables[i, k] += ((mine == i) & (label == k) & area).sum()
        print(f'truth   {name}: over {len(p95)} frames mean {np.mean(mean):.2f}/16, p95 mean {np.mean(p95):.2f}/16, '
              f'worst frame {max(p95):.2f}/16 px; of the seen pixels {100 * tables[1, 1] / tables[:, 1].sum():.0f} % scored, '
              f'hidden taken for seen {tables[1, 2]}, seen taken for hidden {tables[2, 1]} of {tables[1:].sum()}', flush=True)


# -- rig --------------------------------------------------------------------------------------------------------------------


REDUCE = 1.5  # a drift acts where the camera samples: in the full-size scene, before it is reduced


def camera_view(image, dy=0, roll=0, scale=0):
    """The scene at 1 / REDUCE, 3 x 3 samples a pixel, as the drifted camera sees it."""
    h, w = (int(n / REDUCE) for n in image.shape)
    total = np.zeros((h, w), np.float32)
    for i in range(9):
        y, x = np.mgrid[0:h, 0:w].astype(np.float64)
        dx = x + (i % 3 - 1) / 3 - (w - 1) / 2
        ddy = y + (i // 3 - 1) / 3 - (h - 1) / 2 - dy
        ix = (w - 1) / 2 + (math.cos(roll) * dx + math.sin(roll) * ddy) / (1 + scale)
        iy = (h - 1) / 2 + (-math.sin(roll) * dx + math.cos(roll) * ddy) / (1 + scale)
        to = (((v + .5) * REDUCE - .5).astype(np.float32) for v in (ix, iy))
        total += cv2.remap(image.astype(np.float32), *to, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    return (total / 9 + .5).clip(0, 255).astype(np.uint8)


def open_scenes():
    """Left view, full-size right view, truth at 1 / REDUCE, disparities."""
    out = []
    for m in entries(ARGS.data):
        if not m['dataset'].startswith('middlebury') or m['split'] != 'open' or m['W'] > 900:
            continue
        folder = f"{ARGS.data}/{m['path']}/"
        left, right = (cv2.imread(folder + f'{v}.png', cv2.IMREAD_GRAYSCALE) for v in ('left', 'right'))
        gt = cv2.imread(folder + m['gt_file'], cv2.IMREAD_UNCHANGED).astype(np.float32) / m['gt_scale'] / REDUCE
        gt[gt == 0] = np.nan
        left = camera_view(left)
        y, x = (np.round((np.arange(n) + .5) * REDUCE - .5).astype(int) for n in left.shape)
        out.append((left, right, gt[np.ix_(y, x)], -(-int(m['numDisparities'] / REDUCE) // 16) * 16))
    return out


def bad(left, right, gt, disparities):
    """Bad-or-missing percent at 1 px."""
    m = cv2.StereoSGBM_create(0, disparities, 5, 200, 800, 1, 31, 10, 0, 0, 0).compute(left, right).astype(np.float32) / 16
    known = ~np.isnan(gt)
    known[:, :disparities] = False
    return 100 * ((m < 0) | (abs(m - gt) > 1))[known].mean()


def measured_rig(w, h, dy, roll, scale, seed):
    """The fit to three rendered poses of the relief, noise 3, seen by the same drifted camera."""
    rng, views = np.random.default_rng(seed), []
    for i in range(3):
        s = scene(width=w, height=h, f=1.1 * w, z=480, relief=1, pitch=rng.uniform(.2, .6), yaw=rng.uniform(-.2, .2),
                  turn=rng.uniform(-.2, .2), x=(0, -60, 70)[i], y=(0, 40, -40)[i], dy=dy, roll=roll, scale=scale, seed=i)
        left, right, *_ = render(s)
        views.append((expose(left, 3, seed * 10 + i), expose(right, 3, seed * 10 + 5 + i)))
    left, right = (np.array([v[k] for v in views]) for k in (0, 1))
    rig, numbers = Rig(), np.zeros(8)
    LIB.study_rig(ptr(left), ptr(right), 3, w, h, C.byref(rig), ptr(numbers))
    return rig, numbers


def rig():
    if not os.path.exists(f'{ARGS.data}/MANIFEST.json'):
        return print('rig     SKIPPED: no data')
    scenes = open_scenes()
    base = np.mean([bad(left, camera_view(right), gt, n) for left, right, gt, n in scenes])
    print(f'rig     none: {base:.2f} % bad or missing over {len(scenes)} open scenes')
    total = np.zeros(2)
    for name, dy, roll, scale in (('dy 0.5', .5, 0, 0), ('dy 1', 1, 0, 0), ('dy 2', 2, 0, 0), ('dy 4', 4, 0, 0),
                                  ('roll 0.3', 0, .3, 0), ('roll 0.5', 0, .5, 0), ('roll 1', 0, 1, 0),
                                  ('scale 0.2 %', 0, 0, .002), ('scale 0.4 %', 0, 0, .004)):
        before, after, reports, fits = [], [], [], {}
        for k, (left, right, gt, disparities) in enumerate(scenes):
            h, w = left.shape
            moved = camera_view(right, dy, math.radians(roll), scale)
            if (w, h) not in fits:
                fits[w, h] = measured_rig(w, h, dy, math.radians(roll), scale, k + 1)
            correction, numbers = fits[w, h]
            out = np.zeros_like(moved)
            status = LIB.study_correct(C.byref(correction), ptr(moved), w, h, ptr(out))
            assert status >= 0, status
            before.append(bad(left, moved, gt, disparities))
            after.append(bad(left, out, gt, disparities))
            reports.append(numbers)
        total += np.array([np.mean(before) - base, np.mean(after) - base])
        lost, kept, r = np.mean(before), np.mean(after), np.mean(reports, axis=0)
        print(f'rig     {name}: {lost:.2f} % -> corrected {kept:.2f} %, recovers {100 * (lost - kept) / (lost - base):.1f} % '
              f'of the loss (rms dy {r[4]:.3f} -> {r[5]:.3f} px, worst {r[6]:.2f} px, verdicts '
              f'{sorted(set(int(n[0]) for n in reports))})', flush=True)
    print(f'rig     all of these: recovers {100 * (1 - total[1] / total[0]):.1f} % of the loss')


def board_corners(image):
    found, corners = cv2.findChessboardCorners(image, (9, 6))
    assert found
    stop = (cv2.TERM_CRITERIA_EPS | cv2.TERM_CRITERIA_MAX_ITER, 40, .001)
    return cv2.cornerSubPix(image, corners, (5, 5), (-1, -1), stop).reshape(-1, 2)


def chessboard():
    """Real pairs: the corners of a printed board, four at a time in place of marks; its plane against what SGBM finds."""
    folder = f'{ARGS.data}/fiducial/chessboard'
    if not os.path.exists(f'{folder}/meta.json'):
        return print('board   SKIPPED: no data')
    for pair in json.load(open(f'{folder}/meta.json'))['pairs']:
        left, right = (cv2.imread(f"{folder}/{pair['id']:02d}_{v}.png", cv2.IMREAD_GRAYSCALE) for v in ('left', 'right'))
        if left is None or right is None:
            continue
        corners = np.c_[board_corners(left), board_corners(right)].astype(float)
        outline = corners[[0, 8, 53, 45], :2].copy()
        h, w = left.shape
        numbers, truth_px, label = np.zeros(5), np.zeros((h, w)), np.zeros((h, w), np.uint8)
        d = corners[:, 0] - corners[:, 2]
        low = int(d.min()) - 24
        span = -(-(int(d.max()) + 24 - low) // 16) * 16
        if not LIB.study_board(ptr(corners), len(corners), ptr(outline), 4, w, h, low, span, ptr(numbers),
                               ptr(truth_px), ptr(label)):
            print(f"board   {pair['id']}: refused, status {int(numbers[0])}, rms {numbers[1]:.3f} px")
            continue
        m = cv2.StereoSGBM_create(low, span, 5, 200, 800, 1, 31, 10, 0, 0, 0).compute(left, right).astype(float) / 16
        seen = (label == 1) & (m >= low)
        print(f"board   {pair['id']}: plane rms {numbers[1]:.3f} px, verdict {int(numbers[2])} (worst dy {numbers[3]:.2f}, rms "
              f'{numbers[4]:.2f} px); {(label == 1).sum()} px of truth, SGBM off by {np.median((m - truth_px)[seen]):+.3f} px '
              f'median, {100 * ((m < low) | (abs(m - truth_px) > 1))[label == 1].mean():.1f} % bad')


SECTIONS = dict(size=size, detect=detect, clutter=clutter, images=images, time=time, truth=truth, rig=rig, chessboard=chessboard)

if __name__ == '__main__':
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('section', nargs='*', choices=[[], *SECTIONS])
    parser.add_argument('--data', default=os.environ.get('STAD_DATA', ''))
    parser.add_argument('--frames', type=int, default=150)
    ARGS = parser.parse_args()
    if ARGS.frames < 1:
        parser.error(f'--frames {ARGS.frames}: at least 1')
    LIB = build()
    for wanted in ARGS.section or SECTIONS:
        SECTIONS[wanted]()
