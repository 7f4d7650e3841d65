# SPDX-License-Identifier: MIT
"""The library's score and tune modules through ctypes, built with the C compiler on first use."""
import ctypes
import glob
import hashlib
import os
import subprocess
import tempfile

import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DIMS = 6
NAMES = ("p1", "p2", "block_size", "uniqueness_ratio", "pre_filter_cap", "disp12_max_diff")
LADDER = 6
FAILED = 2**31 - 1
METHODS = {"ncg": 0, "ncg-paper": 1, "sd": 2, "hybrid": 3}
PURPOSES = {"any": 0, "bad": 1, "chow": 2}
COSTS = {"bad": 0, "chow": 1, "d1": 2, "rmse": 3, "mae": 4, "missing": 5, "blind": 6}


def build():
    """Compiles the modules into one shared object, named by a hash of its sources. Returns its path."""
    sources = sorted(sum((glob.glob(os.path.join(ROOT, "lib/src", m)) for m in ("tune/*.c", "score/*.c", "base/log.c")), []))
    headers = sorted(sum((glob.glob(os.path.join(ROOT, p)) for p in ("lib/include/stad/*.h", "lib/src/tune/*.h", "lib/src/base/*.h")), []))
    digest = hashlib.sha256(b"".join(open(f, "rb").read() for f in sources + headers) + os.environ.get("STAD_STUDY_CFLAGS", "").encode()).hexdigest()[:16]
    folder = os.path.join(tempfile.gettempdir(), "stad-study")
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, f"tune-{digest}.so")
    if not os.path.exists(path):
        part = f"{path}.{os.getpid()}"
        subprocess.run(["cc", "-std=c99", *os.environ.get("STAD_STUDY_CFLAGS", "").split(), "-O2", "-shared", "-fPIC", "-I", os.path.join(ROOT, "lib/include"),
                        "-I", os.path.join(ROOT, "lib/src"), "-o", part, *sources], check=True)
        os.replace(part, path)
    return path


class Axis(ctypes.Structure):
    _fields_ = [("lo", ctypes.c_int16), ("hi", ctypes.c_int16), ("unit", ctypes.c_int16), ("scale", ctypes.c_uint8), ("side", ctypes.c_int8)]


Point = ctypes.c_int16 * DIMS


class Config(ctypes.Structure):
    _fields_ = [("method", ctypes.c_uint8), ("free_mask", ctypes.c_uint8), ("ordered", ctypes.c_uint8), ("ladder_count", ctypes.c_uint8),
                ("budget", ctypes.c_int16), ("patience", ctypes.c_int16), ("seed", ctypes.c_uint32), ("axis", Axis * DIMS), ("ladder", Point * LADDER)]


class Counts(ctypes.Structure):
    _fields_ = [("evaluations", ctypes.c_int16), ("iterations", ctypes.c_int16), ("calls", ctypes.c_int32)]


class ScoreConfig(ctypes.Structure):
    _fields_ = [("min_disparity", ctypes.c_int16), ("num_disparities", ctypes.c_int16), ("threshold_q16", ctypes.c_int32),
                ("cost", ctypes.c_uint8), ("photo_limit", ctypes.c_uint8), ("weight_q8", ctypes.c_int16 * 11)]


class ScoreCounts(ctypes.Structure):
    _fields_ = [(n, ctypes.c_int32) for n in ("visible", "occluded", "wrong_visible", "wrong_occluded", "missing_visible", "missing_occluded",
                                              "d1_visible", "d1_occluded")] + [("square_sum_q16", ctypes.c_int64), ("abs_sum_q16", ctypes.c_int64)] + \
               [(n, ctypes.c_int32) for n in ("considered", "matched", "speckle", "inconsistent")] + [("photo_sum", ctypes.c_int64)]


class Score(ctypes.Structure):
    _fields_ = [("config", ScoreConfig), ("counts", ScoreCounts), ("histogram", ctypes.c_int32 * 32)]


class Native:
    def __init__(self, path=None):
        self.lib = ctypes.CDLL(path or build())
        self.lib.stad_score_end.restype = ctypes.c_int32
        self.tune_bytes = 8192  # above sizeof(stad_tune), which the unit tests hold at 4 KiB

    def config(self, purpose="any", method="ncg", budget=100):
        c = Config()
        self.lib.stad_tune_config_stereo(ctypes.byref(c), PURPOSES[purpose])
        c.method = METHODS[method]
        c.budget = budget
        return c

    def label(self, truth_q16):
        h, w = truth_q16.shape
        label = np.zeros((h, w), np.uint8)
        work = np.zeros(w, np.int32)
        for y in range(h):
            self.lib.stad_score_label_row(truth_q16[y].ctypes.data_as(ctypes.c_void_p), w, label[y].ctypes.data_as(ctypes.c_void_p),
                                          work.ctypes.data_as(ctypes.c_void_p))
        return label

    def score(self, frames, num_disparities, threshold_q16=65536, cost="bad", min_disparity=0):
        """frames: (disp_q4, truth_q16, label) arrays. The Score after all rows of all frames."""
        c, s = ScoreConfig(), Score()
        self.lib.stad_score_config_init(ctypes.byref(c), COSTS[cost], min_disparity, num_disparities)
        c.threshold_q16 = threshold_q16
        if self.lib.stad_score_begin(ctypes.byref(s), ctypes.byref(c)) != 0:
            raise ValueError("score config refused")
        for disp, truth, label in frames:
            h, w = disp.shape
            for a, t in ((disp, np.int16), (truth, np.int32), (label, np.uint8)):
                assert a.dtype == t and a.flags.c_contiguous and a.shape == (h, w)
            base = disp.ctypes.data, truth.ctypes.data, label.ctypes.data
            for y in range(h):
                self.lib.stad_score_row(ctypes.byref(s), y, ctypes.c_void_p(base[0] + 2 * w * y), ctypes.c_void_p(base[1] + 4 * w * y),
                                        ctypes.c_void_p(base[2] + w * y), w)
        return s

    @staticmethod
    def pointer(structure):
        return ctypes.byref(structure)

    def cost(self, score):
        return self.lib.stad_score_end(ctypes.byref(score))

    def tune(self, config, start, cost_of):
        """Runs a search to its end. cost_of(tuple) -> Q20. Returns (trace [(point, cost)], counts)."""
        t = ctypes.create_string_buffer(self.tune_bytes)
        p = Point(*start)
        if self.lib.stad_tune_init(t, ctypes.byref(config), p) != 0:
            raise ValueError("tune config refused")
        trace = []
        while self.lib.stad_tune_ask(t, p) == 1:
            x = tuple(p)
            c = int(cost_of(x))
            if self.lib.stad_tune_tell(t, c) != 0:
                raise ValueError(f"cost {c} refused")
            trace.append((x, c))
        self.lib.stad_tune_counts_of.restype = Counts
        return trace, self.lib.stad_tune_counts_of(t)


class Matcher:
    """The library's matcher, built by CMake into build-study (STAD_STUDY_MATCHER names a ready shared object instead)."""

    def __init__(self):
        path = os.environ.get("STAD_STUDY_MATCHER") or self.build()
        self.lib = ctypes.CDLL(path)

    @staticmethod
    def build():
        folder = os.path.join(ROOT, "build-study")
        path = os.path.join(folder, "study_match.so")
        subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DSTAD_BUILD_TOOLS=OFF", "-DSTAD_BUILD_TESTS=OFF",
                        "-DSTAD_BUILD_EXAMPLES=OFF"], check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["cmake", "--build", folder, "-j2"], check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["cc", "-std=gnu11", "-O2", "-shared", "-fPIC", "-I", os.path.join(ROOT, "lib/include"), "-o", path,
                        os.path.join(ROOT, "tools/study/match_shim.c"), os.path.join(folder, "lib/libstadimeter.a")], check=True)
        return path

    def match(self, left, right, disparities, x):
        h, w = left.shape
        left, right = np.ascontiguousarray(left), np.ascontiguousarray(right)
        out = np.empty((h, w), np.int16)
        pointers = [ctypes.c_void_p(a.ctypes.data) for a in (left, right, out)]
        status = self.lib.study_match(w, h, disparities, pointers[0], pointers[1], (ctypes.c_int * DIMS)(*x), pointers[2])
        if status != 0:
            raise ValueError(f"match refused {x}: {status}")
        return out
