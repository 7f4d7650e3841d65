#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tunes the matcher on some real chessboard pairs and measures it on the others, then the other way round.

    STAD_DATA=<folder of open scenes> tools/study/marks/run tune [--range all|board] [--budget N]

The truth is one plane a pair from the board's corners (stad_plane_fit, stad_truth_add_plane), within the outline of the inner
corners alone. Matcher, score and search are the library's, through its Python package: MODE_SGBM, ncg with the start ladder for
`bad`, from the sample's parameters, block 3 or more; the cost is the mean over the pairs of the bad-or-missing share at 1 px.
--range all: 208 disparities from 0 for every pair, as a rig would have that does not know where the board is; board: from 24 px
below to 24 px above the board's own. At the end both results meet the open natural scenes."""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import cv2
import numpy as np

import figures

SAMPLE = dict(p1=72, p2=288, block_size=3, uniqueness_ratio=10, pre_filter_cap=63, disp12_max_diff=1)


def load_package():
    """The Python package over a fresh build of the library."""
    folder = tempfile.mkdtemp()
    for command in (['cmake', '-S', f'{figures.ROOT}/tools/python', '-B', folder], ['cmake', '--build', folder]):
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    os.environ['STADIMETER_LIBRARY'] = f'{folder}/libstadimeter_native.so'
    sys.path.insert(0, f'{figures.ROOT}/tools/python/src')
    import stadimeter
    return stadimeter


class Board:
    """One pair, its truth, and the costs of the points tried so far."""

    def __init__(self, folder, pair):
        self.id, self.known = pair['id'], {}
        self.left, self.right = (cv2.imread(f'{folder}/{self.id:02d}_{v}.png', cv2.IMREAD_GRAYSCALE) for v in ('left', 'right'))
        corners, d = np.array(pair['corners_left']), np.array(pair['disparity'])
        rows = np.c_[corners, corners[:, 0] - d, corners[:, 1]].astype(float)
        self.low, self.span = 0, 208
        if ARGS.range == 'board':
            self.low = int(d.min()) - 24
            self.span = -(-(int(d.max()) + 24 - self.low) // 16) * 16
        h, w = self.left.shape
        numbers, truth, self.label = np.zeros(5), np.zeros((h, w)), np.zeros((h, w), np.uint8)
        outline = rows[[0, 8, 53, 45], :2].copy()
        if not LIB.study_board(figures.ptr(rows), len(rows), figures.ptr(outline), 4, w, h, self.low, self.span,
                               figures.ptr(numbers), figures.ptr(truth), figures.ptr(self.label)):
            sys.exit(f'board {self.id}: plane refused, status {int(numbers[0])}')
        self.truth = np.rint(truth * 65536).astype(np.int32)
        self.rms = numbers[1]

    def bad_q20(self, point):
        key = tuple(point.values())
        if key not in self.known:
            found = stadimeter.StereoSGBM_create(self.low, self.span, **stadimeter.as_opencv(point)).compute(self.left, self.right)
            scorer = stadimeter.Scorer(self.span, self.low)
            scorer.add(found, self.truth, self.label)
            self.known[key] = scorer.cost_q20()
        return self.known[key]

    def bad(self, point):
        return 100 * self.bad_q20(point) / 2**20


def mean(boards, point):
    return np.mean([b.bad(point) for b in boards])


def tuned(boards):
    search = stadimeter.Tuner(SAMPLE, budget=ARGS.budget, limits={'block_size': (3, 11)})
    while (point := search.ask()) is not None:
        search.tell_q20(round(sum(b.bad_q20(point) for b in boards) / len(boards)))
    return search.best()[0], search.counts()['evaluations']


def show(train, test):
    point, evaluations = tuned(train)
    print(f"tune    on {[b.id for b in train]}, {evaluations} evaluations: {' '.join(f'{k} {v}' for k, v in point.items())}")
    for name, boards in (('tuned on', train), ('unseen  ', test)):
        for b in boards:
            print(f'tune      {name} board {b.id:2d}: {b.bad(SAMPLE):5.2f} -> {b.bad(point):5.2f} % bad')
        print(f'tune      {name} mean    : {mean(boards, SAMPLE):5.2f} -> {mean(boards, point):5.2f} % bad', flush=True)
    return point


def natural_bad(point):
    """Percent at 1 px over the open scenes with dense truth: what a board's parameters are worth elsewhere."""
    out = []
    for m in figures.entries(ARGS.data):
        if not m['dataset'].startswith('middlebury') or m['split'] != 'open' or m['W'] > 900:
            continue
        folder = f"{ARGS.data}/{m['path']}/"
        left, right = (cv2.imread(folder + f'{v}.png', cv2.IMREAD_GRAYSCALE) for v in ('left', 'right'))
        truth = cv2.imread(folder + m['gt_file'], cv2.IMREAD_UNCHANGED).astype(np.float32) / m['gt_scale']
        truth[truth == 0] = np.nan
        span = -(-int(m['numDisparities']) // 16) * 16
        scorer = stadimeter.Scorer(span)
        scorer.add(stadimeter.StereoSGBM_create(0, span, **stadimeter.as_opencv(point)).compute(left, right), truth)
        out.append(100 * scorer.cost())
    return np.array(out)


def main():
    folder = f'{ARGS.data}/fiducial/chessboard'
    if not os.path.exists(f'{folder}/meta.json'):
        return print('tune    SKIPPED: no data')
    boards = [Board(folder, pair) for pair in json.load(open(f'{folder}/meta.json'))['pairs']]
    for b in boards:
        print(f'tune    board {b.id:2d}: plane rms {b.rms:.3f} px, {(b.label == 1).sum()} px of truth, disparities {b.low} .. '
              f'{b.low + b.span - 1}')
    points = [show(boards[:3], boards[3:]), show(boards[3:], boards[:3])]
    if not os.path.exists(f'{ARGS.data}/MANIFEST.json'):
        return print('tune    natural scenes SKIPPED: no MANIFEST.json')
    before = natural_bad(SAMPLE)
    for point in points:
        after = natural_bad(point)
        print(f'tune    natural scenes with {list(point.values())}: mean {before.mean():.2f} -> {after.mean():.2f} % bad, worse in '
              f'{(after > before).sum()} of {len(before)}')


if __name__ == '__main__':
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--data', default=os.environ.get('STAD_DATA', ''))
    parser.add_argument('--range', choices=('all', 'board'), default='all')
    parser.add_argument('--budget', type=int, default=60)
    ARGS = parser.parse_args()
    if not 2 <= ARGS.budget <= 200:
        parser.error(f'--budget {ARGS.budget}: must be 2..200')
    LIB, stadimeter = figures.build(), load_package()
    main()
