# SPDX-License-Identifier: MIT
"""What the benchmarks share: builds of the library, image pairs, the sizes and modes they take."""
import os
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
RESULTS = os.path.join(ROOT, "tools/bench/results")
MODES = {"sgbm": 0, "hh": 1, "3way": 2, "hh4": 3}
# (width, height, disparities): those of the geometric means, and narrow ones
WIDE = [(640, 480, 64), (640, 480, 128), (1280, 720, 128)]
NARROW = [(160, 120, 32), (96, 64, 16)]
# name -> (build, value of STAD_ISA): the tiers that one x86 build holds, and plain C as the compiler vectorises it
TIERS = {"avx512": ("x86", "avx512"), "avx2": ("x86", "avx2"), "sse41": ("x86", "sse41"), "c": ("x86", "c"),
         "plain-c-avx2": ("plain", "c")}
BUILDS = {"x86": [], "plain": ["-DSTAD_ISA=wide", "-DCMAKE_C_FLAGS=-mavx2", "-DCMAKE_C_FLAGS_RELEASE=-O3 -DNDEBUG"]}


def build(name, folder):
    """Builds the shared object of a variant; returns its path."""
    folder = os.path.join(folder, name)
    quiet = {"check": True, "stdout": subprocess.DEVNULL}
    subprocess.run(["cmake", "-S", os.path.join(ROOT, "tools/python"), "-B", folder, *BUILDS[name]], **quiet)
    subprocess.run(["cmake", "--build", folder, "-j", "2"], **quiet)
    return os.path.join(folder, "libstadimeter_native.so")


def environment(library, isa):
    paths = [os.path.join(ROOT, "tools/python/src"), os.path.join(ROOT, "tools/bench"), os.environ.get("PYTHONPATH", "")]
    return dict(os.environ, STADIMETER_LIBRARY=library, STAD_ISA=isa, PYTHONPATH=os.pathsep.join(filter(None, paths)),
                OMP_NUM_THREADS="1", OPENCV_FOR_THREADS_NUM="1")


def pair(width, height, disparities, seed=1):
    """A textured pair: bands at disparities over the whole range, a little noise in the right view."""
    import cv2
    import numpy as np
    noise = np.random.default_rng(seed)
    base = cv2.GaussianBlur(noise.integers(0, 256, (height, width + disparities), np.uint8), (0, 0), 1.1)
    base = cv2.normalize(base, None, 0, 255, cv2.NORM_MINMAX)
    left, right = base[:, :width].copy(), np.empty((height, width), np.uint8)
    bands = 12
    for band in range(bands):
        rows = slice(band * height // bands, (band + 1) * height // bands)
        shift = (band * 5 % bands) * (disparities - 2) // (bands - 1)
        right[rows] = base[rows, shift:shift + width]
    noisy = right.astype(np.int16) + noise.integers(-4, 5, right.shape)
    return left, np.clip(noisy, 0, 255).astype(np.uint8)


def parameters(disparities, block, mode):
    """Those of OpenCV's stereo_match sample."""
    return dict(minDisparity=0, numDisparities=disparities, blockSize=block, P1=8 * block * block, P2=32 * block * block,
                disp12MaxDiff=1, preFilterCap=63, uniquenessRatio=10, speckleWindowSize=0, speckleRange=0, mode=MODES[mode])


def machine():
    """Name of the processor and of the compiler."""
    cpu = "unknown"
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as lines:
            fields = dict(line.split(":", 1) for line in lines if ":" in line and "processor" not in line)
        fields = {key.strip(): value.strip() for key, value in fields.items()}
        cpu = f"{fields.get('model name', '?')} family {fields.get('cpu family', '?')} model {fields.get('model', '?')}"
    except OSError:
        pass
    compiler = subprocess.run(["cc", "--version"], capture_output=True, text=True).stdout.splitlines()[0]
    return cpu, compiler
