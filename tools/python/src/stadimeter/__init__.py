# SPDX-License-Identifier: MIT
"""Semi-global stereo matching in fixed point, bit for bit cv2.StereoSGBM, and a tuner of its parameters.

    import stadimeter as cv2s
    disparity = cv2s.StereoSGBM_create(0, 64, 5).compute(left, right)   # the array that cv2's would give
"""
from ._native import tier
from ._version import __version__
from .score import Scorer, label, truth_q16
from .sgbm import (MEMORY_PLANS, STEREO_SGBM_MODE_HH, STEREO_SGBM_MODE_HH4, STEREO_SGBM_MODE_SGBM, STEREO_SGBM_MODE_SGBM_3WAY,
                   StereoSGBM, StereoSGBM_create, StereoSGBM_MODE_HH, StereoSGBM_MODE_HH4, StereoSGBM_MODE_SGBM,
                   StereoSGBM_MODE_SGBM_3WAY, compute_frames)
from .tune import FAILED, Tuner, as_opencv, tune

__all__ = ["FAILED", "MEMORY_PLANS", "STEREO_SGBM_MODE_HH", "STEREO_SGBM_MODE_HH4", "STEREO_SGBM_MODE_SGBM",
           "STEREO_SGBM_MODE_SGBM_3WAY", "Scorer", "StereoSGBM", "StereoSGBM_MODE_HH", "StereoSGBM_MODE_HH4",
           "StereoSGBM_MODE_SGBM", "StereoSGBM_MODE_SGBM_3WAY", "StereoSGBM_create", "Tuner", "__version__", "as_opencv",
           "compute_frames", "label", "tier", "truth_q16", "tune"]
