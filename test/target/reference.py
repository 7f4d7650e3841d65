#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the matcher's hashes in examples/mcu/expected.h against cv::StereoSGBM on the same pixels.

reference.py [CC]: needs a C compiler and the package opencv-python-headless.
"""
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import zlib

import cv2
import numpy

MCU = pathlib.Path(__file__).resolve().parent.parent.parent / "examples/mcu"
DUMP = """
#include <stdio.h>
#include "scene.h"
int main(void)
{
    const scene s = {%d, %d, %d, 3, 20};
    unsigned char left[160], right[160];
    for (int y = 0; y < s.height; y++) {
        scene_row(&s, y, left, right, NULL);
        fwrite(left, 1, (size_t)s.width, stdout);
        fwrite(right, 1, (size_t)s.width, stdout);
    }
    return 0;
}
"""
# macro: width, height, disparities, block, mode as in chain_match.c
FRAMES = {"SGBM": (160, 120, 32, 5, 0), "3WAY": (160, 120, 32, 5, 2), "HH": (96, 64, 16, 5, 1), "HH4": (96, 64, 16, 5, 3),
          "BYTES": (96, 64, 16, 1, 0), "SATURATING": (96, 64, 16, 15, 0)}


def pixels(width, height, disparities):
    with tempfile.TemporaryDirectory() as folder:
        source, program = pathlib.Path(folder, "dump.c"), pathlib.Path(folder, "dump")
        source.write_text(DUMP % (width, height, disparities))
        cc = sys.argv[1] if len(sys.argv) > 1 else "cc"
        subprocess.run([cc, "-I", MCU, source, MCU / "scene.c", "-o", program], check=True)
        raw = subprocess.run([program], check=True, stdout=subprocess.PIPE).stdout
    both = numpy.frombuffer(raw, numpy.uint8).reshape(height, 2, width)
    return both[:, 0].copy(), both[:, 1].copy()


def reference_hash(width, height, disparities, block, mode):
    matcher = cv2.StereoSGBM_create(0, disparities, block, 8 * block**2, 32 * block**2, 1, 63, 10, 0, 0, mode)
    disparity = matcher.compute(*pixels(width, height, disparities))
    rows = range(height) if mode in (0, 2) else range(height - 1, -1, -1)  # the order in which rows come out
    data = b"".join(struct.pack("<H", y) + disparity[y].astype("<i2").tobytes() for y in rows)
    return zlib.crc32(data) ^ 0xFFFFFFFF


cv2.setNumThreads(1)
expected = dict(re.findall(r"#define EXPECT_(\w+) +0x([0-9a-f]+)u", (MCU / "expected.h").read_text()))
wrong = 0
for name, frame in FRAMES.items():
    got = f"{reference_hash(*frame):08x}"
    wrong += got != expected[name]
    print(f"{name}: {got} {'ok' if got == expected[name] else 'but expected.h says ' + expected[name]}")
sys.exit(1 if wrong else 0)
