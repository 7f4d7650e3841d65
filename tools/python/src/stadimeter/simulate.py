# SPDX-License-Identifier: MIT
"""Recorded frames through the matcher, monitor and calibration of the firmware: a board, and a run of one.

    result = stadimeter.simulate(frames, numDisparities=64, focal=436.2)     # frames: (left, right) arrays, None for a lost one
    result.alarms, result.runs, result.params, result.stored"""
from __future__ import annotations

import ctypes
from dataclasses import dataclass, field
from typing import Any, Dict, Iterable, List, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _native as native
from ._native import lib, status_name
from .marks import camera, correct
from .sgbm import MEMORY_PLANS, StereoSGBM_create, _aligned, _borrow, _frame, _integer

STATES = ("learning", "ok", "degraded")
PHASES = ("idle", "look", "other", "confirm", "pick", "tune", "judge", "save", "probation", "recheck", "compare")
OUTCOMES = ("none", "sound", "adopted", "corrected", "kept", "rolled back", "no marks", "no pose", "rig failed", "fault",
            "cancelled")
FAULTS = ("none", "late", "black", "saturated", "flat", "frozen", "swapped", "marks", "range", "rig", "size", "camera",
          "moving", "same", "match")
_NOTHING, _FRAME, _MATCH, _SAVE = range(4)
_FAILED = 2**31 - 1  # STAD_COST_FAILED
# The bounds of the search: the matcher's memory is made for them.
_MOST_BLOCK, _MOST_P2, _MOST_CAP, _EVERY_EVALUATION = 11, 8192, 127, 240


def _name(names: Tuple[str, ...], i: int) -> str:
    return names[i] if i < len(names) else f"{i}"


def _cost(q20: int) -> Optional[float]:
    return q20 / 2**20 if 0 <= q20 != _FAILED else None


def _params(p: native.Params) -> Dict[str, int]:
    return {name: int(getattr(p, name)) for name in native.PARAMS}


@dataclass
class Step:
    """A frame: the monitor's state, where the calibration stands, the share it watches, the parameters it was matched with, and
    what is wrong with the cameras ("none", "black", "frozen", ...), whether or not a run looks."""
    state: str
    phase: str
    share: float
    counts: Dict[str, int]
    params: Dict[str, int]
    disparity: Optional[NDArray[np.int16]]
    fault: str = "none"


@dataclass
class Run:
    """A calibration run that ended. Costs of which none was measured are None."""
    frame: int
    outcome: str
    fault: str
    evaluations: int
    tune_before: Optional[float]
    tune_after: Optional[float]
    judge_before: Optional[float]
    judge_after: Optional[float]
    params: Dict[str, int]
    corrected: bool


@dataclass
class Simulation:
    """All that a board did."""
    steps: List[Step] = field(default_factory=list)
    runs: List[Run] = field(default_factory=list)
    alarms: List[int] = field(default_factory=list)
    params: Dict[str, int] = field(default_factory=dict)
    corrected: bool = False
    stored: Optional[bytes] = None


class Board:
    """A board with two cameras, fed a pair at a time by frame(). Parameters as StereoSGBM_create(), those left out the sample's.

    numDisparities and blockSize: 64 and 3 if left out. focal: px; without it marks are not looked for and only the monitor runs.
    stored: the record another board left; it holds all parameters, so that none may be given beside it."""

    def __init__(self, width: int, height: int, numDisparities: Optional[int] = None, blockSize: Optional[int] = None, *,
                 channels: int = 1, focal: Optional[float] = None, center: Optional[Tuple[float, float]] = None, mode: int = 0,
                 memory: str = "fast", learn_frames: Optional[int] = None, probation_frames: Optional[int] = None,
                 budget: Optional[int] = None, cost: str = "bad", stored: Optional[bytes] = None, **parameters: int) -> None:
        if cost not in ("bad", "chow"):
            raise ValueError(f"cost = {cost!r}: bad or chow")
        if memory not in MEMORY_PLANS:
            raise ValueError(f"memory = {memory!r}: {' or '.join(MEMORY_PLANS)}")
        if mode not in range(4):
            raise ValueError(f"mode = {mode!r}: 0 to 3")
        width, height, channels = _integer("width", width), _integer("height", height), _integer("channels", channels)
        given = {name: value for name, value in {"numDisparities": numDisparities, "blockSize": blockSize, **parameters}.items()
                 if value is not None}
        setup, self._sequence = self._setup(width, height, channels, mode, given) if stored is None else self._restored(stored, given)
        p = setup.params
        self._geometry = native.Geometry(width, height, channels, p.num_disparities, max(p.block_size, _MOST_BLOCK),
                                         max(p.p2, _MOST_P2), max(p.pre_filter_cap, _MOST_CAP), mode, MEMORY_PLANS[memory])
        self._focal = focal
        config = native.CalibConfig()
        lib.stad_calib_config_default(config, self._geometry, lib.stad_target_relief(),
                                      camera(focal or width, width, height, center))
        config.cost = int(cost == "chow")
        if learn_frames is not None:
            config.monitor.learn_frames = _integer("learn_frames", learn_frames)
        if probation_frames is not None:
            config.probation_frames = _integer("probation_frames", probation_frames)
        if budget is not None:
            config.budget = _integer("budget", budget)
        self._calib = _aligned(native.CALIB_BYTES)
        self._refuse(lib.stad_calib_init(self._calib.ctypes.data, config, setup), "the calibration")
        self._match, self._evaluator = _aligned(native.MATCH_BYTES), _aligned(native.EVALUATOR_BYTES)
        self._live = _aligned(lib.stad_match_bytes(self._geometry))
        self._refuse(lib.stad_match_init(self._match.ctypes.data, self._geometry, self._live.ctypes.data, self._live.size),
                     "the matcher")
        self._work = _aligned(max(lib.stad_calib_frame_bytes(width, height), lib.stad_calib_evaluate_bytes(self._geometry)))
        self._held: Dict[int, Tuple[NDArray[np.uint8], NDArray[np.uint8]]] = {}
        self._last_outcome, self._frame = 0, -1
        self.stored: Optional[bytes] = None
        self.runs: List[Run] = []

    @staticmethod
    def _restored(stored: bytes, given: Dict[str, int]) -> Tuple[native.Setup, int]:
        """The setup of a record and its number, from which that of the next one goes on."""
        if given:
            raise ValueError(f"{', '.join(given)}: stored holds the parameters, none may be given beside it")
        setup, sequence = native.Setup(), ctypes.c_uint32()
        if lib.stad_setup_unpack(stored, len(stored), setup, ctypes.byref(sequence)) != 0:
            raise ValueError("stored: no good record")
        return setup, sequence.value

    @staticmethod
    def _setup(width: int, height: int, channels: int, mode: int, given: Dict[str, int]) -> Tuple[native.Setup, int]:
        given = {"numDisparities": 64, "blockSize": 3, **given}
        setup, sample = native.Setup(), native.Params()
        lib.stad_params_sample(sample, _integer("numDisparities", given["numDisparities"]), _integer("blockSize", given["blockSize"]),
                               channels)
        others = {"P1": sample.p1, "P2": sample.p2, "disp12MaxDiff": sample.disp12_max_diff, "preFilterCap": sample.pre_filter_cap,
                  "uniquenessRatio": sample.uniqueness_ratio}
        matcher = StereoSGBM_create(mode=mode, **{**others, **given})
        setup.width, setup.height, setup.mode, setup.channels = width, height, mode, channels
        setup.params = native.Params(**matcher.params())
        lib.stad_rig_identity(setup.rig, width, height)
        return setup, 0

    @staticmethod
    def _refuse(status: int, what: str) -> None:
        if status != 0:
            raise ValueError(f"{what} cannot be set up for these sizes and parameters: {status_name(status)}")

    # -- a frame ----------------------------------------------------------------------------------------------------------

    def frame(self, left: Any, right: Any, evaluations: int = 4) -> Step:
        """Matches a raw pair with the setup in use, then does what the calibration asks for, up to so many evaluations."""
        views = _frame("left", left), _frame("right", right)
        shape = (self._geometry.height, self._geometry.width) + ((3,) if self._geometry.channels == 3 else ())
        for name, view in zip(("left", "right"), views):
            if view.shape != shape:
                raise ValueError(f"{name}: its shape {view.shape} is not the board's, {shape}")
        self._frame += 1
        setup = self.setup()
        straight = correct(setup.rig, views[1]) if setup.corrected else views[1]
        disparity = self._disparity(setup.params, views[0], straight)
        counts = lib.stad_match_counts_of(self._match.ctypes.data).contents
        params, fault = _params(setup.params), self._live_fault(views)
        state = lib.stad_calib_counts(self._calib.ctypes.data, counts)
        self._note_run()
        self._serve(views, evaluations)
        return Step(STATES[state], self.phase, counts.firm / counts.considered if counts.considered > 0 else 0.0,
                    {name: int(getattr(counts, name)) for name in native.MATCH_COUNTS}, params, disparity, fault)

    def miss(self) -> Step:
        """A frame that did not come."""
        self._frame += 1
        request = native.Request()
        if self._want(request) == _FRAME:
            lib.stad_calib_frame(self._calib.ctypes.data, None, None, self._work.ctypes.data, self._work.size)
        self._note_run()
        none = {name: 0 for name in native.MATCH_COUNTS}
        return Step("skipped", self.phase, 0.0, none, self.params, None, "late")

    def calibrate(self) -> None:
        """Begins a run with the next frame, whatever the monitor says."""
        lib.stad_calib_start(self._calib.ctypes.data)

    def finish(self) -> None:
        """Does what is still asked for and needs no frame."""
        self._serve(None, _EVERY_EVALUATION)

    def _live_fault(self, views: Tuple[NDArray[np.uint8], NDArray[np.uint8]]) -> str:
        (left, keep_left), (right, keep_right) = _borrow(views[0]), _borrow(views[1])
        fault = lib.stad_calib_live(self._calib.ctypes.data, left, right)
        del keep_left, keep_right
        return _name(FAULTS, fault)

    def _disparity(self, p: native.Params, left: NDArray[np.uint8], right: NDArray[np.uint8]) -> NDArray[np.int16]:
        out = np.empty(left.shape[:2], np.int16)
        labels = _aligned(lib.stad_abi_speckle_bytes(left.shape[1], left.shape[0]) if p.speckle_window_size > 0 else 0)
        (left_view, keep_left), (right_view, keep_right) = _borrow(left), _borrow(right)
        status = lib.stad_match_frame(self._match.ctypes.data, p, left_view, right_view, out.ctypes.data, left.shape[1],
                                      labels.ctypes.data if labels.size else None, labels.size)
        del keep_left, keep_right
        if status != 0:
            raise ValueError(f"the parameters in use cannot be matched: {status_name(status)}")
        return out

    # -- the calibration --------------------------------------------------------------------------------------------------

    def _want(self, request: native.Request) -> int:
        return int(lib.stad_calib_want(self._calib.ctypes.data, request))

    def _serve(self, views: Optional[Tuple[NDArray[np.uint8], NDArray[np.uint8]]], evaluations: int) -> None:
        request, given = native.Request(), False
        while self._want(request) != _NOTHING:
            if request.want == _FRAME:
                if given or views is None or self._focal is None:
                    break
                given = True
                self._give(request, views)
            elif request.want == _MATCH:
                if evaluations <= 0:
                    break
                evaluations -= 1
                self._evaluate(request)
            else:
                self._save()
            self._note_run()

    def _give(self, request: native.Request, views: Tuple[NDArray[np.uint8], NDArray[np.uint8]]) -> None:
        (left, keep_left), (right, keep_right) = _borrow(views[0]), _borrow(views[1])
        kept = lib.stad_calib_frame(self._calib.ctypes.data, left, right, self._work.ctypes.data, self._work.size)
        del keep_left, keep_right
        if kept == 1:
            self._held[request.hold] = views[0].copy(), views[1].copy()

    def _evaluate(self, request: native.Request) -> None:
        (left, keep_left), (right, keep_right) = (_borrow(view) for view in self._held[request.hold])
        cost = lib.stad_calib_evaluate(self._calib.ctypes.data, request, self._evaluator.ctypes.data, left, right,
                                       self._work.ctypes.data, self._work.size)
        del keep_left, keep_right
        lib.stad_calib_cost(self._calib.ctypes.data, cost)

    def _save(self) -> None:
        record = ctypes.create_string_buffer(native.SETUP_BYTES)
        self._sequence += 1
        lib.stad_setup_pack(self.setup(), self._sequence, record)
        self.stored = record.raw
        lib.stad_calib_saved(self._calib.ctypes.data, 0)

    def _note_run(self) -> None:
        r = lib.stad_calib_report_of(self._calib.ctypes.data).contents
        news, self._last_outcome = r.outcome not in (0, self._last_outcome), r.outcome
        if news:
            self.runs.append(Run(self._frame, _name(OUTCOMES, r.outcome), _name(FAULTS, r.fault), r.evaluations,
                                 _cost(r.tune_before_q20), _cost(r.tune_after_q20), _cost(r.judge_before_q20),
                                 _cost(r.judge_after_q20), self.params, self.corrected))

    # -- what it says ------------------------------------------------------------------------------------------------------

    def setup(self) -> native.Setup:
        """The setup in use, as the library has it."""
        copy = native.Setup()
        ctypes.pointer(copy)[0] = lib.stad_calib_setup(self._calib.ctypes.data).contents
        return copy

    @property
    def phase(self) -> str:
        return _name(PHASES, lib.stad_calib_report_of(self._calib.ctypes.data).contents.phase)

    @property
    def params(self) -> Dict[str, int]:
        """The parameters in use, by the library's names."""
        return _params(self.setup().params)

    @property
    def corrected(self) -> bool:
        """Whether the right view is corrected before it is matched."""
        return bool(self.setup().corrected)


def simulate(frames: Iterable[Optional[Tuple[Any, Any]]], calibrate_at: Optional[int] = None, evaluations: int = 4,
             keep_disparities: bool = False, **options: Any) -> Simulation:
    """Plays frames through a Board made for the first of them; options as Board's. None: a frame that did not come."""
    result, board, lost = Simulation(), None, 0
    for pair in frames:
        if pair is None and board is None:
            lost += 1
            continue
        if board is None:
            assert pair is not None
            first = _frame("left", pair[0])
            board = Board(first.shape[1], first.shape[0], channels=first.shape[2] if first.ndim == 3 else 1, **options)
            result.steps += [board.miss() for _ in range(lost)]
        if calibrate_at == len(result.steps):
            board.calibrate()
        step = board.miss() if pair is None else board.frame(*pair, evaluations=evaluations)
        if step.state == "degraded":
            result.alarms.append(len(result.steps))
        if not keep_disparities:
            step.disparity = None
        result.steps.append(step)
    if board is None:
        raise ValueError("frames: there is none to simulate")
    board.finish()
    result.runs, result.params, result.corrected, result.stored = board.runs, board.params, board.corrected, board.stored
    return result
