# SPDX-License-Identifier: MIT
"""Evaluates and tunes over thousands of recorded frames, on threads or on a Dask cluster.

    python3 -m stadimeter.study evaluate SCENES.json --results study.sqlite [--params tuned.json]
    python3 -m stadimeter.study tune     SCENES.json --results study.sqlite [--each] [--max-evals 100]

SCENES.json is the list that `stad tune --scenes` takes: [{"left", "right", "truth", and if wanted "mask", "truth_scale",
"min_disparity", "num_disparities"}, ...], file names relative to the list. Every exact count goes to the results file, an SQLite
data base, as soon as it is known; a study that was stopped goes on where it was, and one that is asked for more reuses what is
there. Counts are whole numbers and a search is replayed from them, so the answer is the same, bit for bit, on one thread, on a
cluster, and after a worker was lost.

Needs the extra `study`: pip install 'stadimeter[study]' (Dask, Pillow)."""
from __future__ import annotations

import argparse
import json
import os
import sqlite3
import sys
import time
from dataclasses import asdict, dataclass
from functools import lru_cache
from importlib.util import find_spec
from typing import Any, Callable, Dict, Iterable, Iterator, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from ._version import __version__
from .files import mask_labels, read_grey, read_truth, stamp
from .score import FAILED_Q20, Scorer, label
from .sgbm import _FIELDS, StereoSGBM_create
from .tune import NAMES, Tuner, cheap_for

Counts = Dict[str, int]
Point = Mapping[str, int]
MODES = {"sgbm": 0, "hh": 1, "3way": 2, "hh4": 3}
STARTS = {"default": dict(zip(NAMES, (2, 5, 3, 0, 15, 1))), "sample": dict(zip(NAMES, (72, 288, 3, 10, 63, 1)))}
_OPENCV = {ours: theirs for theirs, ours in _FIELDS.items()}


class StudyError(Exception):
    """Scenes that cannot be measured, one a line."""


@dataclass(frozen=True)
class Scene:
    """A recorded pair with truth."""
    left: str
    right: str
    truth: str
    mask: Optional[str] = None
    truth_scale: float = 0.0
    min_disparity: int = 0
    num_disparities: int = 64

    def identity(self) -> List[Any]:
        """What its counts depend on beside the parameters; OSError when a file is missing."""
        files = [stamp(path) for path in (self.left, self.right, self.truth, self.mask)]
        return [*files, self.truth_scale, self.min_disparity, self.num_disparities]


@dataclass(frozen=True)
class Settings:
    """What holds for a whole study."""
    mode: int = 0
    threshold: float = 1.0
    cost: str = "bad"


def read_scenes(path: str, num_disparities: int = 64) -> List[Scene]:
    """The scenes of a list; num_disparities for those that do not say."""
    folder = os.path.dirname(path)
    with open(path, encoding="utf-8") as file:
        items = json.load(file)
    if not isinstance(items, list) or not items:
        raise ValueError(f"{path}: not a JSON array of scenes")
    scenes = []
    for i, item in enumerate(items):
        for key in ("left", "right", "truth"):
            if not isinstance(item, dict) or not isinstance(item.get(key), str):
                raise ValueError(f"{path}: scene {i} has no file name \"{key}\"")
        known = {key: item[key] for key in Scene.__dataclass_fields__ if key in item}
        known.update({key: os.path.join(folder, known[key]) for key in ("left", "right", "truth", "mask") if known.get(key)})
        scenes.append(Scene(**{"num_disparities": num_disparities, **known}))
    return scenes


# -- one scene, as a worker does it --------------------------------------------------------------------------------------------


@lru_cache(maxsize=16)
def _load(scene: Scene) -> Tuple[NDArray[np.uint8], NDArray[np.uint8], NDArray[np.int32], NDArray[np.uint8]]:
    left, right = read_grey(scene.left), read_grey(scene.right)
    rows = read_truth(scene.truth, scene.truth_scale, scene.min_disparity)
    if not left.shape == right.shape == rows.shape:
        raise ValueError(f"{scene.left}: left {left.shape}, right {right.shape} and truth {rows.shape} differ in size")
    return left, right, rows, mask_labels(rows, scene.mask) if scene.mask else label(rows)


def measure(scene: Scene, settings: Settings, point: Point) -> Counts:
    """The exact counts of a scene matched with a point: any of the matcher's parameters by the library's names."""
    left, right, rows, labels = _load(scene)
    values = {"min_disparity": scene.min_disparity, "num_disparities": scene.num_disparities, **point}
    named: Dict[str, Any] = {_OPENCV[name]: value for name, value in values.items()}
    disparity = StereoSGBM_create(mode=settings.mode, **named).compute(left, right)
    scorer = Scorer(numDisparities=values["num_disparities"], minDisparity=values["min_disparity"], threshold=settings.threshold)
    scorer.add(disparity, rows, labels)
    return scorer.counts()


def total(counts: Iterable[Counts]) -> Counts:
    """The counts of all scenes together."""
    sums: Counts = {}
    for one in counts:
        for name, value in one.items():
            sums[name] = sums.get(name, 0) + value
    return sums


def cost_q20(n: Counts, cost: str) -> int:
    """The library's cost, from counts of any size."""
    if cost == "bad":
        part, whole = n["wrong_visible"] + n["missing_visible"], n["visible"]
    elif cost == "chow":
        part, whole = 2 * (n["wrong_visible"] + n["wrong_occluded"]) + n["missing_visible"], 2 * (n["visible"] + n["occluded"])
    else:
        raise ValueError(f"cost = {cost!r}: bad or chow")
    return (part * 2**20 + whole // 2) // whole if whole else FAILED_Q20


def mean_q20(counts: Sequence[Counts], cost: str) -> int:
    """The mean of the scenes' costs, which a joint search lowers; as `stad tune --scenes` has it."""
    costs = [cost_q20(n, cost) for n in counts]
    return FAILED_Q20 if FAILED_Q20 in costs else (sum(costs) + len(costs) // 2) // len(costs)


def search(scene: Scene, settings: Settings, start: Point, budget: int) -> List[Tuple[Dict[str, int], Counts]]:
    """A scene tuned by itself: every distinct evaluation."""
    tuner, trace = Tuner(start, purpose=settings.cost, budget=budget, cheap=cheap_for(settings.cost)), []
    while (point := tuner.ask()) is not None:
        counts = measure(scene, settings, point)
        trace.append((point, counts))
        tuner.tell_q20(cost_q20(counts, settings.cost))
    return trace


# -- many scenes ---------------------------------------------------------------------------------------------------------------

Task = Tuple[str, Callable[..., Any], Tuple[Any, ...]]


def _attempt(function: Callable[..., Any], arguments: Tuple[Any, ...]) -> Tuple[bool, Any]:
    """A file that cannot be used is a result: it must not end the others' work. What is no fault of a file is raised."""
    try:
        return True, function(*arguments)
    except (OSError, ValueError) as error:
        return False, str(error)


class Threads:
    """Dask on threads of this process; the library lets other threads run while it matches."""

    def __init__(self, jobs: Optional[int] = None) -> None:
        import dask
        self._dask: Any = dask
        self.jobs = jobs or os.cpu_count() or 1

    def run(self, tasks: Sequence[Task]) -> Iterator[Tuple[str, Tuple[bool, Any]]]:
        for first in range(0, len(tasks), 4 * self.jobs):
            batch = tasks[first:first + 4 * self.jobs]
            work = [self._dask.delayed(_attempt, pure=False)(function, arguments) for _, function, arguments in batch]
            yield from zip((key for key, _, _ in batch), self._dask.compute(*work, scheduler="threads", num_workers=self.jobs))

    def close(self) -> None:
        pass


class Cluster:
    """A Dask cluster by its scheduler's address, or a client of one. Workers need this package and the scenes' files."""

    def __init__(self, scheduler: Any) -> None:
        import distributed
        self._distributed: Any = distributed
        self.client = self._distributed.Client(scheduler) if isinstance(scheduler, str) else scheduler
        self._mine = self.client is not scheduler

    def run(self, tasks: Sequence[Task]) -> Iterator[Tuple[str, Tuple[bool, Any]]]:
        keys = {self.client.submit(_attempt, function, arguments, pure=False): key for key, function, arguments in tasks}
        for future in self._distributed.as_completed(keys):
            yield keys[future], future.result()

    def close(self) -> None:
        if self._mine:
            self.client.close()


class Results:
    """Answers by question, kept in an SQLite file: each is there wholly or not at all, whatever happens."""

    def __init__(self, path: str) -> None:
        self._data = sqlite3.connect(path, isolation_level=None)
        self._data.execute("CREATE TABLE IF NOT EXISTS answers (question TEXT PRIMARY KEY, answer TEXT NOT NULL)")

    def get(self, question: str) -> Any:
        row = self._data.execute("SELECT answer FROM answers WHERE question = ?", (question,)).fetchone()
        return None if row is None else json.loads(row[0])

    def put(self, question: str, answer: Any) -> None:
        self._data.execute("INSERT OR REPLACE INTO answers VALUES (?, ?)", (question, json.dumps(answer)))

    def close(self) -> None:
        self._data.close()


class Study:
    """Scenes (one named twice counts once), settings, a place for the work and one for the results.

    keep_going: scenes that cannot be used are left out."""

    def __init__(self, scenes: Sequence[Scene], results: str, settings: Settings = Settings(), where: Any = None,
                 keep_going: bool = False) -> None:
        self.settings, self.keep_going = settings, keep_going
        self.failed: Dict[Scene, str] = {}
        self._where = where if where is not None else Threads()
        self._results = Results(results)
        self._begun, self._done = time.monotonic(), 0
        self.scenes: List[Scene] = []
        self._identity: Dict[Scene, List[Any]] = {}
        for scene in dict.fromkeys(scenes):
            try:
                self._identity[scene] = scene.identity()
                self.scenes.append(scene)
            except OSError as error:
                self.failed[scene] = str(error)
        self._stop_if_failed()

    def close(self) -> None:
        self._results.close()

    def _question(self, what: str, scene: Scene, *rest: Any) -> str:
        settings = {"mode": self.settings.mode, "threshold": self.settings.threshold}
        return json.dumps([__version__, what, self._identity[scene], settings, *rest], sort_keys=True)

    def _stop_if_failed(self) -> None:
        if self.failed and not self.keep_going:
            raise StudyError("\n".join(self.failed.values()))
        if not self.scenes:
            raise StudyError("no scene can be used" + "".join(f"\n{reason}" for reason in self.failed.values()))

    def _answers(self, questions: Dict[Scene, str], function: Callable[..., Any], *rest: Any) -> Dict[Scene, Any]:
        """What is known is taken from the results, the rest is worked on and kept as it comes."""
        answers = {scene: self._results.get(question) for scene, question in questions.items()}
        by_question = {question: scene for scene, question in questions.items()}
        tasks = [(questions[scene], function, (scene, *rest)) for scene, answer in answers.items() if answer is None]
        for question, (good, answer) in self._where.run(tasks):
            scene = by_question[question]
            if good:
                self._results.put(question, answer)
                answers[scene] = json.loads(json.dumps(answer))
            else:
                self.failed[scene] = answer
            self._progress(len(tasks))
        self.scenes = [scene for scene in self.scenes if scene not in self.failed]
        self._stop_if_failed()
        return {scene: answers[scene] for scene in self.scenes}

    def _progress(self, of: int) -> None:
        self._done += 1
        if sys.stderr.isatty():
            rate = self._done / max(time.monotonic() - self._begun, 1e-9)
            print(f"\r{self._done} scenes done, {of} in this round, {rate:.1f} a second\033[K", end="", file=sys.stderr, flush=True)

    def evaluate(self, point: Point) -> Dict[Scene, Counts]:
        """The counts of every scene."""
        values = dict(sorted(point.items()))
        questions = {scene: self._question("counts", scene, values) for scene in self.scenes}
        return self._answers(questions, measure, self.settings, values)

    def tune(self, start: Point, budget: int = 100) -> List[Tuple[Dict[str, int], int]]:
        """One set for all scenes: the trace of points and costs. Its tuner is fed from the results as far as they go."""
        tuner, trace = Tuner(start, purpose=self.settings.cost, budget=budget, cheap=cheap_for(self.settings.cost)), []
        while (point := tuner.ask()) is not None:
            trace.append((point, mean_q20(list(self.evaluate(point).values()), self.settings.cost)))
            tuner.tell_q20(trace[-1][1])
        return trace

    def tune_each(self, start: Point, budget: int = 100) -> Dict[Scene, List[Tuple[Dict[str, int], int]]]:
        """A set for every scene: its trace."""
        rest = self.settings.cost, dict(start), budget
        questions = {scene: self._question("search", scene, *rest) for scene in self.scenes}
        traces = self._answers(questions, search, self.settings, dict(start), budget)
        return {scene: [(point, cost_q20(counts, self.settings.cost)) for point, counts in trace]
                for scene, trace in traces.items()}


def best(trace: Sequence[Tuple[Dict[str, int], int]]) -> Tuple[Dict[str, int], int]:
    """The first of the best."""
    return min(trace, key=lambda entry: entry[1])


# -- the command ---------------------------------------------------------------------------------------------------------------


def read_params(path: str) -> Dict[str, int]:
    """Parameters by the library's names from a file as `stad tune --json` and this command write it, or flat."""
    with open(path, encoding="utf-8") as file:
        found = json.load(file)
    for key in ("best", "params"):
        found = found.get(key, found) if isinstance(found, dict) else found
    if not isinstance(found, dict) or not set(found) <= {*_OPENCV, "mode"}:
        raise ValueError(f"{path}: holds no parameters")
    return {name: int(value) for name, value in found.items() if name in _OPENCV}


def _scene_report(scene: Scene, **more: Any) -> Dict[str, Any]:
    return {"left": scene.left, "right": scene.right, **more}


def _evaluate(study: Study, options: argparse.Namespace) -> Dict[str, Any]:
    point = read_params(options.params) if options.params else STARTS["sample"]
    counts = study.evaluate({name: value for name, value in point.items() if name not in ("min_disparity", "num_disparities")})
    cost = study.settings.cost
    return {"params": point, cost: mean_q20(list(counts.values()), cost) / 2**20, "counts": total(counts.values()),
            "scenes": [_scene_report(scene, **{cost: cost_q20(n, cost) / 2**20, "counts": n}) for scene, n in counts.items()]}


def _tune(study: Study, options: argparse.Namespace) -> Dict[str, Any]:
    start = STARTS.get(options.start) or {**STARTS["sample"], **read_params(options.start)}
    start = {name: start[name] for name in NAMES}
    cost = study.settings.cost

    def report(trace: Sequence[Tuple[Dict[str, int], int]]) -> Dict[str, Any]:
        point, least = best(trace)
        return {"start": {"params": trace[0][0], cost: trace[0][1] / 2**20}, "best": {"params": point, cost: least / 2**20},
                "trace": [[list(p.values()), q / 2**20] for p, q in trace]}

    if not options.each:
        return report(study.tune(start, options.max_evals))
    traces = study.tune_each(start, options.max_evals)
    return {"scenes": [_scene_report(scene, **report(trace)) for scene, trace in traces.items()]}


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python3 -m stadimeter.study", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True, metavar="evaluate|tune")
    for name, run in (("evaluate", _evaluate), ("tune", _tune)):
        command = commands.add_parser(name)
        command.set_defaults(run=run)
        command.add_argument("scenes", help="list of scenes, JSON")
        command.add_argument("--results", required=True, metavar="FILE", help="SQLite file that keeps every count")
        command.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask cluster; default: threads of this process")
        command.add_argument("--jobs", type=int, metavar="N", help="threads (as many as processors)")
        command.add_argument("--keep-going", action="store_true", help="leave out scenes that cannot be used")
        command.add_argument("--mode", choices=MODES, default="sgbm")
        command.add_argument("--cost", choices=("bad", "chow"), default="bad")
        command.add_argument("--threshold", type=float, default=1.0, metavar="PX", help="error that counts as wrong (1)")
        command.add_argument("--num-disparities", type=int, default=64, metavar="N", help="of scenes that do not say (64)")
        command.add_argument("--json", metavar="FILE", help="where the answer goes (standard output)")
        if name == "evaluate":
            command.add_argument("--params", metavar="FILE", help="as `stad tune --json` writes them (the sample's)")
        else:
            command.add_argument("--each", action="store_true", help="a set for every scene, not one for all")
            command.add_argument("--start", default="sample", metavar="default|sample|FILE")
            command.add_argument("--max-evals", type=int, default=100, metavar="N", help="distinct evaluations (100)")
    return parser


def _write(answer: Dict[str, Any], path: Optional[str]) -> None:
    text = json.dumps(answer, indent=1) + "\n"
    if path is None:
        sys.stdout.write(text)
        return
    with open(f"{path}.part", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(f"{path}.part", path)


def main(arguments: Optional[Sequence[str]] = None) -> int:
    options = _parser().parse_args(arguments)
    missing = [name for name in ("dask", "PIL") if find_spec(name) is None]
    if missing:
        print(f"stadimeter.study: {missing[0]} is not installed: pip install 'stadimeter[study]'", file=sys.stderr)
        return 3
    settings = Settings(MODES[options.mode], options.threshold, options.cost)
    try:
        scenes = read_scenes(options.scenes, options.num_disparities)
        where: Union[Cluster, Threads] = Cluster(options.scheduler) if options.scheduler else Threads(options.jobs)
        try:
            study = Study(scenes, options.results, settings, where, options.keep_going)
            answer = options.run(study, options)
        finally:
            where.close()
        answer.update(settings=asdict(settings), failed=[_scene_report(scene, reason=why) for scene, why in study.failed.items()])
        study.close()
        _write(answer, options.json)
    except (OSError, ValueError, StudyError, sqlite3.Error) as error:
        print(f"stadimeter.study: {error}", file=sys.stderr)
        return 3
    if sys.stderr.isatty():
        print(file=sys.stderr)
    for reason in study.failed.values():
        print(f"stadimeter.study: left out: {reason}", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
