# SPDX-License-Identifier: MIT
"""The tuner: ask for a point, score it however you like, tell its cost."""
from __future__ import annotations

import ctypes
import numbers
from typing import Callable, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

from ._native import DIMS, TUNE_BYTES, Point, TuneConfig, lib

NAMES = ("p1", "p2", "block_size", "uniqueness_ratio", "pre_filter_cap", "disp12_max_diff")
METHODS = {"ncg": 0, "ncg-paper": 1, "sd": 2, "hybrid": 3, "descent": 4}
PURPOSES = {"any": 0, "bad": 1, "chow": 2, "d1": 1}  # bad's ladder serves d1 as well
FAILED = float("inf")
_FAILED_Q20 = 2**31 - 1
PointDict = Dict[str, int]


def _choice(name: str, value: str, table: Mapping[str, int]) -> int:
    if not isinstance(value, str) or value not in table:
        raise ValueError(f"{name} = {value!r}: one of {', '.join(table)}")
    return table[value]


def _whole(name: str, value: object, low: int, high: int, what: str = "") -> int:
    if isinstance(value, bool) or not isinstance(value, numbers.Integral):
        raise TypeError(f"{name} = {value!r}: must be a whole number")
    whole = int(value)
    if not low <= whole <= high:
        raise ValueError(f"{name} = {whole}: must be {low}..{high}{what}")
    return whole


def cheap_for(purpose: str) -> Tuple[str, ...]:
    """What `stad tune` has settled wherever it gets to, because it keeps winners: for bad alone (docs/TUNING.md)."""
    return ("uniqueness_ratio", "disp12_max_diff") if purpose == "bad" else ()


class Tuner:
    """An ask/tell search over p1, p2, block_size, uniqueness_ratio, pre_filter_cap, disp12_max_diff.

    start: a value for each name. purpose: the cost that will be told ("bad", "chow", "d1"; "any" brings no start ladder).
    channels: of the frames. free: names that may move (default all). cheap: names whose change alone costs next to nothing, to be
    settled wherever the search gets to. limits: name -> (lowest, highest). seed: of the draws of hybrid and of the crosses that
    end ncg; the same seed and costs give the same search everywhere. bytes(tuner) is its whole state; restore() goes on."""

    def __init__(self, start: Mapping[str, int], purpose: str = "bad", method: str = "ncg", budget: int = 100,
                 free: Optional[Iterable[str]] = None, limits: Optional[Mapping[str, Tuple[int, int]]] = None, seed: int = 0,
                 patience: bool = False, channels: int = 1, cheap: Iterable[str] = ()) -> None:
        config = TuneConfig()
        lib.stad_tune_config_stereo(config, _choice("purpose", purpose, PURPOSES))
        config.method = _choice("method", method, METHODS)
        config.budget = _whole("budget", budget, 1, 240, " distinct evaluations")
        config.seed = _whole("seed", seed, 0, 2**32 - 1)
        if channels not in (1, 3):
            raise ValueError(f"channels = {channels!r}: 1 or 3")
        if patience not in (False, True):  # 0 and 1 are equal to them
            raise TypeError(f"patience = {patience!r}: must be False or True")
        for rung in config.ladder[:config.ladder_count]:  # made for grey frames
            rung[0], rung[1] = rung[0] * channels, rung[1] * channels
        config.patience = int(patience)
        if free is not None:
            config.free_mask = self._mask("free", free)
        config.cheap_mask = self._mask("cheap", cheap)
        for name, (low, high) in (limits or {}).items():
            axis = config.axis[self._index(name)]
            least = 0 if name == "uniqueness_ratio" else 1
            if not least <= low <= high <= 32767:
                raise ValueError(f"limits: {name} = ({low}, {high}): must be lowest and highest, within {least}..32767")
            axis.lo, axis.hi = low, high
        if not isinstance(start, Mapping):
            raise TypeError(f"start = {start!r}: must be a mapping from each name to its value")
        missing = [name for name in NAMES if name not in start]
        if missing or len(start) != DIMS:
            strange = [name for name in start if name not in NAMES]
            raise ValueError("start: " + "; ".join(f"{what} {', '.join(names)}" for what, names in (("missing", missing), ("unknown", strange)) if names))
        for name in NAMES:
            if not isinstance(start[name], numbers.Integral) or not -32768 <= start[name] <= 32767:
                raise ValueError(f"start: {name} = {start[name]!r}: must be a whole number within -32768..32767")
        culprit = ctypes.c_char_p()
        if lib.stad_tune_config_check(config, ctypes.byref(culprit)) != 0:
            raise ValueError(f"{(culprit.value or b'config').decode()}: refused by the tuner")
        self._state = ctypes.create_string_buffer(TUNE_BYTES)
        lib.stad_tune_init(self._state, config, Point(*(start[name] for name in NAMES)))

    @staticmethod
    def _index(name: str) -> int:
        if name not in NAMES:
            raise ValueError(f"{name!r} is no parameter of the tuner: one of {', '.join(NAMES)}")
        return NAMES.index(name)

    @classmethod
    def _mask(cls, argument: str, given: Iterable[str]) -> int:
        if isinstance(given, (str, bytes)) or not isinstance(given, Iterable):
            raise TypeError(f"{argument} = {given!r}: must be a list of names")
        return sum(1 << i for i in {cls._index(name) for name in given})

    def ask(self) -> Optional[PointDict]:
        """The point to score, or None when the search is over."""
        x = Point()
        return dict(zip(NAMES, x)) if lib.stad_tune_ask(self._state, x) == 1 else None

    def tell(self, cost: Union[float, int]) -> None:
        """The cost of the point asked for: a fraction >= 0. FAILED or NaN: it could not be scored. Kept as a multiple of 2^-20."""
        if not isinstance(cost, numbers.Real):
            raise TypeError(f"cost = {cost!r}: must be a number")
        self.tell_q20(_FAILED_Q20 if cost == FAILED or cost != cost else self._q20(cost))

    @staticmethod
    def _q20(cost: Union[float, int]) -> int:
        if not 0 <= cost < 2047:
            raise ValueError(f"cost = {cost}: must be 0..2047, or FAILED")
        return round(cost * 2**20)

    def tell_q20(self, cost_q20: int) -> None:
        """The same in the library's own unit (Scorer.cost_q20)."""
        if lib.stad_tune_tell(self._state, _whole("cost_q20", cost_q20, 0, _FAILED_Q20)) != 0:
            raise ValueError("tell: no point was asked for, the search is over")

    def best(self) -> Tuple[PointDict, float]:
        """The best point so far and its cost."""
        x, cost = Point(), ctypes.c_int32()
        if lib.stad_tune_best(self._state, x, cost) != 0:
            raise ValueError("best: nothing has been scored yet")
        return dict(zip(NAMES, x)), cost.value / 2**20

    def trace(self) -> List[Tuple[PointDict, float]]:
        """Every distinct evaluation in order; a failed one has the cost FAILED."""
        out: List[Tuple[PointDict, float]] = []
        x, cost = Point(), ctypes.c_int32()
        while lib.stad_tune_trace(self._state, len(out), x, cost) == 0:
            out.append((dict(zip(NAMES, x)), FAILED if cost.value == _FAILED_Q20 else cost.value / 2**20))
        return out

    def counts(self) -> Dict[str, int]:
        c = lib.stad_tune_counts_of(self._state)
        return {"evaluations": c.evaluations, "iterations": c.iterations, "calls": c.calls}

    def __bytes__(self) -> bytes:
        return self._state.raw

    @classmethod
    def restore(cls, state: bytes) -> "Tuner":
        """A tuner that goes on where bytes(tuner) was taken, with the same version of the library."""
        if len(state) != TUNE_BYTES:
            raise ValueError(f"state: {len(state)} bytes, not {TUNE_BYTES}")
        tuner = cls.__new__(cls)
        tuner._state = ctypes.create_string_buffer(bytes(state), TUNE_BYTES)
        if lib.stad_tune_check(tuner._state) != 0:
            raise ValueError("state: not that of a tuner, or damaged")
        return tuner


def tune(cost_of: Callable[[PointDict], float], start: Mapping[str, int], **options: object) -> Tuner:
    """Runs a search to its end; cost_of(point) gives each cost. Options as Tuner's."""
    tuner = Tuner(start, **options)  # type: ignore[arg-type]
    point = tuner.ask()
    while point is not None:
        tuner.tell(cost_of(point))
        point = tuner.ask()
    return tuner


def as_opencv(point: Mapping[str, int]) -> Dict[str, int]:
    """A point as arguments of StereoSGBM_create()."""
    names: Sequence[str] = ("P1", "P2", "blockSize", "uniquenessRatio", "preFilterCap", "disp12MaxDiff")
    return {theirs: point[ours] for theirs, ours in zip(names, NAMES)}
