"""Estimates the acceleration and yaw limits of a robot from its published or measured turns."""

import math
import os
import re
from dataclasses import dataclass, field
from importlib import import_module
from itertools import product
from pathlib import Path
from typing import Any, Sequence, Union

import numpy as np

from .. import Error, _native
from ._estimates import Array
from ._files import content_of
from ._headers import TURN_NAMES, Header, header_of, is_header
from ._turn import TURNS, Turn

COLUMNS = ("turn", "speed", "ms", "x", "y", "before", "after")
#: The largest table in MiB.
LARGEST = 1
#: Limits explain the turns if no size or time has a larger relative error than this.
_GOOD = 5e-4
LIMITS = ("lateral_acceleration", "yaw_acceleration", "yaw_speed", "yaw_jerk")


@dataclass
class TurnFit:
    """The result of fit_turns."""

    turns: Sequence[Turn]
    cell: float  #: side of a cell in mm
    #: The values of LIMITS in mm/s², rad/s², rad/s, rad/s³; 0 if the turns need no limit of yaw speed or yaw jerk.
    limits: tuple[float, ...] = (0.0, 0.0, 0.0, 0.0)
    #: For each limit, whether a turn reaches it; otherwise its value is only a lower bound.
    reached: tuple[bool, ...] = (False, False, False, False)
    numbers: int = 0  #: number of fitted limits; 0 if no limits could be fitted
    figures: int = 0  #: number of sizes and times that they were fitted to
    errors: list[float] = field(default_factory=list)  #: per turn, the largest relative error of its size and time


def read_turns(path: "Union[str, os.PathLike[str]]") -> list[Turn]:
    """The turns of read_header. Raises Error if there are none."""
    turns = read_header(path).turns
    if not turns:
        raise Error(f"{path}: error: has no turns")
    return turns


def read_header(path: "Union[str, os.PathLike[str]]") -> Header:
    """Reads a table of turns, or a C header of firmware with such tables, constants or both.

    Table: columns separated by blanks, tabs or commas; the first line names them (COLUMNS). "-" is a missing value; lines that
    begin with # are comments. C: `header_of`. Raises Error with file, line and column of up to ten problems.
    """
    text = content_of(path, LARGEST).decode("utf-8", errors="replace")
    header = header_of(text, os.fspath(path)) if is_header(text) else Header(_table_of(text, path))
    if not header.turns and not header.constants:
        raise Error(f"{path}: error: has neither turns nor constants; {' '.join(header.notes[:1]) or 'write a row as in {300, 70, 80, 90.0, 287.0, 2866.0} // SS90E'}")
    return header


def _table_of(text: str, path: "Union[str, os.PathLike[str]]") -> list[Turn]:
    problems: list[str] = []
    turns: list[Turn] = []
    names: list[str] = []
    for number, line in enumerate(text.split("\n"), 1):
        words = [(one.start() + 1, one.group()) for one in re.finditer(r"[^ \t,\r]+", line)]
        if not words or words[0][1].startswith("#"):
            continue
        wrong = _wrong_names(words) if not names else _wrong_turn(words, names)
        problems += [f"{path}:{number}:{column}: error: {reason}" for column, reason in wrong]
        if not names:
            names = [word for _, word in words]
        elif not problems:
            values = {name: float(word) + 0.0 for name, (_, word) in list(zip(names, words))[1:] if word != "-"}
            turn = TURN_NAMES.get(words[0][1], words[0][1])
            turns.append(Turn(turn, **{name: values.get(name, 0.0) for name in ("speed", "ms", "y", "before")}))
    if not names:
        problems.append(f"{path}: error: is empty; its first line must name its columns")
    elif not turns and not problems:
        problems.append(f"{path}: error: has no turns; write one a line, as in: 45 411 199")
    if problems:
        raise Error("\n".join(problems[:10]))
    return turns


def _wrong_names(words: list[tuple[int, str]]) -> list[tuple[int, str]]:
    names = [word for _, word in words]
    wrong = [(at, f"unknown column '{word}'; columns are {', '.join(COLUMNS)}") for at, word in words if word not in COLUMNS]
    wrong += [(at, f"column '{word}' is there twice; take one out") for i, (at, word) in enumerate(words) if word in names[:i]]
    return wrong + ([] if names[0] == "turn" else [(words[0][0], "the first column must be 'turn'")])


def _wrong_turn(words: list[tuple[int, str]], names: list[str]) -> list[tuple[int, str]]:
    if len(words) != len(names):
        return [(words[0][0], f"has {len(words)} columns; the first line names {len(names)}")]
    if words[0][1] not in TURNS and words[0][1] not in TURN_NAMES:
        return [(words[0][0], f"unknown turn '{words[0][1]}'; turns are {', '.join(TURNS)}, and names of UKMARS such as SS90E")]
    wrong = []
    given = {}
    for name, (at, word) in list(zip(names, words))[1:]:
        decimal = re.fullmatch(r"-?([0-9]*\.?[0-9]+(e[+-]?[0-9]+)?|[0-9]+\.)", word, re.IGNORECASE)
        given[name] = float(word) if decimal else 0.0
        # A curve may begin before the node, or end behind it.
        size = abs(given[name]) if name in ("x", "before", "after") else given[name]
        if word != "-" and not (decimal and (size == 0.0 or 0.001 <= size <= 1e6)):
            wrong.append((at, f"'{word}' must be 0, a number from 0.001 to 1000000, or - for none"))
    if not wrong and not given.get("ms") and not (given.get("speed") and given.get("y")):
        wrong.append((words[0][0], "needs its time ('ms'), or its speed with the size of its curve ('speed', 'y')"))
    return wrong


def _size_and_ms(name: str, cell: float, turn: Turn) -> tuple[float, float]:
    """Size in mm and time in ms of a turn. Yaw speed and yaw acceleration give them where the table does not."""
    if not (turn.speed > 0.0 and turn.yaw_speed > 0.0 and turn.yaw_acceleration > 0.0):
        return turn.y, turn.ms
    own = [turn.speed * turn.yaw_speed, turn.yaw_acceleration, 0.0, 0.0]
    width, _, whole = _native.turn_curve(name, turn.speed, own, cell)
    return turn.y or width, turn.ms or 1e3 * whole / turn.speed


class _Figures:
    """The sizes and times of turns, to which limits can be fitted."""

    def __init__(self, turns: Sequence[Turn], cell: float) -> None:
        self.turns = [("V90", 2.0 * cell, turn) if turn.name == "K90" else (turn.name, cell, turn) for turn in turns]
        driven = np.array([turn.speed > 0.0 for turn in turns])
        size, ms = np.array([_size_and_ms(*turn) for turn in self.turns]).T
        # The straights of a 180 may have any length: without one, its time is unknown.
        any_length = np.array([turn.name == "180" and turn.before <= 0.0 for turn in turns])
        self.known = np.column_stack([driven & (size > 0.0), driven & (ms > 0.0) & ~any_length])
        self.given = np.column_stack([size, ms])[self.known]

    def errors(self, limits: Array) -> Array:
        """The relative errors of all known sizes and times under these limits, in the order of `known`."""
        values, found = limits.tolist(), np.zeros(self.known.shape)
        for i, (name, cell, turn) in enumerate(self.turns):
            if self.known[i].any():
                width, length, whole = _native.turn_curve(name, turn.speed, values, cell)
                found[i] = width, 1e3 * (length + 2.0 * turn.before if name == "180" else whole) / turn.speed
        with np.errstate(all="ignore"):
            errors: Array = np.nan_to_num(found[self.known] / self.given - 1.0, nan=1e3, posinf=1e3, neginf=-1e3)
        return errors

    def differ(self, limits: Array, limit: int, factor: float) -> bool:
        """Whether a size or time changes if one limit (by its index) is multiplied by `factor`."""
        other = limits * np.where(np.arange(4) == limit, factor, 1.0)
        return bool((np.abs(self.errors(other) - self.errors(limits)) > 1e-9).any())


def fit_turns(turns: Sequence[Turn], cell: float) -> TurnFit:
    """Fits the limits to the turns that have a speed. cell: side of a cell in mm.

    Chooses the fewest limits that explain all sizes and times to 0.05 %; if none do, those with the smallest errors.
    Method: least squares of relative errors (Levenberg-Marquardt) from a grid of starts, then with a soft L1 loss
    beyond 3 %, so that a wrong number in the table stands out.
    """
    figures = _Figures(turns, cell)
    result = TurnFit(turns, cell, figures=len(figures.given), errors=[0.0] * len(turns))
    if not result.figures:
        return result
    best, limits = np.inf, np.zeros(4)
    for chosen in ([0, 1], [0, 1, 2], [0, 1, 3], [0, 1, 2, 3]):
        squares, answer = _best(figures, chosen)
        if squares < 0.999 * best:
            best, limits, result.numbers = squares, answer, len(chosen)
        if squares < np.inf and np.abs(figures.errors(answer)).max() <= _GOOD:
            break
    if not result.numbers:
        return result
    errors = np.zeros(figures.known.shape)
    errors[figures.known] = np.abs(figures.errors(limits))
    result.errors = errors.max(axis=1).tolist()
    result.reached = tuple(bool(limit) and figures.differ(limits, i, 1.01) for i, limit in enumerate(limits))
    for i, reached in enumerate(result.reached):
        if limits[i] and not reached:
            limits[i] = _lowest(figures, limits, i)
    result.limits = tuple(limits.tolist())
    return result


def _best(figures: _Figures, chosen: list[int]) -> tuple[float, Array]:
    """Fits the limits with these indices, the others are 0. Returns the sum of squared errors, and all four limits."""
    optimize: Any = import_module("scipy.optimize")

    def limits_of(logs: Array) -> Array:
        limits = np.zeros(4)
        limits[chosen] = np.exp(np.clip(logs, -50.0, 50.0))
        return limits

    def errors(logs: Array) -> Array:
        return np.append(figures.errors(limits_of(logs)), np.zeros(4))  # the method needs as many equations as unknowns

    fastest = max(turn.speed for _, _, turn in figures.turns)
    best, answer = np.inf, np.zeros(len(chosen))
    for lateral, acceleration, speed, jerk in product((6.0, 12.0, 24.0), (30.0, 100.0, 300.0, 1000.0), (4.0, 9.0, 20.0), (15.0, 60.0)):
        repeats = (2 not in chosen and speed != 4.0) or (3 not in chosen and jerk != 15.0)
        if repeats or (best < np.inf and np.abs(errors(answer)).max() <= 0.2 * _GOOD):
            continue
        start = np.log(np.array([lateral * fastest, acceleration, speed, jerk * acceleration])[chosen])
        found = optimize.least_squares(errors, start, method="lm", max_nfev=300)
        if 2.0 * found.cost < best and np.abs(found.fun).max() < 100.0:
            best, answer = float(2.0 * found.cost), found.x
    if best < np.inf and np.abs(errors(answer)).max() > _GOOD:
        answer = optimize.least_squares(errors, answer, loss="soft_l1", f_scale=0.03, max_nfev=100).x
    return best, limits_of(answer)


def _lowest(figures: _Figures, limits: Array, limit: int) -> float:
    """The lowest value of a limit that no turn reaches, by bisection, rounded up to 100 mm/s² or to three digits."""
    low, high = -50.0, 0.0
    for _ in range(50):
        middle = (low + high) / 2.0
        low, high = (middle, high) if figures.differ(limits, limit, math.exp(middle)) else (low, middle)
    value = float(limits[limit]) * math.exp(high)
    unit = 100.0 if limit == 0 else 10.0 ** (math.floor(math.log10(value)) - 2)
    return math.ceil(value / unit) * unit
