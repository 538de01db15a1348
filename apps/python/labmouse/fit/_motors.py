"""Gain, time constant and dead zone of the motors of an axis (driving on, or turning), from duties and motion.

The model: T dv/dt = K (u - u0 sign(v)) - v, with the rate v, the duty u, the gain K, the time constant T and the dead zone u0.
"""

from dataclasses import dataclass
from typing import Any, Optional

import numpy as np

from ._estimates import Array, Blocks, Estimate, fits_better, jackknife, within
from ._motion import TICK

# The unknowns: K/T, the same for the other axis, K u0/T, what takes more of the duty than is known, 1/T; and those of models of
# the next order: K/T times the lag, and drag by the square of the rate.
_DUTY, _OTHER, _FRICTION, _TAKEN, _RATE, _LAG, _DRAG = range(7)
# Ticks: of the longest and the shortest stretch; in whose mean rates are compared, those of the filter among them.
_LONGEST, _SHORTEST, _COMPARED = 300, 80, 56
_MUCH = 3.0  # what is left counts as more than noise from so many times of it on


@dataclass
class Axis:
    """What a log has of an axis; arrays have the shape (ticks,)."""

    place: Array  #: mm or rad
    rate: Array  #: its change for a second
    duty: Array  #: of this axis
    other: Array  #: duty of the other axis, since unequal motors mix them
    filtered: int  #: ticks, 1 to 40, in whose mean nothing swings any more
    gain: float  #: of the base; rates below 0.6 % of it count as slow
    time: float  #: s, of the base
    taken: Optional[Array] = None  #: what takes of the duty, but for the factor
    factor: float = 0.0  #: of the base


@dataclass
class MotorFit:
    """The fit of an axis. Rates are in mm/s (driving on) or rad/s (turning)."""

    gain: Estimate = Estimate()  #: rate at full duty
    time: Estimate = Estimate()  #: s; of the base, with error 0, where the log does not tell it
    dead_zone: Estimate = Estimate()  #: duty
    taking: Estimate = Estimate()  #: duty that turning takes from driving on, for a rad/s
    mixed: Estimate = Estimate()  #: share of the other axis' duty; turning: by how much the right motor is stronger
    time_known: bool = True  #: False where the gain is for the base's time
    stretches: int = 0  #: number of stretches of moving one way
    peak: float = 0.0  #: largest rate
    missed: float = 0.0  #: rms by which the rate on stretches that are left out is missed
    noise: float = 0.0  #: how much of that is no motion
    changes: float = 0.0  #: rms of the rate that was to explain
    lag: float = 0.0  #: s by which a motor of the second order lags, where that fits better
    drag: float = 0.0  #: duty that drag takes at the peak, where that fits better
    refusal: str = ""  #: why there is no fit


def fit_motors(axis: Axis) -> MotorFit:
    """Fits an axis.

    Method: integrated twice, the model makes the place a sum of known curves, linear in 1/T, K/T and K u0/T, without a
    derivative of anything measured (Garnier and Wang, "Identification of continuous-time models from sampled data", 2008). Least
    squares over short stretches of moving one way, each with a place and a rate of its own to begin with. Errors are those of a
    jackknife over blocks of stretches. Where a model with lag or drag fits blocks that are left out better, errors contain what it
    would change; where even that leaves much more than noise, they grow by the share of the motion that is not explained.
    """
    result = MotorFit(peak=float(np.abs(axis.rate).max()))
    stretches = _one_way_stretches(axis.rate, max(0.05 * result.peak, 0.006 * axis.gain))
    result.stretches = len(stretches)
    if len(stretches) < 6:
        result.refusal = f"it moves one way long enough {len(stretches)} times, and must 6 times"
        return result
    model = _Model(axis, stretches)
    fixed, chosen = _choose(model, axis)
    if chosen is None:
        result.refusal = "its speeds do not follow from its duties: are these the right columns, with the right signs?"
        return result
    numbers, errors = chosen.numbers, chosen.errors.copy()
    result.time_known = _RATE not in fixed
    result.missed, result.changes = model.rms(chosen.missed.sum()), model.rms(model.changes)
    result.noise = _noise(axis, stretches)
    left = model.rms(_widen(model, fixed, chosen, result, errors))
    if left > _MUCH * result.noise:
        errors = np.hypot(errors, numbers * left / result.changes)
    result.gain = within(numbers[0], errors[0], 0.25 * numbers[0])
    result.time = within(numbers[1], errors[1], 0.25 * numbers[1]) if result.time_known else Estimate(axis.time)
    result.dead_zone = within(max(0.0, numbers[2]), errors[2], 0.03)
    result.mixed = within(numbers[3], errors[3], 0.1)
    result.taking = within(max(0.0, axis.factor + numbers[4]), errors[4], axis.factor)
    if not result.gain.known or (result.time_known and not result.time.known):
        result.refusal = _reason(result, numbers, errors)
        result.gain = result.time = result.dead_zone = result.mixed = result.taking = Estimate()
    return result


def _one_way_stretches(rate: Array, slow: float) -> list[tuple[int, int]]:
    """Spans of at least 80 ticks in which it moves one way faster than `slow`, cut into pieces of at most 300."""
    ways = np.where(rate > slow, 1, np.where(rate < -slow, -1, 0))
    edges = np.concatenate([[0], np.flatnonzero(np.diff(ways)) + 1, [len(ways)]])
    stretches = []
    for begin, end in zip(edges[:-1].tolist(), edges[1:].tolist()):
        size = end - begin
        if ways[begin] and size >= _SHORTEST:
            parts = -(-size // _LONGEST)
            stretches += [(begin + i * size // parts, begin + (i + 1) * size // parts) for i in range(parts)]
    return stretches


def _means(values: Array, filtered: int) -> Array:
    """Means of so many rows: they remove shaking and errors of encoders over a turn, and keep sums of curves what they are."""
    sums = np.concatenate([np.zeros((1, *values.shape[1:])), np.cumsum(values, axis=0)])
    means: Array = (sums[filtered:] - sums[:-filtered]) / filtered
    return means


def _rate_changes(places: Array, filtered: int) -> Array:
    over = _COMPARED - filtered
    return (places[over:] - places[:-over]) / (over * TICK)


def _curves(axis: Axis, begin: int, end: int) -> Array:
    """What each part of the equation makes of the place, and the place: (ticks, 8), filtered, without line."""
    span = slice(begin, end)
    size, sign = end - begin, 1.0 if axis.rate[(begin + end) // 2] > 0.0 else -1.0
    place, rate = axis.place[span] - axis.place[begin], axis.rate[span]
    taken = np.zeros(size) if axis.taken is None else axis.taken[span]
    pushes = np.zeros((size, 8))
    pushes[:, _DUTY], pushes[:, _OTHER] = axis.duty[span] - axis.factor * taken, axis.other[span]
    pushes[:, _FRICTION], pushes[:, _TAKEN], pushes[:, _DRAG] = -sign, -taken, -rate * np.abs(rate)
    # As a body adds up: the duty of a tick changes the rate of the next one, and that the place.
    once = np.concatenate([np.zeros((1, 8)), np.cumsum(pushes[:-1] * TICK, axis=0)])
    curves = np.cumsum(once * TICK, axis=0)
    curves[:, _RATE] = -np.concatenate([[0.0], np.cumsum(place[:-1] * TICK)])
    curves[:, _LAG] = -once[:, _DUTY]
    curves[:, 7] = place
    means = _means(curves, axis.filtered)
    line = np.linspace(-1.0, 1.0, len(means))
    means -= means.mean(axis=0) + np.outer(line, line @ means) / (line @ line)
    return means


@dataclass
class _ModelFit:
    answer: Array
    numbers: Array  # gain, time, dead zone, mixed, taken
    errors: Array
    missed: Array  # by block, squares of rates


class _Model:
    def __init__(self, axis: Axis, stretches: list[tuple[int, int]]) -> None:
        self.count = min(20, len(stretches))
        block = [i * self.count // len(stretches) for i in range(len(stretches))]
        curves = [_curves(axis, begin, end) for begin, end in stretches]
        numbers = np.repeat(block, [len(one) for one in curves])
        whole = np.concatenate(curves)
        self.blocks = Blocks(whole[:, :7], whole[:, 7], numbers)
        changes = [_rate_changes(one, axis.filtered) for one in curves]
        #: Rates of the curves, as products by block: what an answer leaves of the rates follows from them.
        every = np.concatenate(changes)
        self.rates = Blocks(every[:, :7], every[:, 7], np.repeat(block, [len(one) for one in changes]))
        self.ticks, self.changes = len(every), float((every[:, 7] ** 2).sum())

    def fit(self, fixed: dict[int, float]) -> Optional[_ModelFit]:
        """None where the log does not determine it, or a motor would brake by being driven."""
        solved = self.blocks.solve(fixed)
        if solved is None:
            return None
        answers = np.vstack([solved[0], solved[1]])
        if not ((answers[:, _DUTY] > 0.0) & (answers[:, _RATE] > 0.0) & (answers[:, _RATE] < 1.0 / TICK)).all():
            return None
        duty, rate = answers[:, _DUTY], answers[:, _RATE]
        # A rate comes nearer to a steady one by 1 - exp(-tick/T) a tick.
        time = -TICK / np.log1p(-rate * TICK)
        numbers = np.column_stack([duty / rate, time, answers[:, _FRICTION] / duty, answers[:, _OTHER] / duty, answers[:, _TAKEN] / duty])
        return _ModelFit(solved[0], numbers[0], jackknife(numbers[1:]), self.rates.squares(solved[1]))

    def rms(self, squares: Any) -> float:
        return float(np.sqrt(squares / self.ticks))


def _choose(model: _Model, axis: Axis) -> "tuple[dict[int, float], Optional[_ModelFit]]":
    """The first model that the log is certain of: with a time of its own or the base's, each with what takes of the duty as the
    log has it or as the base does."""
    fixed: dict[int, float] = {}
    fit: Optional[_ModelFit] = None
    for time in ({}, {_RATE: -np.expm1(-TICK / axis.time) / TICK}):
        fixed = {_LAG: 0.0, _DRAG: 0.0, **time}
        fit = model.fit(fixed)
        if fit is None or not fit.errors[4] < axis.factor:
            fixed[_TAKEN] = 0.0
            fit = model.fit(fixed)
        if fit is not None and (fit.errors[:2] <= 0.25 * fit.numbers[:2]).all():
            break
    return fixed, fit


def _widen(model: _Model, fixed: dict[int, float], chosen: _ModelFit, result: MotorFit, errors: Array) -> float:
    """Adds to the errors what models of the next order would change, if they fit better; returns the least squares missed."""
    least = float(chosen.missed.sum())
    for more in (_LAG, _DRAG):
        other = model.fit({unknown: value for unknown, value in fixed.items() if unknown != more})
        if other is None or not fits_better(other.missed, chosen.missed):
            continue
        least = min(least, float(other.missed.sum()))
        errors[:] = np.hypot(errors, other.numbers - chosen.numbers)
        size = float(other.answer[more] / other.answer[_DUTY])
        if more == _LAG:
            result.lag = size
        else:
            result.drag = size * result.peak**2
    return least


def _noise(axis: Axis, stretches: list[tuple[int, int]]) -> float:
    """What a place has beside a smooth motion, as a rate: the median rms over pieces of 120 ticks, without a cubic."""
    piece, squares = 120, []
    for begin, end in stretches:
        for start in range(begin, end - piece + 1, piece):
            places = _means(axis.place[start : start + piece] - axis.place[start], axis.filtered)
            x = np.linspace(-1.0, 1.0, len(places))
            rest = places - np.polynomial.legendre.legval(x, np.polynomial.legendre.legfit(x, places, 3))
            squares.append(float((_rate_changes(rest, axis.filtered) ** 2).mean()))
    return float(np.sqrt(sorted(squares)[len(squares) // 2])) if squares else 0.0


def _reason(fit: MotorFit, numbers: Array, errors: Array) -> str:
    unsure = f"its gain comes out as {numbers[0]:.4g} +- {errors[0]:.2g}"
    if fit.lag:
        return f"{unsure}: it is no motor of the first order, but lags by {1e3 * fit.lag:.1f} ms more"
    if fit.drag:
        return f"{unsure}: something brakes it more, the faster it goes"
    if fit.noise > 0.0 and fit.missed > _MUCH * fit.noise:
        return f"{unsure}: it misses stretches left out by {fit.missed / fit.noise:.0f} times the noise"
    return f"{unsure}: speeds and duties differ too little"
