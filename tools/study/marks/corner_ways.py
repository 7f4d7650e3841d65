#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Other ways to refine a mark's corners, beside libapriltag's: on real pictures against it, on rendered frames against the truth.

    tools/study/marks/run corners [--frames N]

The first way is that of lib/src/mark/mark_edge.c written once more in floating point; each other one changes it in what its name says.
Every way starts from the detector's own corners. Before the table: the way of libapriltag 3.3.0 written once more, from its own unrefined
corners, and the same with pixels interpolated."""
import argparse
import os

import agree
import cv2
import figures
import numpy as np
from agree import PICTURES, cell, far, rendered

# Normals a side at most, part of a side left out at its ends, px looked at on each side, px between samples, px from a sample to each of
# the two whose difference is its gradient, power of the gradient that weighs, passes, px by which a later pass is narrower; then: points
# farther from the line than so many rms left out, points weighted by their gradients, px of blur, rows summed along the edge; the point of
# equal areas under the profile instead of the gradient's centre, the edges of the code's outer white cells moved out by a cell, a parabola
# instead of a line, rounds of Huber's weights with a knee at one median distance, the nearest pixel instead of
# interpolation, normals where libapriltag has them.
NOW = dict(normals=64, skip=1 / 16, reach=2, step=.5, half=.5, power=2, passes=2, narrower=.5, trim=0, weighted=0, blur=0, rows=1,
           area=0, inner=0, bow=0, huber=0, nearest=0, theirs=0)
THEIRS = dict(theirs=1, step=.25, half=1, passes=1, narrower=0)
WAYS = {
    'as it is': {},
    'no ends left out': dict(skip=0),
    'eighths left out': dict(skip=1 / 8),
    'reach 1.5': dict(reach=1.5),
    'reach 3': dict(reach=3, narrower=0),
    'quarter-px samples': dict(step=.25, half=.25),
    'gradient over 2 px': dict(half=1),
    'power 1': dict(power=1),
    'power 3': dict(power=3),
    '128 normals': dict(normals=128),
    'four passes': dict(passes=4),
    'outliers left out': dict(trim=2),
    'Huber weights': dict(huber=5),
    'weighted points': dict(weighted=1),
    'blurred first': dict(blur=.7),
    'three rows summed': dict(rows=3),
    'equal areas': dict(area=1, reach=2.5),
    'inner edges too': dict(inner=1),
    'parabolas': dict(bow=1),
    'as libapriltag, interpolated': THEIRS,
    'as libapriltag': dict(THEIRS, nearest=1),
}


def offsets(image, base, normal, way, narrower):
    """How far along the normal from each base point the edge is, and its weight."""
    t = np.arange(-way['reach'] + narrower, way['reach'] - narrower + 1e-9, way['step'])

    def sample(at):
        at = (base[:, None, :] + at[None, :, None] * normal).astype(np.float32)
        how = cv2.INTER_NEAREST if way['nearest'] else cv2.INTER_LINEAR
        return cv2.remap(image, at[..., 0], at[..., 1], how, borderMode=cv2.BORDER_REPLICATE)

    if way['area']:
        grey = sample(t)
        low, high = grey[:, :2].mean(1), grey[:, -2:].mean(1)
        area = ((grey[:, 1:] + grey[:, :-1]).sum(1) / 2 - low * (len(t) - 1)) * way['step']
        return t[-1] - area / np.maximum(high - low, 1), np.where(high - low > 8, high - low, 0)
    gradient = np.maximum(sample(t + way['half']) - sample(t - way['half']), 0)
    if way['rows'] > 1:
        gradient = cv2.blur(gradient, (1, way['rows']), borderType=cv2.BORDER_REPLICATE)
    gradient = gradient ** way['power']
    weight = gradient.sum(1)
    return (gradient * t).sum(1) / np.maximum(weight, 1e-6), weight


def parts(a, b, way):
    """Where along a side its normals stand, as parts of it."""
    length = np.linalg.norm(b - a)
    if way['theirs']:
        return np.arange(1, max(16, int(length / 8)) + 1) / (max(16, int(length / 8)) + 1)
    count = int(np.clip(length * way['normals'] / 64, 8, way['normals']))
    skip = max(1, int(count * way['skip'])) if way['skip'] else 0
    return (np.arange(skip, count - skip) + .5) / count


def edge_points(image, a, b, way, narrower, at):
    """Points of the edge from a to b, and the weight of each; at: where along it."""
    v = b - a
    normal = np.array([v[1], -v[0]]) / np.linalg.norm(v)
    base = a + np.outer(at, v)
    off, weight = offsets(image, base, normal, way, narrower)
    there = weight > 1e-6
    return base[there] + off[there, None] * normal, weight[there]


def inner_points(image, corners, i, mark, way, narrower):
    """Edges between the border and white cells of the code along side i, moved out by a cell of the mark's own perspective."""
    square = np.float32([[0, 0], [8, 0], [8, 8], [0, 8]])
    to = cv2.getPerspectiveTransform(square, np.roll(corners, -i, axis=0).astype(np.float32))
    image_of = lambda points, h: cv2.perspectiveTransform(np.float32(points)[None], h)[0].astype(float)
    cell = (lambda j: (1, j), lambda j: (j, 6), lambda j: (6, 7 - j), lambda j: (7 - j, 1))[i]
    points, weights = np.zeros((0, 2)), np.zeros(0)
    for j in range(1, 7):
        if figures.LIB.stad_mark_cell(mark, *cell(j)):
            a, b = image_of([[j + .75, 1], [j + .25, 1]], to)
            found, weight = edge_points(image, a, b, way, narrower, (np.arange(4) + .5) / 4)
            if len(found):
                out = image_of(image_of(found, np.linalg.inv(to)) - [0, 1], to)
                points, weights = np.vstack([points, out]), np.append(weights, weight)
    return points, weights


def line(points, weight, way, near):
    """A point and the direction of the line, or of the parabola where it is nearest to `near`."""
    given = weight if way['weighted'] else np.ones(len(points))
    weight = given
    for _ in range(1 + bool(way['trim']) + way['huber']):
        centre = np.average(points, axis=0, weights=weight)
        normal, along = np.linalg.eigh(np.cov((points - centre).T, aweights=weight))[1].T
        off = abs((points - centre) @ normal)
        if way['trim']:
            weight = weight * (off <= max(.02, way['trim'] * np.sqrt(np.average(off ** 2, weights=weight))))
        if way['huber']:
            weight = given * np.minimum(1, max(.01, np.median(off)) / np.maximum(off, 1e-6))
    if not way['bow']:
        return centre, along
    s = (points - centre) @ along
    bend = np.polyfit(s, (points - centre) @ normal, 2)
    there = (near - centre) @ along
    direction = along + np.polyval(np.polyder(bend), there) * normal
    return centre + there * along + np.polyval(bend, there) * normal, direction / np.linalg.norm(direction)


def refine_once(image, corners, mark, way, narrower):
    sides = []
    for i in range(4):
        a, b = corners[i], corners[(i + 1) % 4]
        points = edge_points(image, a, b, way, narrower, parts(a, b, way))
        if way['inner']:
            points = [np.concatenate(both) for both in zip(points, inner_points(image, corners, i, mark, way, narrower))]
        sides.append(points)
    out = []
    for i in range(4):
        (p, d), (q, e) = line(*sides[i - 1], way, corners[i]), line(*sides[i], way, corners[i])
        out.append(p + np.linalg.solve(np.c_[d, -e], q - p)[0] * d)
    return np.array(out)


def refine(image, corners, mark, **change):
    way = {**NOW, **change}
    image = image.astype(np.float32)
    if way['blur']:
        image = cv2.GaussianBlur(image, (0, 0), way['blur'])
    for n in range(way['passes']):
        corners = refine_once(image, corners, mark, way, way['narrower'] * (n > 0))
    return corners


def main(frames):
    agree.drop_missing()
    real = []
    for name in PICTURES if os.path.exists(PICTURES[0]) else []:
        image = cv2.imread(name, cv2.IMREAD_GRAYSCALE)
        real.append((image, figures.find(image), [finds(image) for finds in agree.REFERENCES.values()]))
        image, ours, theirs = real[-1]
        rough = figures.find(image, True, refined=False)
        nearest, between = ({k: refine(image, v, k, **THEIRS, nearest=n) for k, v in rough.items()} for n in (1, 0))
        print(f'{os.path.basename(name)}: the way of 3.3.0 written once more, to it {cell(far(nearest, theirs[0]))}; with pixels interpolated '
              f'{cell(far(between, theirs[0]))}, to 3.4.3 {cell(far(between, theirs[-1]))}, to ours {cell(far(between, ours))}')
    synthetic = [rendered(*s, frames) for s in ((32, 3, .8), (24, 6, 1.2), (48, 3, .8))]
    print('each: mean / largest distance, px. All corners of the real pictures, and how many are above 0.1: to', ', to '.join(agree.REFERENCES),
          '| rendered, to the truth: 32 px noise 3, 24 px noise 6, 48 px noise 3')
    for name, finds in agree.REFERENCES.items():
        print(f'{name:28s} |', *(cell(np.concatenate([far(finds(v[0]), v[3]) for v in views])) for views in synthetic))
    for name, change in WAYS.items():
        columns = []
        mine = [{k: refine(image, v, k, **change) for k, v in ours.items()} for image, ours, _ in real]
        for i in range(len(agree.REFERENCES) if real else 0):
            d = np.concatenate([far(m, r[2][i]) for m, r in zip(mine, real)])
            columns.append(f'{cell(d)}, {(d > .1).sum()} |')
        for views in synthetic:
            d = np.concatenate([far({k: refine(i, v, k, **change) for k, v in ours.items()}, c) for i, ours, _, c in views])
            columns.append(cell(d))
        print(f'{name:28s} |', *columns, flush=True)


if __name__ == '__main__':
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--frames', type=int, default=20)
    ARGS = parser.parse_args()
    if ARGS.frames < 1:
        parser.error(f'--frames {ARGS.frames}: at least 1')
    figures.LIB = figures.build()
    main(ARGS.frames)
