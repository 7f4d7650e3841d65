# SPDX-License-Identifier: MIT
"""A study on threads, on a cluster that loses a worker, and one that was stopped half way: one answer, that of the tool."""
import json
import os
import shutil
import signal
import sqlite3
import tempfile
import time
import unittest
from pathlib import Path
from unittest import mock

from PIL import Image
from stadimeter import study

from scenes import main, stad

SCENES = 10


class Fleet(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = Path(cls.folder.name)
        names = []
        for i in range(SCENES):
            stad("scene", "-o", cls.path / str(i), "--seed", i, "--width", 160, "--height", 100, "--num-disparities", 32)
            names.append({"left": f"{i}/left.png", "right": f"{i}/right.png", "truth": f"{i}/disp.pfm", "num_disparities": 32})
            if i % 2:
                names[-1]["mask"] = f"{i}/nonocc.png"
        with Image.open(cls.path / "1/nonocc.png") as mask:  # 128 is hidden as 0 is
            grey = mask.point(lambda v: 128 if v == 0 else v)
        grey.save(cls.path / "1/nonocc.png")
        cls.list = cls.path / "scenes.json"
        cls.list.write_text(json.dumps(names))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def run_study(self, command, name, *more, status=0):
        """The answer's text of the command with a results file of that name."""
        out = self.path / f"{name}.json"
        got = study.main([command, str(self.list), "--results", str(self.path / f"{name}.sqlite"), "--json", str(out), *more])
        self.assertEqual(got, status)
        return out.read_text() if status == 0 else None

    def answers(self, name):
        with sqlite3.connect(self.path / f"{name}.sqlite") as data:
            return sorted(data.execute("SELECT question, answer FROM answers"))

    def test_a_joint_search_is_that_of_the_tool(self):
        ours = json.loads(self.run_study("tune", "joint", "--max-evals", "20"))
        stad("tune", "--scenes", self.list, "--max-evals", 20, "--start", "sample", "--json", self.path / "tool.json")
        theirs = json.loads((self.path / "tool.json").read_text())
        self.assertEqual([cost * 2**20 for _, cost in ours["trace"]], [round(entry[1] * 2**20) for entry in theirs["trace"]])
        self.assertEqual(ours["best"]["params"], {k: theirs["best"]["params"][k] for k in ours["best"]["params"]})
        again = json.loads(self.run_study("evaluate", "joint", "--params", str(self.path / "joint.json")))
        self.assertEqual(again["bad"], ours["best"]["bad"])

    def test_a_worker_killed_midway_changes_nothing(self):
        from distributed import LocalCluster
        expected = self.run_study("tune", "threads", "--each", "--max-evals", "12", "--jobs", "2")
        gate = self.path / "killed"

        def once_killed(function, *arguments):
            while not gate.exists():
                time.sleep(0.01)
            return function(*arguments)

        class Losing(study.Cluster):
            """With two answers in, a worker is killed at the next scene, which is held until then."""

            def run(self, tasks):
                held = [(key, once_killed, (function, *arguments)) for key, function, arguments in tasks[2:]]
                for i, answer in enumerate(super().run([*tasks[:2], *held])):
                    if i == 1:
                        os.kill(pid, signal.SIGKILL)
                        gate.touch()
                    yield answer

        with LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:
            pid = next(iter(cluster.workers.values())).pid
            with mock.patch.object(study, "Cluster", Losing):
                found = self.run_study("tune", "cluster", "--each", "--max-evals", "12", "--scheduler", cluster.scheduler_address)
        self.assertTrue(gate.exists())
        self.assertEqual(found, expected)
        self.assertEqual(self.answers("cluster"), self.answers("threads"))

    def test_a_stopped_study_goes_on(self):
        class Stopped(Exception):
            pass

        class Some(study.Threads):
            left = 7

            def run(self, tasks):
                for answer in super().run(tasks):
                    if self.left == 0:
                        raise Stopped
                    self.left -= 1
                    yield answer

        scenes, start = study.read_scenes(str(self.list)), study.STARTS["sample"]
        whole = study.Study(scenes, str(self.path / "whole.sqlite")).tune(start, 4)
        stopped = study.Study(scenes, str(self.path / "stopped.sqlite"), where=Some(1))
        with self.assertRaises(Stopped):
            stopped.tune(start, 4)
        stopped.close()
        self.assertEqual(len(self.answers("stopped")), 7)

        class Counting(study.Threads):
            asked = 0

            def run(self, tasks):
                self.asked += len(tasks)
                return super().run(tasks)

        where = Counting(2)
        resumed = study.Study(scenes, str(self.path / "stopped.sqlite"), where=where)
        self.assertEqual(resumed.tune(start, 4), whole)
        self.assertEqual(where.asked, 4 * SCENES - 7)
        self.assertEqual(resumed.tune(start, 4), whole)
        self.assertEqual(where.asked, 4 * SCENES - 7)

    def test_scenes_that_cannot_be_used_stop_it_or_are_left_out(self):
        names = json.loads(self.list.read_text())[:4]
        shutil.copytree(self.path / "1", self.path / "bad")
        (self.path / "bad/left.png").write_bytes((self.path / "1/left.png").read_bytes()[:500])
        names += [{**names[0], "right": "nowhere.png"}, {**names[1], "left": "bad/left.png"}]
        self.list, kept = self.path / "some_bad.json", self.list
        self.list.write_text(json.dumps(names))
        self.run_study("evaluate", "bad", status=3)
        self.list.write_text(json.dumps(names[:4] + names[5:]))
        self.run_study("evaluate", "bad", status=3)
        self.assertEqual(len(self.answers("bad")), 4, "what was done before it stopped is lost")
        self.list.write_text(json.dumps(names))
        answer = json.loads(self.run_study("evaluate", "bad", "--keep-going"))
        self.assertEqual((len(answer["scenes"]), len(answer["failed"])), (4, 2))
        self.list.write_text('[{"left": "a"}]')
        self.run_study("evaluate", "bad", status=3)
        self.list = kept

    def test_a_file_that_changed_is_measured_again(self):
        first = self.run_study("evaluate", "changed")
        os.utime(self.path / "0/left.png", (1, 1))
        before = len(self.answers("changed"))
        self.assertEqual(self.run_study("evaluate", "changed"), first)
        self.assertEqual(len(self.answers("changed")), before + 1)

    def test_costs_are_the_librarys(self):
        for scene in study.read_scenes(str(self.list))[:3]:
            counts = study.measure(scene, study.Settings(), study.STARTS["sample"])
            out = self.path / "disparity.npy"
            mask = ["--mask", scene.mask] if scene.mask else []
            stad("match", scene.left, scene.right, "-o", out, "--num-disparities", 32)
            told = json.loads(stad("eval", out, scene.truth, "--min-disparity", 0, "--num-disparities", 32, "--json", *mask))
            for name, value in told["counts"].items():
                if name in counts:
                    self.assertEqual(counts[name], value, name)
            self.assertAlmostEqual(study.cost_q20(counts, "bad") / 2**20, told["bad"]["1"], delta=2**-20)
            self.assertAlmostEqual(study.cost_q20(counts, "chow") / 2**20, told["chow"], delta=2**-20)


if __name__ == "__main__":
    main()
