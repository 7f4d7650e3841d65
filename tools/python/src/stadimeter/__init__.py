# SPDX-License-Identifier: MIT
"""Semi-global stereo matching in fixed point, bit for bit cv2.StereoSGBM, and a tuner of its parameters.

    import stadimeter as cv2s
    disparity = cv2s.StereoSGBM_create(0, 64, 5).compute(left, right)   # the array that cv2's would give
"""
from ._native import tier
from ._version import __version__
from .marks import Mark, Pair, Rig, find_marks, fit_rig, pair_marks, target_truth
from .score import Scorer, label, truth_q16
from .sgbm import (MEMORY_PLANS, STEREO_MATCHER_DISP_SCALE, STEREO_MATCHER_DISP_SHIFT, STEREO_SGBM_MODE_HH, STEREO_SGBM_MODE_HH4,
                   STEREO_SGBM_MODE_SGBM, STEREO_SGBM_MODE_SGBM_3WAY, StereoMatcher_DISP_SCALE, StereoMatcher_DISP_SHIFT,
                   StereoSGBM, StereoSGBM_create, StereoSGBM_MODE_HH, StereoSGBM_MODE_HH4, StereoSGBM_MODE_SGBM,
                   StereoSGBM_MODE_SGBM_3WAY, compute_frames)
from .simulate import Board, Run, Simulation, Step, simulate
from .tune import FAILED, Tuner, as_opencv, tune

__all__ = ["Board", "FAILED", "MEMORY_PLANS", "Mark", "Pair", "Rig", "Run", "STEREO_MATCHER_DISP_SCALE",
           "STEREO_MATCHER_DISP_SHIFT", "STEREO_SGBM_MODE_HH", "STEREO_SGBM_MODE_HH4", "STEREO_SGBM_MODE_SGBM",
           "STEREO_SGBM_MODE_SGBM_3WAY", "Scorer", "Simulation", "Step", "StereoMatcher_DISP_SCALE", "StereoMatcher_DISP_SHIFT",
           "StereoSGBM", "StereoSGBM_MODE_HH", "StereoSGBM_MODE_HH4", "StereoSGBM_MODE_SGBM", "StereoSGBM_MODE_SGBM_3WAY",
           "StereoSGBM_create", "Tuner", "__version__", "as_opencv", "compute_frames", "find_marks", "fit_rig", "label",
           "pair_marks", "simulate", "target_truth", "tier", "truth_q16", "tune"]
