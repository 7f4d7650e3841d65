#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Does the monitor see what spoils a depth map, and is it quiet otherwise? The library's own matcher and monitor, 17 disturbances.

    STAD_DATA=folder python3 tools/study/monitor/monitor.py [--json OUT]

Found is counted on EuRoC: on pans over strong texture several disturbances do no harm that could be seen.

Recordings: 102 EuRoC frames (16 frames played forward and back) at 376 x 240, and 90-frame pans of a 376 x 240 window over five
Middlebury scenes. Matcher: block 5, P1 200, P2 800, cap 31, uniqueness 10; 32 disparities on EuRoC, 64 on the pans, so that no scene leaves
the range that is searched. White noise of sd 2 throughout; each disturbance starts at frame 50. Detected = an alarm within 8 frames (the ramp: 16)."""
import argparse
import ctypes
import glob
import json
import os
import subprocess
import sys
import tempfile

import cv2
import numpy as np

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", "..", ".."))
DATA = os.environ.get("STAD_DATA", "")
WIDTH, HEIGHT, START = 376, 240, 50
PANS = (("middlebury2001/venus", 1.0, 0), ("middlebury2003/cones", 1.0, 0), ("middlebury2006/Rocks2", 1.0, 10),
        ("middlebury2006/Cloth1", 1.0, 8), ("middlebury2014/Motorcycle", 0.75, 0))  # scene, scale, columns taken off the disparity


class Geometry(ctypes.Structure):
    _fields_ = [(n, ctypes.c_int16) for n in ("width", "height", "channels", "max_disparities", "max_block_size", "max_p2",
                                              "max_pre_filter_cap")] + [("mode", ctypes.c_uint8), ("memory", ctypes.c_uint8)]


class Params(ctypes.Structure):
    _fields_ = [(n, ctypes.c_int16) for n in ("min_disparity", "num_disparities", "block_size", "p1", "p2", "disp12_max_diff",
                                              "pre_filter_cap", "uniqueness_ratio")] + [("speckle_window_size", ctypes.c_int32),
                                                                                        ("speckle_range", ctypes.c_int32)]


class Counts(ctypes.Structure):
    _fields_ = [(n, ctypes.c_int32) for n in ("considered", "firm", "rejected_uniqueness", "rejected_check", "valid", "rejected_speckle")]


class Image(ctypes.Structure):
    _fields_ = [("pix", ctypes.c_void_p), ("width", ctypes.c_int32), ("height", ctypes.c_int32), ("channels", ctypes.c_int32),
                ("pixel_stride", ctypes.c_int32), ("row_stride", ctypes.c_ssize_t)]


def image(a):
    return Image(a.ctypes.data, a.shape[1], a.shape[0], 1, 1, a.strides[0])


class Library:
    """Matcher and monitor, compiled to a shared object in a temporary folder."""

    def __init__(self):
        folder = tempfile.mkdtemp(prefix="stad-")
        path = os.path.join(folder, "stad.so")
        parts = "base kernel match monitor"
        sources = sum((sorted(glob.glob(f"{ROOT}/lib/src/{p}/*.c")) for p in parts.split()), [])
        subprocess.run(["cc", "-std=c99", "-O3", "-march=native", "-shared", "-fPIC", f"-I{ROOT}/lib/include", f"-I{ROOT}/lib/src", f"-I{ROOT}/port/isa/c",
                        "-o", path, *sources], check=True)
        self.lib = ctypes.CDLL(path)
        self.lib.stad_match_bytes.restype = ctypes.c_size_t
        self.lib.stad_match_counts_of.restype = ctypes.POINTER(Counts)
        geometry = Geometry(WIDTH, HEIGHT, 1, 64, 5, 800, 31, 0, 0)
        size = self.lib.stad_match_bytes(ctypes.byref(geometry))
        self.store = np.zeros(size + 64, np.uint8)
        start = (self.store.ctypes.data + 63) // 64 * 64
        self.match = np.zeros(512, np.uint64)
        status = self.lib.stad_match_init(ctypes.c_void_p(self.match.ctypes.data), ctypes.byref(geometry), ctypes.c_void_p(start), ctypes.c_size_t(size))
        assert status == 0, status
        self.params = Params(0, 32, 5, 200, 800, 1, 31, 10, 0, 0)
        self.disparity = np.zeros((HEIGHT, WIDTH), np.int16)

    def counts(self, left, right, disparities):
        self.params.num_disparities = disparities
        status = self.lib.stad_match_frame(ctypes.c_void_p(self.match.ctypes.data), ctypes.byref(self.params), ctypes.byref(image(left)), ctypes.byref(image(right)),
                                           ctypes.c_void_p(self.disparity.ctypes.data), ctypes.c_ssize_t(WIDTH), None, ctypes.c_size_t(0))
        assert status == 0, status
        c = self.lib.stad_match_counts_of(ctypes.c_void_p(self.match.ctypes.data)).contents
        return c.considered, c.firm

    def alarms(self, counts):
        """Numbers of the frames that raised an alarm."""
        monitor = np.zeros(64, np.uint64)
        self.lib.stad_monitor_init(ctypes.c_void_p(monitor.ctypes.data), None)
        found = []
        for i, (considered, firm) in enumerate(counts):
            c = Counts(considered, firm, 0, 0, 0, 0)
            if self.lib.stad_monitor_frame(ctypes.c_void_p(monitor.ctypes.data), ctypes.byref(c)) == 2:
                found.append(i)
        return found


def grey(path):
    picture = cv2.imread(path, cv2.IMREAD_GRAYSCALE) if os.path.exists(path) else None
    if picture is None:
        sys.exit(f"{path} cannot be read; STAD_DATA names the folder of scenes")
    return picture.astype(np.float32)


def euroc(count=102):
    frames = [(cv2.resize(grey(f"{DATA}/video/euroc/{i:02d}_left.png"), (WIDTH, HEIGHT), interpolation=cv2.INTER_AREA),
               cv2.resize(grey(f"{DATA}/video/euroc/{i:02d}_right.png"), (WIDTH, HEIGHT), interpolation=cv2.INTER_AREA)) for i in range(16)]
    order = list(range(16)) + list(range(14, 0, -1))
    return [frames[order[i % len(order)]] for i in range(count)]


def pan(path, scale, shift, count=90):
    """The window goes once round an ellipse that fits the scene; the right one runs `shift` columns ahead."""
    left, right = (cv2.resize(grey(f"{DATA}/{path}/{side}.png"), None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA) for side in ("left", "right"))
    room_x, room_y = left.shape[1] - WIDTH - shift, left.shape[0] - HEIGHT
    frames = []
    for i in range(count):
        angle = 2 * np.pi * i / count
        x = shift + int(round(room_x * (0.5 + 0.5 * np.cos(angle))))
        y = int(round(room_y * (0.5 + 0.5 * np.sin(angle))))
        frames.append((left[y:y + HEIGHT, x:x + WIDTH], right[y:y + HEIGHT, x - shift:x - shift + WIDTH]))
    return frames


def warp(a, dx=0.0, dy=0.0, degrees=0.0):
    m = cv2.getRotationMatrix2D((WIDTH / 2, HEIGHT / 2), degrees, 1.0)
    m[:, 2] += (dx, dy)
    return cv2.warpAffine(a, m, (WIDTH, HEIGHT), flags=cv2.INTER_CUBIC, borderMode=cv2.BORDER_REPLICATE)


def glare(a, x):
    yy, xx = np.mgrid[0:HEIGHT, 0:WIDTH]
    return a + 250 * np.exp(-((xx - x * WIDTH) ** 2 + (yy - 0.4 * HEIGHT) ** 2) / (2 * (0.25 * WIDTH) ** 2)).astype(np.float32)


def blur(a, sd):
    return cv2.GaussianBlur(a, (0, 0), sd)


# name -> (k, left, right) -> left, right, noise sd; k = frames since the disturbance began
DISTURBANCES = {
    "gain .5": lambda k, l, r: (l * .5, r * .5, 2),
    "gain .25": lambda k, l, r: (l * .25, r * .25, 2),
    "gain .12": lambda k, l, r: (l * .12, r * .12, 2),
    "ramp to .12": lambda k, l, r: (l * (1 - .88 * min(k + 1, 20) / 20), r * (1 - .88 * min(k + 1, 20) / 20), 2),
    "noise 6": lambda k, l, r: (l, r, 6),
    "noise 12": lambda k, l, r: (l, r, 12),
    "blur 1.5": lambda k, l, r: (blur(l, 1.5), blur(r, 1.5), 2),
    "blur 3": lambda k, l, r: (blur(l, 3), blur(r, 3), 2),
    "blur left 2": lambda k, l, r: (blur(l, 2), r, 2),
    "glare": lambda k, l, r: (glare(l, .55), glare(r, .5), 2),
    "glare left": lambda k, l, r: (glare(l, .5), r, 2),
    "right gain .7": lambda k, l, r: (l, r * .7, 2),
    "dy .5": lambda k, l, r: (l, warp(r, dy=.5), 2),
    "dy 1": lambda k, l, r: (l, warp(r, dy=1), 2),
    "roll .3": lambda k, l, r: (l, warp(r, degrees=.3), 2),
    "roll .6": lambda k, l, r: (l, warp(r, degrees=.6), 2),
    "x shift 2": lambda k, l, r: (l, warp(r, dx=2), 2),
}


def sensor(a, sd, rng):
    return np.clip(np.rint(a + rng.normal(0, sd, a.shape)), 0, 255).astype(np.uint8)


def play(library, frames, disparities, disturb, seed, count=None):
    rng = np.random.default_rng(seed)
    out = []
    for i, (left, right) in enumerate(frames[:count]):
        sd = 2
        if disturb and i >= START:
            left, right, sd = disturb(i - START, left, right)
        out.append(library.counts(sensor(left, sd, rng), sensor(right, sd, rng), disparities))
    return out


def main():
    args = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    args.add_argument("--json")
    args.add_argument("--keep", help="keep every recording's counters in this JSON file")
    args = args.parse_args()
    cv2.setNumThreads(1)
    library = Library()
    recordings = {"euroc": euroc(), **{path.split("/")[1]: pan(path, scale, shift) for path, scale, shift in PANS}}
    disparities = {name: 32 if name == "euroc" else 64 for name in recordings}
    kept, clean, table = {}, {}, {}
    for seed, (name, frames) in enumerate(recordings.items()):
        kept[name] = {"clean": play(library, frames, disparities[name], None, seed)}
        clean[name] = library.alarms(kept[name]["clean"])
        print(f"clean {name}: {len(frames)} frames, alarms {clean[name]}", flush=True)
    for name, disturb in DISTURBANCES.items():
        limit = 16 if name.startswith("ramp") else 8
        row = {}
        for seed, (recording, frames) in enumerate(recordings.items()):
            kept[recording][name] = play(library, frames, disparities[recording], disturb, 100 + seed, START + limit + 2)
            late = [a - START + 1 for a in library.alarms(kept[recording][name]) if a >= START]
            row[recording] = late[0] if late and late[0] <= limit else None
        table[name] = row
        delays = [d for d in row.values() if d]
        print(f"{name:14s} " + " ".join(f"{row[r] or '-':>3}" for r in recordings) + f"   {len(delays)}/{len(row)}", flush=True)
    euroc_found = sum(row["euroc"] is not None for row in table.values())
    most = sum(2 * sum(d is not None for d in row.values()) > len(row) for row in table.values())
    frames = sum(len(f) for f in recordings.values())
    print(f"found {euroc_found} of {len(table)} on EuRoC, {most} of {len(table)} on most recordings; "
          f"{sum(map(len, clean.values()))} alarms in {frames} clean frames")
    if args.json:
        json.dump({"clean": clean, "disturbances": table, "found_euroc": euroc_found, "found_most": most, "clean_frames": frames}, open(args.json, "w"), indent=1)
    if args.keep:
        json.dump(kept, open(args.keep, "w"))
    return 0 if euroc_found >= 14 and not any(clean.values()) else 1


if __name__ == "__main__":
    sys.exit(main())
