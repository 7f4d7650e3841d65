# SPDX-License-Identifier: MIT
"""Disparity maps against truth: the library's exact counts and costs."""
from __future__ import annotations

from typing import Any, Dict, Optional

import numpy as np
from numpy.typing import NDArray

from ._native import Score, ScoreConfig, lib

NONE_Q16 = -2**31
IGNORED, VISIBLE, OCCLUDED = 0, 1, 2
COSTS = {"bad": 0, "chow": 1, "d1": 2, "rmse": 3, "mae": 4, "missing": 5, "blind": 6, "photo": 7, "speckle": 8, "lr": 9,
         "entropy": 10}
FAILED_Q20 = 2**31 - 1


def truth_q16(truth: Any) -> NDArray[np.int32]:
    """Truth in the library's form: px * 65536. Floats: NaN and infinities are no truth; int32 is taken as it is."""
    array = np.asarray(truth)
    if array.dtype == np.int32:
        return np.ascontiguousarray(array)
    if array.dtype.kind != "f":
        raise ValueError(f"truth: float pixels or int32 pixels * 65536, not {array.dtype}")
    known = np.isfinite(array)
    return np.where(known, np.rint(np.where(known, array, 0) * 65536.0), NONE_Q16).astype(np.int32)


def label(truth: Any) -> NDArray[np.uint8]:
    """VISIBLE, OCCLUDED or IGNORED for every pixel of dense truth, by the occluder's own truth."""
    rows = truth_q16(truth)
    height, width = rows.shape
    out, work = np.zeros((height, width), np.uint8), np.zeros(width, np.int32)
    for y in range(height):
        lib.stad_score_label_row(rows[y].ctypes.data, width, out[y].ctypes.data, work.ctypes.data)
    return out


class Scorer:
    """Counts over any number of frames: add() each, then read cost(), counts(), rmse(), mae()."""

    def __init__(self, numDisparities: int, minDisparity: int = 0, cost: str = "bad", threshold: float = 1.0) -> None:
        if cost not in COSTS:
            raise ValueError(f"cost = {cost!r}: one of {', '.join(COSTS)}")
        if numDisparities <= 0:
            raise ValueError(f"numDisparities = {numDisparities}: more than 0")
        if not 0 <= threshold < 32768:
            raise ValueError(f"threshold = {threshold}: 0..32767 px")
        config = ScoreConfig()
        lib.stad_score_config_init(config, COSTS[cost], minDisparity, numDisparities)
        config.threshold_q16 = round(threshold * 65536)
        self._score = Score()
        if lib.stad_score_begin(self._score, config) != 0:
            raise ValueError("numDisparities, minDisparity or threshold: outside the domain")

    def add(self, disparity: Any, truth: Any, labels: Optional[NDArray[np.uint8]] = None) -> None:
        """A frame: int16 px * 16, truth as truth_q16() takes it, labels as label() makes them (the default)."""
        disp, rows = np.ascontiguousarray(disparity), truth_q16(truth)
        marks = np.ascontiguousarray(label(rows) if labels is None else labels, np.uint8)
        if disp.dtype != np.int16 or disp.ndim != 2:
            raise ValueError(f"disparity: must be int16, H x W, not {disp.dtype} {disp.shape}")
        for name, array in (("truth", rows), ("labels", marks)):
            if array.shape != disp.shape:
                raise ValueError(f"{name}: its shape {array.shape} is not that of the disparity, {disp.shape}")
        (d, t, m), width = (array.ctypes.data for array in (disp, rows, marks)), disp.shape[1]
        for y in range(disp.shape[0]):
            at = y * width
            lib.stad_score_row(self._score, y, d + 2 * at, t + 4 * at, m + at, width)

    def add_blind(self, disparity: Any, left: Any, right: Any, counts: Dict[str, int]) -> None:
        """A frame without truth: the grey images it came from, and StereoSGBM.counts()."""
        disp = np.ascontiguousarray(disparity, np.int16)
        images = [np.ascontiguousarray(image, np.uint8) for image in (left, right)]
        for name, image in zip(("left", "right"), images):
            if image.shape != disp.shape:
                raise ValueError(f"{name}: its shape {image.shape} is not that of the disparity, {disp.shape}")
        for y in range(disp.shape[0]):
            lib.stad_score_row_blind(self._score, y, disp[y].ctypes.data, images[0][y].ctypes.data, images[1][y].ctypes.data,
                                     disp.shape[1])
        lib.stad_score_frame_blind(self._score, counts["rejected_speckle"], counts["rejected_check"])

    def cost_q20(self) -> int:
        """The cost as the tuner takes it; FAILED_Q20 while no pixel has been scored."""
        return int(lib.stad_score_end(self._score))

    def cost(self, name: Optional[str] = None) -> float:
        """The configured cost, or another one from the same counts, as a fraction; NaN while no pixel has been scored."""
        if name is not None and name not in COSTS:
            raise ValueError(f"cost = {name!r}: one of {', '.join(COSTS)}")
        value = self.cost_q20() if name is None else int(lib.stad_score_cost_of(self._score, COSTS[name]))
        return float("nan") if value == FAILED_Q20 else value / 2**20

    def rmse(self) -> float:
        return float(lib.stad_score_rmse_q16(self._score) / 65536)

    def mae(self) -> float:
        return float(lib.stad_score_mae_q16(self._score) / 65536)

    def counts(self) -> Dict[str, int]:
        c = self._score.counts
        return {name: int(getattr(c, name)) for name, _ in c._fields_}
