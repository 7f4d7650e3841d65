#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Other ways to refine a mark's corners, beside libapriltag's: on real pictures against it, on rendered frames against the truth.

    tools/study/marks/run corners [--frames N]

The first line is the way of lib/src/mark/mark_edge.c written once more in floating point; each other line changes it in what its name
says. Every way starts from the detector's own corners. `turned`: libapriltag's mean over the picture's four quarter turns, which
takes a part of its own error away."""
import argparse
import os

import cv2
import figures
import numpy as np

# Normals a side at most, part of a side left out at its ends, px looked at on each side, px between samples, px from a sample to each of
# the two whose difference is its gradient, power of the gradient that weighs, passes, px by which a later pass is narrower; then: points
# farther from the line than so many rms left out, points weighted by their gradients, px of blur, rows summed along the edge.
NOW = dict(normals=64, skip=1 / 16, reach=2, step=.5, half=.5, power=2, passes=2, narrower=.5, trim=0, weighted=0, blur=0, rows=1)
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
    'weighted points': dict(weighted=1),
    'blurred first': dict(blur=.7),
    'three rows summed': dict(rows=3),
    'as libapriltag': dict(normals=16, reach=2, step=.25, half=1, passes=1, narrower=0),
}


def edge_points(image, a, b, way, narrower):
    """Points of the edge from a to b, and the weight of each."""
    v = b - a
    length = np.linalg.norm(v)
    normal = np.array([v[1], -v[0]]) / length
    count = int(np.clip(length * way['normals'] / 64, 8, way['normals']))
    skip = max(1, int(count * way['skip'])) if way['skip'] else 0
    base = a + np.outer((np.arange(skip, count - skip) + .5) / count, v)
    t = np.arange(-way['reach'] + narrower, way['reach'] - narrower + 1e-9, way['step'])

    def sample(offsets):
        at = (base[:, None, :] + offsets[None, :, None] * normal).astype(np.float32)
        return cv2.remap(image, at[..., 0], at[..., 1], cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)

    gradient = np.maximum(sample(t + way['half']) - sample(t - way['half']), 0)
    if way['rows'] > 1:
        rows = way['rows']
        gradient = sum(gradient[k:len(gradient) - rows + 1 + k] for k in range(rows)) / rows
        base = base[rows // 2:len(base) - rows // 2]
    gradient = gradient ** way['power']
    weight = gradient.sum(1)
    there = weight > 1e-6
    return base[there] + ((gradient * t).sum(1)[there] / weight[there])[:, None] * normal, weight[there]


def line(points, weight, way):
    weight = weight if way['weighted'] else np.ones(len(points))
    for _ in range(2 if way['trim'] else 1):
        centre = np.average(points, axis=0, weights=weight)
        values, vectors = np.linalg.eigh(np.cov((points - centre).T, aweights=weight))
        if way['trim']:
            off = abs((points - centre) @ vectors[:, 0])
            weight = weight * (off <= max(.02, way['trim'] * np.sqrt(np.average(off ** 2, weights=weight))))
    return centre, vectors[:, 1]


def refine(image, corners, **change):
    way = {**NOW, **change}
    image = image.astype(np.float32)
    if way['blur']:
        image = cv2.GaussianBlur(image, (0, 0), way['blur'])
    corners = corners.copy()
    for n in range(way['passes']):
        sides = [line(*edge_points(image, corners[i], corners[(i + 1) % 4], way, way['narrower'] * (n > 0)), way) for i in range(4)]
        for i in range(4):
            (p, d), (q, e) = sides[i - 1], sides[i]
            corners[i] = p + np.linalg.solve(np.c_[d, -e], q - p)[0] * d
    return corners


def far(a, b):
    return np.concatenate([np.linalg.norm(a[k] - b[k], axis=1) for k in a if k in b])


def rendered(side, noise, psf, frames):
    wide = side > 40
    w, h, f = (640, 480, 704) if wide else (320, 240, 352)
    rng, views = np.random.default_rng(side * 100 + noise), []
    while len(views) < frames:
        s = figures.scene(width=w, height=h, f=f, z=f * 48 / side, psf=psf, pitch=rng.uniform(-.5, .5), yaw=rng.uniform(-.5, .5),
                          turn=rng.uniform(-.35, .35), x=rng.uniform(10, 50), y=rng.uniform(-10, 10), seed=len(views) + 1)
        left, _, _, _, _, corners = figures.render(s)
        if figures.visible(corners, w, h, 1.25 * side / 8 + 2):
            image = figures.expose(left, noise, 2 * len(views) + 9)
            views.append((image, figures.find(image), figures.find(image, True), dict(enumerate(corners[:, :, :2]))))
    return views


def main(frames):
    real = []
    for name in figures.PICTURES if os.path.exists(figures.PICTURES[0]) else []:
        image = cv2.imread(name, cv2.IMREAD_GRAYSCALE)
        real.append((image, figures.find(image), figures.find(image, True), figures.turned_mean(image, True)))
    synthetic = [rendered(*s, frames) for s in ((32, 3, .8), (24, 6, 1.2), (48, 3, .8))]
    print('each: mean / largest distance, px. Real pictures: to libapriltag, to its mean over turns. Rendered: to the truth (32 px noise 3, '
          '24 px noise 6, 48 px noise 3)')
    cell = '{:.3f}/{:.3f}'.format
    truth = [np.concatenate([far(theirs, c) for _, _, theirs, c in views]) for views in synthetic]
    print(f"{'libapriltag':20s} | rendered", *(cell(d.mean(), d.max()) for d in truth))
    for name, change in WAYS.items():
        columns = []
        for image, ours, theirs, turned in real:
            mine = {k: refine(image, v, **change) for k, v in ours.items()}
            columns += [cell(d.mean(), d.max()) for d in (far(mine, theirs), far(mine, turned))] + ['|']
        for views in synthetic:
            d = np.concatenate([far({k: refine(i, v, **change) for k, v in ours.items()}, c) for i, ours, _, c in views])
            columns.append(cell(d.mean(), d.max()))
        print(f'{name:20s} |', *columns, flush=True)


if __name__ == '__main__':
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--frames', type=int, default=20)
    ARGS = parser.parse_args()
    if ARGS.frames < 1:
        parser.error(f'--frames {ARGS.frames}: at least 1')
    figures.LIB = figures.build()
    main(ARGS.frames)
