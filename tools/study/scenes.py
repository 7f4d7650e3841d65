# SPDX-License-Identifier: MIT
"""Scenes, their truth as integers, and the black box that every method of the study calls: parameters -> exact counts.

STAD_DATA names the folder with MANIFEST.json. Counts of every point ever evaluated are kept on disk (STAD_STUDY_CACHE), so
a method that visits a point another one has visited costs nothing, and a table can be printed again in seconds."""
import json
import os
import statistics
import tempfile
import time

import cv2  # reads PNG; matching is the library's own
import numpy as np

from costs import COUNTS, cost_q20
from data_folder import entries
from package import stadimeter

HERE = os.path.dirname(os.path.abspath(__file__))
DATA = os.environ.get("STAD_DATA", "")
CACHE = os.environ.get("STAD_STUDY_CACHE", os.path.join(tempfile.gettempdir(), "stad-study", "cache"))
NONE = -2**31
DEFAULT = (2, 5, 3, 0, 15, 1)  # cv::StereoSGBM::create(), normalised

def sample(block=3, channels=1):
    """The parameters of OpenCV's stereo sample."""
    return (8 * channels * block * block, 32 * channels * block * block, block, 10, 63, 1)


def split(half, family):
    return json.load(open(os.path.join(HERE, "split.json")))[family][half]


def manifest():
    return {s["path"]: s for s in entries(DATA) if "numDisparities" in s}


def grey(path):
    bgr = cv2.imread(path, cv2.IMREAD_UNCHANGED)
    if bgr.ndim == 2:
        return bgr
    b, g, r = (bgr[..., i].astype(np.int32) for i in range(3))
    return ((9798 * r + 19235 * g + 3735 * b + 16384) >> 15).astype(np.uint8)


def read_pfm(path):
    with open(path, "rb") as f:
        assert f.readline().strip() == b"Pf"
        w, h = map(int, f.readline().split())
        order = "<" if float(f.readline()) < 0 else ">"
        return np.flipud(np.frombuffer(f.read(), order + "f4").reshape(h, w))


def truth_q16(folder):
    pfm = os.path.join(folder, "disp.pfm")
    if os.path.exists(pfm):
        px = read_pfm(pfm)
        fine = np.isfinite(px)
        return np.where(fine, np.rint(np.where(fine, px, 0).astype(np.float64) * 65536), NONE).astype(np.int32)
    raw = cv2.imread(os.path.join(folder, "disp.png"), cv2.IMREAD_UNCHANGED).astype(np.int32)
    return np.where(raw > 0, raw * 256, NONE).astype(np.int32)


def canonical(x):
    """The parameter set as the matcher runs it: OpenCV makes an even cap odd."""
    x = tuple(x)
    return x[:4] + (x[4] | 1,) + x[5:]


class Scene:
    """A pair in grey, or in colour as OpenCV reads it (its points are kept apart)."""

    def __init__(self, path, colour=False):
        meta = manifest()[path]
        folder = os.path.join(DATA, path)
        self.path, self.disparities = path, meta["numDisparities"]
        self.threshold = 3 if path.startswith("kitti2015") else 1
        read = cv2.imread if colour else grey
        self.left, self.right = read(os.path.join(folder, "left.png")), read(os.path.join(folder, "right.png"))
        self.truth = truth_q16(folder)
        mask = os.path.join(folder, "nonocc.png")
        if os.path.exists(mask):
            seen = cv2.imread(mask, cv2.IMREAD_UNCHANGED) > 0
            self.label = np.where(self.truth == NONE, 0, np.where(seen, 1, 2)).astype(np.uint8)
        else:
            self.label = stadimeter.label(self.truth)
        self.matcher = stadimeter.StereoSGBM_create(numDisparities=self.disparities)
        os.makedirs(CACHE, exist_ok=True)
        self.file = os.path.join(CACHE, path.replace("/", "_") + ("_colour" if colour else "") + ".txt")
        self.known = {}
        self.reload()

    def reload(self):
        if os.path.exists(self.file):
            for line in open(self.file):
                f = line.split()
                if len(f) == 6 + len(COUNTS):
                    self.known[canonical(map(int, f[:6]))] = tuple(map(int, f[6:]))

    def disparity(self, x):
        m = self.matcher
        for set_value, value in zip((m.setP1, m.setP2, m.setBlockSize, m.setUniquenessRatio, m.setPreFilterCap, m.setDisp12MaxDiff), x):
            set_value(value)
        return m.compute(self.left, self.right)

    def evaluate(self, x):
        """Counts of a point, afresh."""
        scorer = stadimeter.Scorer(self.disparities, threshold=self.threshold)
        scorer.add(self.disparity(x), self.truth, self.label)
        n = scorer.counts()
        return tuple(n[name] for name in COUNTS)

    def seconds_of_one(self, points):
        """Processor seconds of an evaluation, the median of these points; nothing is taken from the cache."""
        times = []
        for x in points[:1] + points:  # the first twice: memory and tables are there then
            begin = time.thread_time()
            self.evaluate(x)
            times.append(time.thread_time() - begin)
        return statistics.median(times[1:])

    def counts(self, x):
        x = canonical(x)
        if x not in self.known:
            self.known[x] = self.evaluate(x)
            with open(self.file, "a") as f:
                f.write(" ".join(map(str, x + self.known[x])) + "\n")
        return dict(zip(COUNTS, self.known[x]))

    def cost(self, x, kind):
        return cost_q20(self.counts(x), kind)
