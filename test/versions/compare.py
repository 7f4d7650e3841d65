#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""compare.py LIBRARY N SEED - N random cases a mode: the library behind bridge.c against this interpreter's OpenCV."""
import ctypes
import sys

import cv2
import numpy as np

MODES = ("sgbm", "hh", "3way", "hh4")
U8 = np.ctypeslib.ndpointer(np.uint8, flags="C")
I16 = np.ctypeslib.ndpointer(np.int16, flags="C")
INT = ctypes.POINTER(ctypes.c_int)


def load(path):
    lib = ctypes.CDLL(path)
    word, number = ctypes.c_uint32, ctypes.c_int
    lib.bridge_shape.argtypes = [word, word, number, INT]
    lib.bridge_params.argtypes = [word, word, number, INT]
    lib.bridge_images.argtypes = [word, word, number, U8, U8]
    lib.bridge_match.argtypes = [word, word, number, number, number, U8, U8, I16, ctypes.c_char_p, number]
    return lib


def difference(lib, seed, index, mode):
    """None, or a line that says how case `index` differs."""
    shape, params = (ctypes.c_int * 3)(), (ctypes.c_int * 10)()
    lib.bridge_shape(seed, index, mode, shape)
    lib.bridge_params(seed, index, mode, params)
    height, width, channels = shape
    size = (height, width) if channels == 1 else (height, width, 3)
    left, right = np.empty(size, np.uint8), np.empty(size, np.uint8)
    lib.bridge_images(seed, index, mode, left, right)
    expected = cv2.StereoSGBM_create(*params, mode).compute(left, right)
    text = ctypes.create_string_buffer(600)
    for memory in (0, 1):
        got = np.empty((height, width), np.int16)
        status = lib.bridge_match(seed, index, mode, memory, index & 1, left, right, got, text, 600)
        if status != 0 or not np.array_equal(expected, got):
            return f"status {status}, {int((expected != got).sum())} pixels differ: stad-verify {text.value.decode()}"
    return None


def main():
    path, count, seed = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    cv2.setNumThreads(1)
    lib, failed = load(path), 0
    for mode, name in enumerate(MODES):
        differing = 0
        for index in range(count):
            line = difference(lib, seed, index, mode)
            if line:
                differing += 1
                print(f"OpenCV {cv2.__version__} {name}: {line}")
        print(f"OpenCV {cv2.__version__} {name}: {count} cases, {differing} differ", flush=True)
        failed += differing
    sys.exit(1 if failed else 0)


main()
