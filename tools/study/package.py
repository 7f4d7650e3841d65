# SPDX-License-Identifier: MIT
"""The Python package of this very tree: `from package import stadimeter` builds its library when it has changed.

STADIMETER_LIBRARY names a ready one instead."""
import fcntl
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def build(folder, flags=""):
    """Builds the package's library with further compiler flags; returns its path."""
    quiet = {"check": True, "stdout": subprocess.DEVNULL}
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "lock"), "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        subprocess.run(["cmake", "-S", os.path.join(ROOT, "tools/python"), "-B", folder, f"-DCMAKE_C_FLAGS={flags}"], **quiet)
        subprocess.run(["cmake", "--build", folder, "-j2"], **quiet)
    return os.path.join(folder, "libstadimeter_native.so")


if "STADIMETER_LIBRARY" not in os.environ:
    os.environ["STADIMETER_LIBRARY"] = build(os.path.join(os.environ.get("STAD_BUILD", os.path.join(ROOT, "build-study")), "python"))
sys.path.insert(0, os.path.join(ROOT, "tools/python/src"))
import stadimeter  # noqa: E402, F401
