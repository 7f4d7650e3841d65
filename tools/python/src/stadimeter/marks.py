# SPDX-License-Identifier: MIT
"""Fiducial marks (AprilTag 36h11, identities 0..31) in stereo pairs, and what they tell: is the rig sound, and what is the truth.

Corners are in pixels, (0, 0) the centre of the first one; what the library found is a multiple of 1/256."""
from __future__ import annotations

import ctypes
from typing import Any, Dict, Iterable, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _native as native
from ._native import lib, status_name
from .sgbm import _aligned, _borrow, _frame

TARGETS = {"relief": "stad_target_relief", "card": "stad_target_card"}
VERDICTS = ("good", "watch", "correct", "fail")
MOST = 32


class Mark(NamedTuple):
    """A mark in one image; corners 4 x 2: top left, top right, bottom right, bottom left as printed."""
    id: int
    hamming: int
    corners: NDArray[np.float64]


class Pair(NamedTuple):
    """The same mark in both views."""
    id: int
    left: NDArray[np.float64]
    right: NDArray[np.float64]


def _points(corners: Any) -> NDArray[np.float64]:
    return np.array([(c.x_q8, c.y_q8) for c in corners]) / 256.0


def _corners(points: Any) -> Any:
    return native.Corners(*[native.Corner(round(float(x) * 256), round(float(y) * 256)) for x, y in np.asarray(points).reshape(4, 2)])


def find_marks(image: Any, ids: Optional[Iterable[int]] = None, max_hamming: int = 2, min_contrast: int = 20) -> List[Mark]:
    """The marks of an image, uint8, H x W or H x W x 3 (green is used); sides of 16..2048 px. ids: only these."""
    view, keep = _borrow(_frame("image", image))
    config = native.MarkConfig()
    lib.stad_mark_config_default(config)
    if ids is not None:
        config.ids = sum(1 << i for i in set(ids)) & 0xFFFFFFFF
    if not 0 <= max_hamming <= 2 or not 8 <= min_contrast <= 128:
        raise ValueError(f"max_hamming = {max_hamming}, min_contrast = {min_contrast}: 0..2 and 8..128")
    config.max_hamming, config.min_contrast = max_hamming, min_contrast
    work = _aligned(lib.stad_mark_bytes(view.width, view.height))
    found = (native.Mark * MOST)()
    count = lib.stad_mark_find(view, config, found, MOST, work.ctypes.data, work.size)
    del keep
    if count < 0:
        raise ValueError(f"image: sides must be 16..2048, not {view.width} x {view.height} ({status_name(count)})")
    return [Mark(m.id, m.hamming, _points(m.corner)) for m in found[:count]]


def pair_marks(left: Sequence[Mark], right: Sequence[Mark]) -> List[Pair]:
    """Marks that are exactly once in each view, in the order of `left`."""
    views = [(native.Mark * len(marks))(*[native.Mark(m.id, m.hamming, _corners(m.corners)) for m in marks]) for marks in (left, right)]
    pairs = (native.Pair * max(len(left), 1))()
    count = lib.stad_mark_pair(views[0], len(left), views[1], len(right), pairs, len(left))
    return [Pair(p.id, _points(p.left), _points(p.right)) for p in pairs[:max(count, 0)]]


def _native_pairs(pairs: Sequence[Pair]) -> Any:
    return (native.Pair * max(len(pairs), 1))(*[native.Pair(p.id, _corners(p.left), _corners(p.right)) for p in pairs])


class Rig:
    """A correction of the right view by rows, fitted to the marks of raw pairs; fit_rig() makes it."""

    def __init__(self, rig: native.Rig, report: native.RigReport) -> None:
        self._rig = rig
        self.verdict: str = VERDICTS[report.verdict]
        self.advised: bool = bool(report.advised)
        self.report: Dict[str, float] = {"rms_before": report.rms_before_q8 / 256, "rms_after": report.rms_after_q8 / 256,
                                         "worst": report.worst_q8 / 256, "span": report.span_q8 / 256,
                                         "corners": report.corners}

    def apply(self, right: Any) -> NDArray[np.uint8]:
        """The right view as it should have been."""
        return correct(self._rig, _frame("right", right))

    def straighten(self, pairs: Sequence[Pair]) -> List[Pair]:
        """Pairs of raw views as the corrected ones would show them."""
        moved = _native_pairs(pairs)
        lib.stad_rig_straighten(self._rig, moved, len(pairs))
        return [Pair(p.id, _points(p.left), _points(p.right)) for p in moved[:len(pairs)]]


def correct(rig: native.Rig, right: NDArray[np.uint8]) -> NDArray[np.uint8]:
    view, keep = _borrow(right)
    out = np.empty(right.shape, np.uint8)
    for y in range(view.height):
        status = lib.stad_rig_row(rig, view, y, out[y].ctypes.data)
        if status != 0:
            raise ValueError(f"right: {view.width} x {view.height} is not what the rig was fitted for ({status_name(status)})")
    del keep
    return out


def fit_rig(pairs: Sequence[Pair], width: int, height: int) -> Rig:
    """Do the rows of both views agree? Pairs of several poses of raw frames make the answer sure."""
    rig, report = native.Rig(), native.RigReport()
    status = lib.stad_rig_fit(rig, report, _native_pairs(pairs), len(pairs), width, height)
    if status < 0:
        raise ValueError(f"width = {width}, height = {height}: 16..2048 each ({status_name(status)})")
    return Rig(rig, report)


def camera(focal: float, width: int, height: int, center: Optional[Tuple[float, float]] = None) -> native.Camera:
    cx, cy = center if center is not None else ((width - 1) / 2, (height - 1) / 2)
    return native.Camera(int(focal * 256 + 0.5), int(cx * 256 + 0.5), int(cy * 256 + 0.5))


def target_truth(pairs: Sequence[Pair], width: int, height: int, numDisparities: int, focal: float, minDisparity: int = 0,
                 center: Optional[Tuple[float, float]] = None, target: str = "relief",
                 margin: int = 1) -> Tuple[NDArray[np.int32], NDArray[np.uint8]]:
    """What the disparity must be where a printed target says so: truth (px * 65536) and labels, as Scorer.add() takes them."""
    if target not in TARGETS:
        raise ValueError(f"target = {target!r}: one of {', '.join(TARGETS)}")
    truth = ctypes.create_string_buffer(native.TRUTH_BYTES)
    status = lib.stad_truth_init(truth, width, height, minDisparity, numDisparities, margin)
    if status == 0:
        table = getattr(lib, TARGETS[target])()
        status = lib.stad_truth_from_target(truth, table, _native_pairs(pairs), len(pairs),
                                            camera(focal, width, height, center))
    if status < 0:
        raise ValueError(f"no truth from these {len(pairs)} pairs of marks: {status_name(status)}")
    rows, labels = np.zeros((height, width), np.int32), np.zeros((height, width), np.uint8)
    for y in range(height):
        lib.stad_truth_row(truth, y, width, rows[y].ctypes.data, labels[y].ctypes.data)
    return rows, labels
