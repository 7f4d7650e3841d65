# SPDX-License-Identifier: MIT
"""Frames and truth from files, as the command line reads them. Pillow reads the pictures; .npy and .pfm need numpy alone."""
from __future__ import annotations

import os
from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray

from .score import NONE_Q16, truth_q16


def _picture(path: str) -> NDArray[Any]:
    try:
        from PIL import Image, UnidentifiedImageError
    except ImportError:
        raise ImportError("stadimeter.files: pictures need Pillow; pip install 'stadimeter[study]' brings it") from None
    try:
        with Image.open(path) as image:
            return np.asarray(image.convert("RGB") if image.mode in ("P", "RGBA") else image)
    except (UnidentifiedImageError, SyntaxError, OSError) as error:
        if isinstance(error, FileNotFoundError):
            raise
        raise ValueError(f"{path}: not a picture that can be read: {error}") from None


def read_grey(path: str) -> NDArray[np.uint8]:
    """An 8-bit picture or .npy as grey; colour is converted as cv2.cvtColor does."""
    array = np.load(path, allow_pickle=False) if path.endswith(".npy") else _picture(path)
    if array.dtype != np.uint8 or array.ndim not in (2, 3):
        raise ValueError(f"{path}: 8-bit pixels are wanted, not {array.dtype}")
    if array.ndim == 2:
        return np.ascontiguousarray(array)
    red, green, blue = (array[:, :, c].astype(np.uint32) for c in range(3))
    return ((9798 * red + 19235 * green + 3735 * blue + 16384) >> 15).astype(np.uint8)


def read_pfm(path: str) -> NDArray[np.float32]:
    with open(path, "rb") as file:
        kind, size, scale = (file.readline().split() for _ in range(3))
        if kind != [b"Pf"] or len(size) != 2 or len(scale) != 1:
            raise ValueError(f"{path}: no PFM of one channel")
        width, height = int(size[0]), int(size[1])
        data = np.frombuffer(file.read(), "<f4" if float(scale[0]) < 0 else ">f4")
    if width <= 0 or height <= 0 or data.size != width * height:
        raise ValueError(f"{path}: {data.size} pixels, not {width} x {height}")
    return data.reshape(height, width)[::-1].astype(np.float32)


def read_truth(path: str, scale: float = 0.0, min_disparity: int = 0) -> NDArray[np.int32]:
    """Truth in px * 65536: .pfm, .npy (int16: * 16), 16-bit .png (* 256), 8-bit pictures with a scale; 0 in a picture is none."""
    if path.endswith(".pfm"):
        return truth_q16(read_pfm(path))
    if path.endswith(".npy"):
        array = np.load(path, allow_pickle=False)
        if array.dtype == np.int16:
            return np.where(array < 16 * min_disparity, NONE_Q16, array.astype(np.int32) * 4096).astype(np.int32)
        return truth_q16(array)
    array = _picture(path)
    deep = array.dtype != np.uint8
    if array.ndim != 2 or (not deep and scale <= 0):
        raise ValueError(f"{path}: truth of 8 bits needs a truth_scale" if array.ndim == 2 else f"{path}: truth has one channel")
    return np.where(array == 0, NONE_Q16, np.rint(array * (65536.0 / (scale if scale > 0 else 256.0)))).astype(np.int32)


def mask_labels(rows: NDArray[np.int32], path: str) -> NDArray[np.uint8]:
    """Labels from a mask: 0 and 128 are hidden from the right camera, anything else is visible."""
    mask = read_grey(path)
    if mask.shape != rows.shape:
        raise ValueError(f"{path}: its shape {mask.shape} is not the truth's, {rows.shape}")
    return np.where(rows == NONE_Q16, 0, np.where((mask == 0) | (mask == 128), 2, 1)).astype(np.uint8)


def stamp(path: Optional[str]) -> Optional[list[Any]]:
    """What tells a file from another or a later one: name, bytes, time of change."""
    if path is None:
        return None
    status = os.stat(path)
    return [os.path.abspath(path), status.st_size, status.st_mtime_ns]
