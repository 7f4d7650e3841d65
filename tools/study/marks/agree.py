#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The marks' corners beside libapriltag's: Debian's 3.3.0, and 3.4.3, which interpolates where 3.3.0 looks up the nearest pixel.

    tools/study/marks/run agree [--frames N]

First which settings of libapriltag are the most accurate on rendered marks of known place, and then its corners and ours on the real
pictures of Debian's visp-images-data: as given; each mark cut out, enlarged and given to both; and what each says of the same picture
turned. All distances are px of the picture as given."""
import argparse
import os

import cv2
import figures
import numpy as np
from figures import find

VISP = '/usr/share/visp-images-data/ViSP-images/AprilTag/'
PICTURES = [VISP + f for f in ('AprilTag.pgm', 'benchmark/640x480/tag36_11_640x480.png', 'benchmark/1920x1080/tag36_11_1920x1080.png')]
SETTINGS = [(decimate, sigma) for decimate in (1, 1.5, 2) for sigma in (0, .8)]
NEWER = {}


def find_newer(image, decimate=1, sigma=0):
    """The same as figures.find() by libapriltag 3.4.3 of the Python package pyapriltags."""
    import pyapriltags
    if (decimate, sigma) not in NEWER:
        NEWER[decimate, sigma] = pyapriltags.Detector(families='tag36h11', nthreads=1, quad_decimate=float(decimate),
                                                      quad_sigma=float(sigma), refine_edges=1)
    marks = NEWER[decimate, sigma].detect(np.array(image, order='C'))
    return {m.tag_id: m.corners[::-1] - .5 for m in marks if m.tag_id < 32}


def find_reference(image, decimate=1, sigma=0):
    return find(image, True, decimate=decimate, sigma=sigma)


REFERENCES = {'libapriltag 3.3.0': find_reference, 'libapriltag 3.4.3': find_newer}


def far(a, b):
    return np.concatenate([np.linalg.norm(a[k] - b[k], axis=1) for k in a if k in b] or [np.zeros(0)])


def cell(d):
    return f'{d.mean():.3f}/{d.max():.3f}'


def told(d):
    return f'{cell(d)} px, {(d > .1).sum()} of {len(d)} above 0.1'


def rendered(side, noise, psf, frames):
    """Views of four marks: the picture, our corners, libapriltag's, the true ones."""
    wide = side > 40
    w, h, f = (640, 480, 704) if wide else (320, 240, 352)
    rng, views = np.random.default_rng(side * 100 + noise), []
    while len(views) < frames:
        s = figures.scene(width=w, height=h, f=f, z=f * 48 / side, psf=psf, pitch=rng.uniform(-.5, .5), yaw=rng.uniform(-.5, .5),
                          turn=rng.uniform(-.35, .35), x=rng.uniform(10, 50), y=rng.uniform(-10, 10), seed=len(views) + 1)
        left, _, _, _, _, corners = figures.render(s)
        if figures.visible(corners, w, h, 1.25 * side / 8 + 2):
            image = figures.expose(left, noise, 2 * len(views) + 9)
            views.append((image, find(image), find(image, True), dict(enumerate(corners[:, :, :2]))))
    return views


def settings(frames):
    for side, noise, psf in ((32, 3, .8), (24, 6, 1.2), (48, 3, .8)):
        views = rendered(side, noise, psf, frames)
        what = f'settings {side} px noise {noise}: to the truth:'
        print(what, 'ours', cell(np.concatenate([far(v[1], v[3]) for v in views])))
        for name, reference in REFERENCES.items():
            for how in SETTINGS:
                found = [(reference(v[0], *how), v[3]) for v in views]
                print(f'{what} {name} decimate {how[0]} sigma {how[1]}', cell(np.concatenate([far(*f) for f in found])),
                      f'({sum(len(f[0]) for f in found)} marks)', flush=True)


def quarter_turns(image, finds):
    """Corners found in the picture turned by 0, 90, 180 and 270 degrees, turned back."""
    h, w = image.shape
    back = (lambda x, y: (x, y), lambda x, y: (w - 1 - y, x), lambda x, y: (w - 1 - x, h - 1 - y), lambda x, y: (y, h - 1 - x))
    found = {}
    for turn in range(4):
        for k, corners in finds(np.ascontiguousarray(np.rot90(image, turn))).items():
            found.setdefault(k, []).append(np.stack(back[turn](corners[:, 0], corners[:, 1]), axis=1))
    return found


def turned_mean(image, finds):
    return {k: np.mean(v, axis=0) for k, v in quarter_turns(image, finds).items()}


def enlarged(image, marks, times, finds):
    """Each mark cut out with a surround of half its size and enlarged, then found; its corners in the picture."""
    out = {}
    for k, corners in marks.items():
        low, high = corners.min(0), corners.max(0)
        x, y = np.maximum((low - (high - low) / 2).astype(int) - 4, 0)
        right, bottom = (high + (high - low) / 2).astype(int) + 5
        large = cv2.resize(image[y:bottom, x:right], None, fx=times, fy=times, interpolation=cv2.INTER_CUBIC)
        found = finds(large)
        if k in found:
            out[k] = (found[k] + .5) / times - .5 + [x, y]
    return out


def agree_on(name):
    image = cv2.imread(name, cv2.IMREAD_GRAYSCALE)
    ours = find(image)
    print(f'agree   {os.path.basename(name)}: {len(ours)} marks')
    for reference, finds in REFERENCES.items():
        theirs = finds(image)
        print(f'agree     as given, to {reference}: {len(theirs)} marks, same identities {sorted(ours) == sorted(theirs)}; corners '
              f'{told(far(ours, theirs))}')
        for times in (2, 3, 4):
            large = enlarged(image, ours, times, finds)
            print(f'agree     given to both enlarged {times} times, to {reference}: '
                  f'{told(far(enlarged(image, ours, times, find), large))}; ours as given {told(far(ours, large))}; '
                  f'{reference} as given {told(far(theirs, large))}')
        print(f'agree     to the mean of {reference} over the turns: {told(far(ours, turned_mean(image, finds)))}')
    apart = far(*(finds(image) for finds in (list(REFERENCES.values()) * 2)[:2]))
    print(f"agree     {' to '.join((list(REFERENCES) * 2)[:2])}: {told(apart)}")
    for name, finds in REFERENCES.items():
        for how in SETTINGS[1:]:
            theirs = finds(image, *how)
            print(f'agree     {name} at decimate {how[0]} sigma {how[1]}, to its own without: {told(far(theirs, finds(image)))}; '
                  f'to ours: {told(far(theirs, ours))}')
    for who, finds in {'ours': find, **REFERENCES}.items():
        turns = quarter_turns(image, finds)
        for turn in (1, 2, 3):
            print(f'agree     {who} in the picture turned by {90 * turn} degrees, to its own: '
                  f'{told(far({k: v[turn] for k, v in turns.items()}, {k: v[0] for k, v in turns.items()}))}', flush=True)


def drop_missing():
    try:
        import pyapriltags  # noqa: F401
    except ImportError:
        print('libapriltag 3.4.3 SKIPPED: pyapriltags is not installed')
        del REFERENCES['libapriltag 3.4.3']


def main(frames):
    drop_missing()
    settings(frames)
    if not os.path.exists(PICTURES[0]):
        return print('agree   SKIPPED: visp-images-data is not installed')
    for name in PICTURES:
        agree_on(name)


if __name__ == '__main__':
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--frames', type=int, default=40)
    ARGS = parser.parse_args()
    if ARGS.frames < 1:
        parser.error(f'--frames {ARGS.frames}: at least 1')
    figures.LIB = figures.build()
    main(ARGS.frames)
