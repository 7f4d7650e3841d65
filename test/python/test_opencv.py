# SPDX-License-Identifier: MIT
"""The drop-in beside cv2 in one process: names, getters and setters, arrays, and a script that changes one line."""
import unittest

import cv2
import numpy as np
import stadimeter

from scenes import main

NAMES = ("MinDisparity", "NumDisparities", "BlockSize", "P1", "P2", "Disp12MaxDiff", "PreFilterCap", "UniquenessRatio",
         "SpeckleWindowSize", "SpeckleRange", "Mode")
SCRIPT = """
import {module} as stereo
matcher = stereo.StereoSGBM.create(minDisparity=-8, numDisparities=32, blockSize=5, P1=200, P2=800, disp12MaxDiff=1,
                                   uniquenessRatio=5, speckleWindowSize=40, speckleRange=2, mode=stereo.STEREO_SGBM_MODE_HH)
matcher.setPreFilterCap(31)
disparity = matcher.compute(left, right).astype("float32") / stereo.STEREO_MATCHER_DISP_SCALE
"""


def draw(rng):
    """Arguments as people give them, silent repairs of OpenCV's included."""
    block = int(rng.choice([1, 3, 4, 5, 7, 9]))
    p1 = int(rng.integers(0, 40)) * block * block
    return dict(minDisparity=int(rng.integers(-20, 20)), numDisparities=int(rng.choice([16, 32, 48])), blockSize=block, P1=p1,
                P2=p1 + int(rng.integers(-3, 900)), disp12MaxDiff=int(rng.integers(-1, 4)), preFilterCap=int(rng.integers(0, 70)),
                uniquenessRatio=int(rng.integers(-1, 30)), speckleWindowSize=int(rng.choice([0, 0, 30])),
                speckleRange=int(rng.integers(0, 3)), mode=int(rng.integers(0, 4)))


def pair(rng, channels):
    left = rng.integers(0, 256, (45, 130) + ((3,) if channels == 3 else ()), dtype=np.uint8)
    left = cv2.blur(left, (3, 3))
    right = np.clip(np.roll(left, -7, axis=1).astype(int) + rng.integers(-9, 10, left.shape), 0, 255).astype(np.uint8)
    return left, right


class BesideOpenCV(unittest.TestCase):
    def test_arrays_of_random_parameters_equal(self):
        for seed in range(120):
            rng = np.random.default_rng(seed)
            values, (left, right) = draw(rng), pair(rng, 1 + 2 * (seed % 2))
            expected = cv2.StereoSGBM_create(**values).compute(left, right)
            with self.subTest(seed=seed, **values):
                np.testing.assert_array_equal(stadimeter.StereoSGBM_create(**values).compute(left, right), expected)

    def test_getters_answer_as_opencvs(self):
        for seed in range(20):
            values = draw(np.random.default_rng(seed))
            theirs, ours = cv2.StereoSGBM_create(**values), stadimeter.StereoSGBM_create(**values)
            for name in NAMES:
                self.assertEqual(getattr(ours, f"get{name}")(), getattr(theirs, f"get{name}")(), f"seed {seed}: get{name}")

    def test_setters_change_what_is_computed_as_opencvs(self):
        theirs, ours = cv2.StereoSGBM_create(), stadimeter.StereoSGBM_create()
        for seed in range(40):
            rng = np.random.default_rng(seed)
            values, (left, right) = draw(rng), pair(rng, 1)
            for name in rng.permutation(NAMES)[:7]:
                value = values[name if name[:2] in ("P1", "P2") else name[0].lower() + name[1:]]
                getattr(theirs, f"set{name}")(value)
                getattr(ours, f"set{name}")(value)
                self.assertEqual(getattr(ours, f"get{name}")(), getattr(theirs, f"get{name}")())
            np.testing.assert_array_equal(ours.compute(left, right), theirs.compute(left, right), f"seed {seed}")

    def test_an_output_array_is_filled(self):
        left, right = pair(np.random.default_rng(1), 1)
        given = np.zeros(left.shape, np.int16)
        returned = stadimeter.StereoSGBM_create(0, 32, 5).compute(left, right, given)
        self.assertIs(returned, given)
        np.testing.assert_array_equal(given, cv2.StereoSGBM_create(0, 32, 5).compute(left, right))

    def test_every_method_but_those_of_files_is_there(self):
        # cv2.Algorithm's, which keep parameters in OpenCV's own files
        files = {"clear", "empty", "getDefaultName", "read", "save", "write"}
        theirs = {name for name in dir(cv2.StereoSGBM_create()) if not name.startswith("_")}
        self.assertEqual(theirs - files - set(dir(stadimeter.StereoSGBM_create())), set())
        for name in dir(cv2):
            if name.startswith(("StereoSGBM_", "STEREO_SGBM_", "StereoMatcher_", "STEREO_MATCHER_")) and name != "StereoSGBM_create":
                self.assertEqual(getattr(stadimeter, name), getattr(cv2, name), name)

    def test_a_script_changes_one_line(self):
        left, right = pair(np.random.default_rng(2), 3)
        found = []
        for module in ("cv2", "stadimeter"):
            names = {"left": left, "right": right}
            exec(SCRIPT.format(module=module), names)
            found.append(names["disparity"])
        np.testing.assert_array_equal(*found)

    def test_what_opencv_refuses_or_gets_wrong_is_a_value_error(self):
        left, right = pair(np.random.default_rng(3), 1)
        for wrong in (dict(numDisparities=0), dict(numDisparities=10), dict(numDisparities=4096), dict(mode=7), dict(P2=40000)):
            with self.subTest(**wrong), self.assertRaises(ValueError) as caught:
                stadimeter.StereoSGBM_create(**{"numDisparities": 16, **wrong}).compute(left, right)
            self.assertIn(next(iter(wrong)), str(caught.exception))
        with self.assertRaises(ValueError):
            stadimeter.StereoSGBM_create().compute(left, right[:-1])
        with self.assertRaises(TypeError):
            stadimeter.StereoSGBM_create(blockSize=5.5)


if __name__ == "__main__":
    main()
