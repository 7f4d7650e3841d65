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
                ("budget", c_int16), ("patience", c_uint8), ("cheap_mask", c_uint8), ("seed", c_uint32), ("axis", Axis * DIMS), ("ladder", Point * LADDER)]


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


class Corner(ctypes.Structure):
    _fields_ = [("x_q8", c_int32), ("y_q8", c_int32)]


Corners = Corner * 4


class Mark(ctypes.Structure):
    _fields_ = [("id", c_int16), ("hamming", c_int16), ("corner", Corners)]


class Pair(ctypes.Structure):
    _fields_ = [("id", c_int16), ("left", Corners), ("right", Corners)]


class MarkConfig(ctypes.Structure):
    _fields_ = [("ids", c_uint32), ("max_hamming", c_uint8), ("min_contrast", c_uint8)]


class Camera(ctypes.Structure):
    _fields_ = [("f_q8", c_int32), ("cx_q8", c_int32), ("cy_q8", c_int32)]


class Rig(ctypes.Structure):
    _fields_ = [("a_q16", c_int32), ("b_q24", c_int32), ("c_q24", c_int32), ("width", c_int16), ("height", c_int16)]


class RigReport(ctypes.Structure):
    _fields_ = [("rms_before_q8", c_int32), ("rms_after_q8", c_int32), ("worst_q8", c_int32), ("span_q8", c_int32),
                ("corners", c_int16), ("verdict", c_uint8), ("advised", c_uint8)]


class Box(ctypes.Structure):
    _fields_ = [("x", c_int16), ("y", c_int16), ("width", c_int16), ("height", c_int16)]


class Request(ctypes.Structure):
    _fields_ = [("want", c_uint8), ("hold", c_uint8), ("box", Box), ("params", Params), ("rig", Rig)]


class Setup(ctypes.Structure):
    _fields_ = [("width", c_int16), ("height", c_int16), ("mode", c_uint8), ("channels", c_uint8), ("origin", c_uint8),
                ("corrected", c_uint8), ("params", Params), ("rig", Rig)]


class MonitorConfig(ctypes.Structure):
    _fields_ = [(name, c_int16) for name in ("learn_frames", "cooldown_frames", "slack_q8", "threshold_q8", "clip_q8",
                                             "follow_shift")] + [("floor_q16", c_int32), ("mark_every", c_int32)]


class CalibConfig(ctypes.Structure):
    _fields_ = [("geometry", Geometry), ("target", c_void_p), ("camera", Camera), ("monitor", MonitorConfig), ("ids", c_uint32)] + \
               [(name, c_int16) for name in ("margin_px", "pose_px", "patience", "probation_frames", "budget", "min_block_size")] + \
               [(name, c_int32) for name in ("threshold_q16", "penalty_q16", "gain_q20")] + \
               [(name, c_uint8) for name in ("cost", "rule", "preset_mask", "tunes", "still")]


class CalibReport(ctypes.Structure):
    _fields_ = [(name, c_uint8) for name in ("phase", "outcome", "fault", "alarmed", "verdict_before", "verdict_after")] + \
               [(name, c_int8) for name in ("preset", "tuned", "save_status")] + [("evaluations", c_int16)] + \
               [(name, c_int32) for name in ("tune_before_q20", "tune_after_q20", "judge_before_q20", "judge_after_q20")] + \
               [("rig", RigReport)]


# Places in abi.c: of the types that are mirrored here, and of those that stay opaque.
_MIRRORED = {0: Params, 1: Geometry, 2: Image, 4: MatchCounts, 5: TuneConfig, 7: TuneCounts, 8: ScoreConfig, 9: ScoreCounts,
             10: Score, 11: Mark, 12: Pair, 13: MarkConfig, 14: Camera, 15: Rig, 16: RigReport, 17: Request, 18: Setup,
             19: MonitorConfig, 20: CalibConfig, 21: CalibReport}
_MATCH, _TUNE, _TRUTH, _CALIB, _EVALUATOR = 3, 6, 22, 23, 24

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
    "stad_tune_check": (c_int, [c_void_p]),
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
    "stad_mark_config_default": (None, [POINTER(MarkConfig)]),
    "stad_mark_bytes": (c_size_t, [c_int32, c_int32]),
    "stad_mark_find": (c_int, [POINTER(Image), POINTER(MarkConfig), POINTER(Mark), c_int, c_void_p, c_size_t]),
    "stad_mark_pair": (c_int, [POINTER(Mark), c_int, POINTER(Mark), c_int, POINTER(Pair), c_int]),
    "stad_target_relief": (c_void_p, []),
    "stad_target_card": (c_void_p, []),
    "stad_truth_init": (c_int, [c_void_p, c_int, c_int, c_int, c_int, c_int]),
    "stad_truth_from_target": (c_int, [c_void_p, c_void_p, POINTER(Pair), c_int, POINTER(Camera)]),
    "stad_truth_row": (c_int, [c_void_p, c_int, c_int, c_void_p, c_void_p]),
    "stad_rig_identity": (None, [POINTER(Rig), c_int, c_int]),
    "stad_rig_fit": (c_int, [POINTER(Rig), POINTER(RigReport), POINTER(Pair), c_int, c_int, c_int]),
    "stad_rig_row": (c_int, [POINTER(Rig), POINTER(Image), c_int, c_void_p]),
    "stad_rig_straighten": (None, [POINTER(Rig), POINTER(Pair), c_int]),
    "stad_setup_pack": (None, [POINTER(Setup), c_uint32, c_void_p]),
    "stad_setup_unpack": (c_int, [c_void_p, c_size_t, POINTER(Setup), POINTER(c_uint32)]),
    "stad_params_sample": (None, [POINTER(Params), c_int, c_int, c_int]),
    "stad_calib_config_default": (None, [POINTER(CalibConfig), POINTER(Geometry), c_void_p, POINTER(Camera)]),
    "stad_calib_init": (c_int, [c_void_p, POINTER(CalibConfig), POINTER(Setup)]),
    "stad_calib_counts": (c_int, [c_void_p, POINTER(MatchCounts)]),
    "stad_calib_live": (c_int, [c_void_p, POINTER(Image), POINTER(Image)]),
    "stad_calib_start": (c_int, [c_void_p]),
    "stad_calib_cancel": (None, [c_void_p]),
    "stad_calib_want": (c_int, [c_void_p, POINTER(Request)]),
    "stad_calib_frame_bytes": (c_size_t, [c_int32, c_int32]),
    "stad_calib_frame": (c_int, [c_void_p, POINTER(Image), POINTER(Image), c_void_p, c_size_t]),
    "stad_calib_evaluate_bytes": (c_size_t, [POINTER(Geometry)]),
    "stad_calib_evaluate": (c_int32, [c_void_p, POINTER(Request), c_void_p, POINTER(Image), POINTER(Image), c_void_p, c_size_t]),
    "stad_calib_cost": (c_int, [c_void_p, c_int32]),
    "stad_calib_saved": (c_int, [c_void_p, c_int]),
    "stad_calib_setup": (POINTER(Setup), [c_void_p]),
    "stad_calib_report_of": (POINTER(CalibReport), [c_void_p]),
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
TRUTH_BYTES: int = lib.stad_abi_bytes(_TRUTH)
CALIB_BYTES: int = lib.stad_abi_bytes(_CALIB)
EVALUATOR_BYTES: int = lib.stad_abi_bytes(_EVALUATOR)
SETUP_BYTES = 60
PARAMS = [field[0] for field in Params._fields_]
MATCH_COUNTS = [field[0] for field in MatchCounts._fields_]
ALIGN = 64


def status_name(status: int) -> str:
    return str(lib.stad_status_name(status).decode())


def tier() -> str:
    """The kernels in use: c, sse41, avx2, avx512 (lowered by the environment variable STAD_ISA)."""
    return str(lib.stad_abi_tier().decode())
