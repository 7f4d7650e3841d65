# SPDX-License-Identifier: MIT
"""The C library through ctypes: its types, its functions, and the check that both sides agree on their sizes.

The shared object lies beside this file; the environment variable STADIMETER_LIBRARY names another one."""
from __future__ import annotations

import ctypes
import os
from ctypes import POINTER, c_char_p, c_int, c_int8, c_int16, c_int32, c_int64, c_size_t, c_ssize_t, c_uint8, c_uint32, c_void_p
from pathlib import Path

from ._version import __version__

DIMS, LADDER, TERMS = 6, 6, 11


class Params(ctypes.Structure):
    _fields_ = [(name, c_int16) for name in ("min_disparity", "num_disparities", "block_size", "p1", "p2", "disp12_max_diff",
                                             "pre_filter_cap", "uniqueness_ratio")] + \
               [("speckle_window_size", c_int32), ("speckle_range", c_int32)]


class Geometry(ctypes.Structure):
    _fields_ = [(name, c_int16) for name in ("width", "height", "channels", "max_disparities", "max_block_size", "max_p2",
                                             "max_pre_filter_cap")] + [("mode", c_uint8), ("memory", c_uint8)]


class Image(ctypes.Structure):
    _fields_ = [("pix", c_void_p), ("width", c_int32), ("height", c_int32), ("channels", c_int32), ("pixel_stride", c_int32),
                ("row_stride", c_ssize_t)]


class MatchCounts(ctypes.Structure):
    _fields_ = [(name, c_int32) for name in ("considered", "firm", "rejected_uniqueness", "rejected_check", "valid",
                                             "rejected_speckle")]


class Axis(ctypes.Structure):
    _fields_ = [("lo", c_int16), ("hi", c_int16), ("unit", c_int16), ("scale", c_uint8), ("side", c_int8)]


Point = c_int16 * DIMS


class TuneConfig(ctypes.Structure):
    _fields_ = [("method", c_uint8), ("free_mask", c_uint8), ("ordered", c_uint8), ("ladder_count", c_uint8),
                ("budget", c_int16), ("patience", c_int16), ("seed", c_uint32), ("axis", Axis * DIMS), ("ladder", Point * LADDER)]


class TuneCounts(ctypes.Structure):
    _fields_ = [("evaluations", c_int16), ("iterations", c_int16), ("calls", c_int32)]


class ScoreConfig(ctypes.Structure):
    _fields_ = [("min_disparity", c_int16), ("num_disparities", c_int16), ("threshold_q16", c_int32), ("cost", c_uint8),
                ("photo_limit", c_uint8), ("weight_q8", c_int16 * TERMS)]


class ScoreCounts(ctypes.Structure):
    _fields_ = [(name, c_int32) for name in ("visible", "occluded", "wrong_visible", "wrong_occluded", "missing_visible",
                                             "missing_occluded", "d1_visible", "d1_occluded")] + \
               [("square_sum_q16", c_int64), ("abs_sum_q16", c_int64)] + \
               [(name, c_int32) for name in ("considered", "matched", "speckle", "inconsistent")] + [("photo_sum", c_int64)]


class Score(ctypes.Structure):
    _fields_ = [("config", ScoreConfig), ("counts", ScoreCounts), ("histogram", c_int32 * 32)]


_MATCH, _TUNE = 3, 6  # places in abi.c of the two types that stay opaque here
_MIRRORED = {0: Params, 1: Geometry, 2: Image, 4: MatchCounts, 5: TuneConfig, 7: TuneCounts, 8: ScoreConfig, 9: ScoreCounts,
             10: Score}

_SIGNATURES = {
    "stad_status_name": (c_char_p, [c_int]),
    "stad_params_normalize": (c_int, [POINTER(Params), c_int]),
    "stad_params_check": (c_int, [POINTER(Params), c_int, c_int, POINTER(c_char_p)]),
    "stad_match_bytes": (c_size_t, [POINTER(Geometry)]),
    "stad_match_part": (c_size_t, [POINTER(Geometry), c_int, POINTER(c_char_p)]),
    "stad_geometry_check": (c_int, [POINTER(Geometry), POINTER(c_char_p)]),
    "stad_match_init": (c_int, [c_void_p, POINTER(Geometry), c_void_p, c_size_t]),
    "stad_match_frame": (c_int, [c_void_p, POINTER(Params), POINTER(Image), POINTER(Image), c_void_p, c_ssize_t, c_void_p,
                                 c_size_t]),
    "stad_match_culprit": (c_char_p, [c_void_p]),
    "stad_match_counts_of": (POINTER(MatchCounts), [c_void_p]),
    "stad_tune_config_stereo": (None, [POINTER(TuneConfig), c_int]),
    "stad_tune_config_check": (c_int, [POINTER(TuneConfig), POINTER(c_char_p)]),
    "stad_tune_init": (c_int, [c_void_p, POINTER(TuneConfig), POINTER(Point)]),
    "stad_tune_ask": (c_int, [c_void_p, POINTER(Point)]),
    "stad_tune_tell": (c_int, [c_void_p, c_int32]),
    "stad_tune_best": (c_int, [c_void_p, POINTER(Point), POINTER(c_int32)]),
    "stad_tune_trace": (c_int, [c_void_p, c_int, POINTER(Point), POINTER(c_int32)]),
    "stad_tune_counts_of": (TuneCounts, [c_void_p]),
    "stad_score_config_init": (None, [POINTER(ScoreConfig), c_int, c_int, c_int]),
    "stad_score_begin": (c_int, [POINTER(Score), POINTER(ScoreConfig)]),
    "stad_score_row": (None, [POINTER(Score), c_int, c_void_p, c_void_p, c_void_p, c_int]),
    "stad_score_row_blind": (None, [POINTER(Score), c_int, c_void_p, c_void_p, c_void_p, c_int]),
    "stad_score_frame_blind": (None, [POINTER(Score), c_int32, c_int32]),
    "stad_score_end": (c_int32, [POINTER(Score)]),
    "stad_score_cost_of": (c_int32, [POINTER(Score), c_int]),
    "stad_score_rmse_q16": (c_int32, [POINTER(Score)]),
    "stad_score_mae_q16": (c_int32, [POINTER(Score)]),
    "stad_score_label_row": (None, [c_void_p, c_int, c_void_p, c_void_p]),
    "stad_abi_version": (c_char_p, []),
    "stad_abi_bytes": (c_uint32, [c_int]),
    "stad_abi_tier": (c_char_p, []),
    "stad_abi_speckle_bytes": (c_size_t, [c_int32, c_int32]),
}


def _load() -> ctypes.CDLL:
    path = os.environ.get("STADIMETER_LIBRARY") or str(Path(__file__).with_name("libstadimeter_native.so"))
    try:
        library = ctypes.CDLL(path)
    except OSError as error:
        raise ImportError(f"stadimeter: cannot load {path}: {error}; install the package (pip install ./tools/python) or set "
                          "STADIMETER_LIBRARY") from error
    for name, (result, arguments) in _SIGNATURES.items():
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    version = library.stad_abi_version().decode()
    wrong = [t.__name__ for i, t in _MIRRORED.items() if library.stad_abi_bytes(i) != ctypes.sizeof(t)]
    if version != __version__ or wrong:
        raise ImportError(f"stadimeter: {path} is version {version}, this package {__version__}; types that differ: {wrong}")
    return library


lib = _load()
MATCH_BYTES: int = lib.stad_abi_bytes(_MATCH)
TUNE_BYTES: int = lib.stad_abi_bytes(_TUNE)
ALIGN = 64


def status_name(status: int) -> str:
    return lib.stad_status_name(status).decode()


def tier() -> str:
    """The kernels in use: c, sse41, avx2, avx512 (lowered by the environment variable STAD_ISA)."""
    return lib.stad_abi_tier().decode()
