# SPDX-License-Identifier: MIT
"""StereoSGBM with OpenCV's names, arguments and results."""
from __future__ import annotations

import ctypes
from typing import Any, Dict, Iterable, Iterator, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from ._native import ALIGN, MATCH_BYTES, Geometry, Image, Params, lib, status_name

StereoSGBM_MODE_SGBM = STEREO_SGBM_MODE_SGBM = 0
StereoSGBM_MODE_HH = STEREO_SGBM_MODE_HH = 1
StereoSGBM_MODE_SGBM_3WAY = STEREO_SGBM_MODE_SGBM_3WAY = 2
StereoSGBM_MODE_HH4 = STEREO_SGBM_MODE_HH4 = 3
StereoMatcher_DISP_SHIFT = STEREO_MATCHER_DISP_SHIFT = 4
StereoMatcher_DISP_SCALE = STEREO_MATCHER_DISP_SCALE = 16
MEMORY_PLANS = {"fast": 0, "small": 1}

# OpenCV's name of a parameter, the library's, and its place in the constructor
_FIELDS = {"minDisparity": "min_disparity", "numDisparities": "num_disparities", "blockSize": "block_size", "P1": "p1", "P2": "p2",
           "disp12MaxDiff": "disp12_max_diff", "preFilterCap": "pre_filter_cap", "uniquenessRatio": "uniqueness_ratio",
           "speckleWindowSize": "speckle_window_size", "speckleRange": "speckle_range"}
_OPENCV_NAME = {ours: theirs for theirs, ours in _FIELDS.items()}
_OPENCV_NAME.update(max_disparities="numDisparities", max_block_size="blockSize", max_p2="P2", max_pre_filter_cap="preFilterCap",
                    width="image width", height="image height")
_WIDE = ("speckleWindowSize", "speckleRange")


def _aligned(count: int) -> NDArray[np.uint8]:
    """`count` bytes, aligned as the library wants a workspace."""
    room = np.empty(count + ALIGN, np.uint8)
    skip = -room.ctypes.data % ALIGN
    return room[skip:skip + count]


def _integer(name: str, value: Any) -> int:
    bits = 31 if name in _WIDE else 15
    try:
        number = int(value.__index__())
    except AttributeError:
        raise TypeError(f"{name} must be an integer, not {type(value).__name__}") from None
    if not -2**bits <= number < 2**bits:
        raise ValueError(f"{name} = {number} is outside the domain: at most {2**bits - 1}")
    return number


def _frame(name: str, image: Any) -> NDArray[np.uint8]:
    array = np.asarray(image)
    if array.dtype != np.uint8:
        raise ValueError(f"{name}: pixels must be uint8, not {array.dtype}")
    if array.ndim == 3 and array.shape[2] == 1:
        array = array[:, :, 0]
    if array.ndim != 2 and (array.ndim != 3 or array.shape[2] != 3):
        raise ValueError(f"{name}: must be H x W or H x W x 3, not {' x '.join(map(str, array.shape)) or 'a scalar'}")
    if 0 in array.shape or max(array.shape) > 32767:
        raise ValueError(f"{name}: sides must be 1..32767, not {array.shape}")
    return array


def _borrow(array: NDArray[np.uint8]) -> Tuple[Image, NDArray[np.uint8]]:
    """The library's view of an image, and the array that must outlive it: a copy only where the strides cannot be told."""
    channels = array.shape[2] if array.ndim == 3 else 1
    if array.strides[1] < channels or (array.ndim == 3 and array.strides[2] != 1):
        array = np.ascontiguousarray(array)
    height, width = array.shape[:2]
    return Image(array.ctypes.data, width, height, channels, array.strides[1], array.strides[0]), array


class StereoSGBM:
    """A matcher; make it with StereoSGBM_create(). Its workspace is kept from one compute() to the next.

    Not to be used by two threads at once; matchers of their own share nothing, and compute() lets other threads run."""

    def __init__(self, **values: Any) -> None:
        self._values: Dict[str, int] = {}
        memory = values.pop("memory", "fast")
        if memory not in MEMORY_PLANS:
            raise ValueError(f"memory = {memory!r}: one of {', '.join(MEMORY_PLANS)}")
        self._memory = MEMORY_PLANS[memory]
        self.setMode(values.pop("mode"))
        for name, value in values.items():
            self._values[name] = _integer(name, value)
        self._match = _aligned(MATCH_BYTES)
        self._work = _aligned(0)
        self._labels = _aligned(0)
        self._bound: Optional[bytes] = None

    # -- what will be computed ------------------------------------------------------------------------------------------

    def params(self) -> Dict[str, int]:
        """The parameters that compute() takes, by the library's names, after the repairs that OpenCV makes in silence."""
        p = self._normalized()
        return {ours: int(getattr(p, ours)) for ours in _FIELDS.values()}

    def workspaceBytes(self, left: Any) -> int:
        """Bytes of workspace for images like this one, without the speckle filter's labels."""
        return int(lib.stad_match_bytes(self._geometry(_frame("left", left), self._normalized())))

    def _normalized(self) -> Params:
        if self._mode == StereoSGBM_MODE_SGBM_3WAY and self._values["blockSize"] <= 0:
            # OpenCV takes 3 for the block, but overlaps its stripes as for 5: no block size of the library's does that
            raise ValueError(f"blockSize = {self._values['blockSize']} in mode SGBM_3WAY: give the block size, at least 1")
        p = Params(**{_FIELDS[name]: value for name, value in self._values.items()})
        lib.stad_params_normalize(p, self._mode)
        return p

    def _geometry(self, image: NDArray[np.uint8], p: Params) -> Geometry:
        height, width = image.shape[:2]
        channels = image.shape[2] if image.ndim == 3 else 1
        return Geometry(width, height, channels, p.num_disparities, p.block_size, p.p2, p.pre_filter_cap, self._mode, self._memory)

    # -- computing --------------------------------------------------------------------------------------------------------

    def compute(self, left: Any, right: Any, disparity: Optional[NDArray[np.int16]] = None) -> NDArray[np.int16]:
        """Disparities * 16 as int16, H x W; (minDisparity - 1) * 16 where there is none. Written to `disparity` if given."""
        left, right = _frame("left", left), _frame("right", right)
        if left.shape != right.shape:
            raise ValueError(f"right: its shape {right.shape} is not that of left, {left.shape}")
        out = self._output(left, disparity)
        p = self._normalized()
        self._check(p, left.shape[1])
        self._bind(self._geometry(left, p))
        self._make_labels(p, left)
        (left_view, keep_left), (right_view, keep_right) = _borrow(left), _borrow(right)
        status = lib.stad_match_frame(self._match.ctypes.data, p, left_view, right_view, out.ctypes.data,
                                      out.strides[0] // 2, self._labels.ctypes.data if self._labels.size else None,
                                      self._labels.size)
        del keep_left, keep_right
        if status != 0:
            culprit = lib.stad_match_culprit(self._match.ctypes.data)
            raise self._refusal(culprit, status)
        return out

    def counts(self) -> Dict[str, int]:
        """What came of the last frame's pixels: considered, firm, rejected_uniqueness, rejected_check, valid, rejected_speckle."""
        if self._bound is None:
            raise ValueError("counts: nothing has been computed yet")
        c = lib.stad_match_counts_of(self._match.ctypes.data).contents
        return {name: int(getattr(c, name)) for name, _ in c._fields_}

    @staticmethod
    def _output(left: NDArray[np.uint8], disparity: Optional[NDArray[np.int16]]) -> NDArray[np.int16]:
        shape = left.shape[:2]
        if disparity is None:
            return np.empty(shape, np.int16)
        if not isinstance(disparity, np.ndarray) or disparity.dtype != np.int16 or disparity.shape != shape:
            raise ValueError(f"disparity: must be an int16 array of shape {shape}")
        if disparity.strides[1] != 2 or disparity.strides[0] % 2 or not disparity.flags.writeable:
            raise ValueError("disparity: must be writable, its rows without gaps")
        return disparity

    def _check(self, p: Params, width: int) -> None:
        culprit = ctypes.c_char_p()
        status = lib.stad_params_check(p, self._mode, width, ctypes.byref(culprit))
        if status != 0:
            raise self._refusal(culprit.value, status)

    def _bind(self, g: Geometry) -> None:
        if self._bound == bytes(g):
            return
        culprit = ctypes.c_char_p()
        status = lib.stad_geometry_check(g, ctypes.byref(culprit))
        if status != 0:
            raise self._refusal(culprit.value, status)
        wanted = lib.stad_match_bytes(g)
        if self._work.size < wanted:
            self._work = _aligned(wanted)
        status = lib.stad_match_init(self._match.ctypes.data, g, self._work.ctypes.data, self._work.size)
        if status != 0:
            raise self._refusal(None, status)
        self._bound = bytes(g)

    def _make_labels(self, p: Params, image: NDArray[np.uint8]) -> None:
        wanted = lib.stad_abi_speckle_bytes(image.shape[1], image.shape[0]) if p.speckle_window_size > 0 else 0
        if self._labels.size < wanted:
            self._labels = _aligned(wanted)

    def _refusal(self, culprit: Optional[bytes], status: int) -> ValueError:
        field = (culprit or b"").decode()
        name = _OPENCV_NAME.get(field, field)
        value = f" = {self._values[name]}" if name in self._values else ""
        return ValueError(f"{name}{value} is outside the domain for these images and mode {self._mode} ({status_name(status)})")

    @staticmethod
    def create(*values: Any, **named: Any) -> "StereoSGBM":
        """StereoSGBM_create() by its other name."""
        return StereoSGBM_create(*values, **named)

    # -- the mode, and OpenCV's few other calls -----------------------------------------------------------------------------

    def getMode(self) -> int:
        return self._mode

    def setMode(self, mode: int) -> None:
        if mode not in (0, 1, 2, 3):
            raise ValueError(f"mode = {mode}: one of 0 (SGBM), 1 (HH), 2 (SGBM_3WAY), 3 (HH4)")
        self._mode = int(mode)

    def getMinDisparity(self) -> int: return self._values["minDisparity"]
    def setMinDisparity(self, minDisparity: int) -> None: self._values["minDisparity"] = _integer("minDisparity", minDisparity)
    def getNumDisparities(self) -> int: return self._values["numDisparities"]
    def setNumDisparities(self, numDisparities: int) -> None:
        self._values["numDisparities"] = _integer("numDisparities", numDisparities)
    def getBlockSize(self) -> int: return self._values["blockSize"]
    def setBlockSize(self, blockSize: int) -> None: self._values["blockSize"] = _integer("blockSize", blockSize)
    def getP1(self) -> int: return self._values["P1"]
    def setP1(self, P1: int) -> None: self._values["P1"] = _integer("P1", P1)
    def getP2(self) -> int: return self._values["P2"]
    def setP2(self, P2: int) -> None: self._values["P2"] = _integer("P2", P2)
    def getDisp12MaxDiff(self) -> int: return self._values["disp12MaxDiff"]
    def setDisp12MaxDiff(self, disp12MaxDiff: int) -> None: self._values["disp12MaxDiff"] = _integer("disp12MaxDiff", disp12MaxDiff)
    def getPreFilterCap(self) -> int: return self._values["preFilterCap"]
    def setPreFilterCap(self, preFilterCap: int) -> None: self._values["preFilterCap"] = _integer("preFilterCap", preFilterCap)
    def getUniquenessRatio(self) -> int: return self._values["uniquenessRatio"]
    def setUniquenessRatio(self, uniquenessRatio: int) -> None:
        self._values["uniquenessRatio"] = _integer("uniquenessRatio", uniquenessRatio)
    def getSpeckleWindowSize(self) -> int: return self._values["speckleWindowSize"]
    def setSpeckleWindowSize(self, speckleWindowSize: int) -> None:
        self._values["speckleWindowSize"] = _integer("speckleWindowSize", speckleWindowSize)
    def getSpeckleRange(self) -> int: return self._values["speckleRange"]
    def setSpeckleRange(self, speckleRange: int) -> None: self._values["speckleRange"] = _integer("speckleRange", speckleRange)


def StereoSGBM_create(minDisparity: int = 0, numDisparities: int = 16, blockSize: int = 3, P1: int = 0, P2: int = 0,
                      disp12MaxDiff: int = 0, preFilterCap: int = 0, uniquenessRatio: int = 0, speckleWindowSize: int = 0,
                      speckleRange: int = 0, mode: int = StereoSGBM_MODE_SGBM, *, memory: str = "fast") -> StereoSGBM:
    """cv2.StereoSGBM_create, argument for argument; `memory` ("fast", "small") chooses the workspace, never the result."""
    return StereoSGBM(minDisparity=minDisparity, numDisparities=numDisparities, blockSize=blockSize, P1=P1, P2=P2,
                      disp12MaxDiff=disp12MaxDiff, preFilterCap=preFilterCap, uniquenessRatio=uniquenessRatio,
                      speckleWindowSize=speckleWindowSize, speckleRange=speckleRange, mode=mode, memory=memory)


def compute_frames(pairs: Iterable[Tuple[Any, Any]], jobs: int = 1, **parameters: Any) -> Iterator[NDArray[np.int16]]:
    """Disparities of many pairs, in order, `jobs` frames at a time on threads; parameters as StereoSGBM_create()."""
    from collections import deque
    from concurrent.futures import ThreadPoolExecutor
    if jobs < 1:
        raise ValueError(f"jobs = {jobs}: at least 1")
    idle = [StereoSGBM_create(**parameters) for _ in range(jobs)]

    def one(pair: Tuple[Any, Any]) -> NDArray[np.int16]:
        matcher = idle.pop()
        try:
            return matcher.compute(*pair)
        finally:
            idle.append(matcher)

    with ThreadPoolExecutor(jobs) as pool:
        running: Any = deque()
        for pair in pairs:
            running.append(pool.submit(one, pair))
            if len(running) >= jobs:
                yield running.popleft().result()
        while running:
            yield running.popleft().result()
