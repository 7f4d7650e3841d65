# SPDX-License-Identifier: MIT
"""Recordings drawn by `stad scene`, and how to read them; what the tests of the Python package share."""
import os
import subprocess
import unittest
from pathlib import Path

import numpy as np

STAD = Path(os.environ["STAD_BUILD"]) / "stad"


def stad(*arguments, status=0):
    """Runs the tool; its standard output."""
    done = subprocess.run([STAD, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == status, f"stad {' '.join(map(str, arguments))}: status {done.returncode}: {done.stderr}"
    return done.stdout


def read_pgm(path):
    head, size, most, pixels = Path(path).read_bytes().split(b"\n", 3)
    assert (head, most) == (b"P5", b"255")
    width, height = map(int, size.split())
    return np.frombuffer(pixels, np.uint8).reshape(height, width)


def recording(folder, frames, **options):
    """Pairs of a drawn recording of the target."""
    words = [word for name, value in options.items() for word in (f"--{name}", value)]
    stad("scene", "-o", folder, "--target", "--pgm", "--frames", frames, "--width", 320, "--height", 240, *words)
    return [(read_pgm(f"{folder}/{i:03d}_left.pgm"), read_pgm(f"{folder}/{i:03d}_right.pgm")) for i in range(frames)]


main = unittest.main
