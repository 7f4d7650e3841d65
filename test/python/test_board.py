# SPDX-License-Identifier: MIT
"""Marks, rig, truth and the simulated board: against the tool on the same recording, and on what is drawn to be wrong."""
import csv
import ctypes
import json
import tempfile
import unittest

import numpy as np
import stadimeter
from stadimeter import _native as native

from scenes import main, recording, stad


class Marks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.frames = recording(cls.folder.name, 2, seed=5)
        cls.pairs = stadimeter.pair_marks(*(stadimeter.find_marks(view) for view in cls.frames[0]))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_marks_of_both_views_lie_on_the_same_rows(self):
        self.assertEqual(sorted(p.id for p in self.pairs), [0, 1, 2, 3])
        for p in self.pairs:
            self.assertLess(np.abs(p.left[:, 1] - p.right[:, 1]).max(), 0.3)
            self.assertTrue((p.left[:, 0] > p.right[:, 0]).all())

    def test_only_the_identities_asked_for_are_found(self):
        self.assertEqual([m.id for m in stadimeter.find_marks(self.frames[0][0], ids=[2])], [2])
        self.assertEqual(stadimeter.find_marks(np.zeros((40, 40), np.uint8)), [])
        with self.assertRaises(ValueError):
            stadimeter.find_marks(np.zeros((8, 8), np.uint8))

    def test_truth_of_the_target_scores_a_match(self):
        truth, labels = stadimeter.target_truth(self.pairs, 320, 240, 64, focal=192)
        self.assertGreater((labels == 1).sum(), 2000)
        found = stadimeter.StereoSGBM_create(0, 64, 5, 200, 800, 1, 63, 10).compute(*self.frames[0])
        scorer = stadimeter.Scorer(numDisparities=64)
        scorer.add(found, truth, labels)
        self.assertLess(scorer.cost(), 0.2)
        with self.assertRaises(ValueError):
            stadimeter.target_truth(self.pairs[:1], 320, 240, 64, focal=192)

    def test_a_rig_that_sank_is_seen_and_corrected(self):
        self.assertEqual(stadimeter.fit_rig(self.pairs, 320, 240).verdict, "good")
        with tempfile.TemporaryDirectory() as folder:
            left, right = recording(folder, 1, seed=5, drift=2)[0]
        pairs = stadimeter.pair_marks(stadimeter.find_marks(left), stadimeter.find_marks(right))
        rig = stadimeter.fit_rig(pairs, 320, 240)
        self.assertEqual(rig.verdict, "correct")
        self.assertGreater(rig.report["rms_before"], 1)
        again = stadimeter.pair_marks(stadimeter.find_marks(left), stadimeter.find_marks(rig.apply(right)))
        self.assertEqual(stadimeter.fit_rig(again, 320, 240).verdict, "good")
        for moved, seen in zip(rig.straighten(pairs), again):
            self.assertLess(np.abs(moved.right[:, 1] - seen.right[:, 1]).max(), 0.5)


class Simulation(unittest.TestCase):
    @staticmethod
    def record(number):
        """A good record with that number."""
        record = ctypes.create_string_buffer(native.SETUP_BYTES)
        native.lib.stad_setup_pack(stadimeter.Board(320, 240).setup(), number, record)
        return record.raw

    @staticmethod
    def number_of(stored):
        setup, number = native.Setup(), ctypes.c_uint32()
        native.lib.stad_setup_unpack(stored, len(stored), setup, ctypes.byref(number))
        return number.value

    def test_a_board_does_what_the_tool_does(self):
        options = {"calibrate-at": 1, "evaluations": 20, "budget": 40, "probation-frames": 0, "learn-frames": 3}
        with tempfile.TemporaryDirectory() as folder:
            frames = recording(f"{folder}/r", 9, seed=3, noise=30)
            words = [word for name, value in options.items() for word in (f"--{name}", value)]
            stad("simulate", f"{folder}/r", "--num-disparities", 64, "--focal", 192, *words, "--json", f"{folder}/j", "--csv", f"{folder}/c")
            log, rows = json.load(open(f"{folder}/j")), list(csv.DictReader(open(f"{folder}/c")))
        result = stadimeter.simulate(frames, numDisparities=64, focal=192, **{k.replace("-", "_"): v for k, v in options.items()})
        self.assertEqual([(s.state, s.phase, f"{s.share:.5f}", s.fault) for s in result.steps],
                         [(r["state"], r["phase"], r["firm_share"], r["live_fault"]) for r in rows])
        self.assertEqual([[str(v) for v in s.params.values()] for s in result.steps], [[r[k] for k in result.params] for r in rows])
        self.assertEqual([(r.frame, r.outcome, r.evaluations, r.judge_before, r.judge_after) for r in result.runs],
                         [(r["frame"], r["outcome"], r["evaluations"], r["judge_before"], r["judge_after"]) for r in log["runs"]])
        self.assertEqual(log["runs"][0]["outcome"], "adopted")
        self.assertEqual(result.params, log["stored"]["params"])
        # a reset: another board goes on with what was stored
        board = stadimeter.Board(320, 240, stored=result.stored)
        self.assertEqual(board.params, result.params)
        with self.assertRaises(ValueError):
            stadimeter.Board(320, 240, stored=result.stored[:-1] + bytes([result.stored[-1] ^ 1]))

    def test_parameters_beside_a_record_are_refused_by_name(self):
        stored = self.record(7)
        self.assertEqual(stadimeter.Board(320, 240, stored=stored).params["num_disparities"], 64)
        for name, value in {"numDisparities": 64, "blockSize": 3, "P1": 99, "minDisparity": 0}.items():
            with self.assertRaisesRegex(ValueError, name):
                stadimeter.Board(320, 240, stored=stored, **{name: value})

    def test_the_next_record_is_newer_than_the_restored_one(self):
        board = stadimeter.Board(320, 240, stored=self.record(7))
        board._save()
        self.assertEqual(self.number_of(board.stored), 8)

    def test_options_out_of_range_are_refused_by_name(self):
        for name, value in {"learn_frames": 65536 + 30, "probation_frames": 65536, "budget": 65536 + 70, "memory": "large",
                            "mode": 256, "channels": 65537}.items():
            with self.assertRaisesRegex(ValueError, name):
                stadimeter.Board(320, 240, **{name: value})
        with self.assertRaisesRegex(ValueError, "width"):
            stadimeter.Board(65536 + 320, 240)
        with self.assertRaises(ValueError):  # frames in which marks cannot be looked for
            stadimeter.Board(4096, 240)

    def test_camera_faults_are_told_at_once(self):
        with tempfile.TemporaryDirectory() as folder:
            first, second, third = recording(folder, 3, seed=1)
        result = stadimeter.simulate([first, (second[0], second[0]), third, third, None], numDisparities=64)
        self.assertEqual([s.fault for s in result.steps], ["none", "same", "none", "frozen", "late"])

    def test_costs_not_measured_are_none(self):
        with tempfile.TemporaryDirectory() as folder:
            frames = recording(folder, 1, seed=1)
        result = stadimeter.simulate(frames + [(np.zeros_like(l), r) for l, r in frames] * 60, numDisparities=64, focal=192,
                                     calibrate_at=1)
        self.assertEqual([(r.outcome, r.tune_before, r.judge_after) for r in result.runs], [("fault", None, None)])

    def test_lost_frames_are_steps_and_no_alarm(self):
        with tempfile.TemporaryDirectory() as folder:
            frames = recording(folder, 6, seed=1)
        result = stadimeter.simulate([None, *frames[:3], None, *frames[3:]], numDisparities=64, learn_frames=3)
        self.assertEqual([s.state == "skipped" for s in result.steps], [True, False, False, False, True, False, False, False])
        self.assertEqual((result.alarms, result.stored), ([], None))
        with self.assertRaises(ValueError):
            stadimeter.simulate([])


if __name__ == "__main__":
    main()
