"""Estimates gain, time constant and dead zone of the motors from duties and motion, per axis (driving or turning).

Model: T dv/dt = K (u - u0 sign(v)) - v, with rate v, PWM duty u, gain K, time constant T and dead zone u0.
"""

from dataclasses import dataclass
from typing import Any, Optional

import numpy as np

from ._estimates import Array, Blocks, Estimate, fits_better, jackknife, within
from ._motion import TICK

# The unknowns, in this order: K/T; K/T times the share of the other axis' duty (MotorFit.mixed); K u0/T; K/T times the
# correction of Axis.factor; 1/T. Extended models have one more: K/T times the lag in s, or K/T times the drag in duty
# per squared rate.
_DUTY, _OTHER, _FRICTION, _TAKEN, _RATE, _LAG, _DRAG = range(7)
# Ticks: the longest and the shortest stretch, and the window over which rates are averaged, including the filter.
_LONGEST, _SHORTEST, _COMPARED = 300, 80, 56
_MUCH = 3.0  # residuals above this multiple of the noise count as unexplained


@dataclass
class Axis:
    """The data of a log for one axis; arrays have the shape (ticks,)."""

    place: Array  #: position in mm or rad
    rate: Array  #: its derivative per second
    duty: Array  #: of this axis
    other: Array  #: duty of the other axis, since unequal motors mix them
    filtered: int  #: window of the moving average in ticks, 1 to 40, which removes vibration
    gain: float  #: of the base robot; rates below 0.6 % of it count as slow
    time: float  #: time constant of the base robot in s
    taken: Optional[Array] = None  #: turning rate in rad/s with the sign of the speed; the duty loses factor * taken
    factor: float = 0.0  #: of the base robot, duty per rad/s


@dataclass
class MotorFit:
    """The result of fit_motors. Rates are in mm/s (driving) or rad/s (turning)."""

    gain: Estimate = Estimate()  #: rate at full duty
    time: Estimate = Estimate()  #: time constant in s; the base's, with error 0, if the log does not determine it
    dead_zone: Estimate = Estimate()  #: duty that friction takes
    taking: Estimate = Estimate()  #: duty that turning takes from driving, per rad/s
    #: Share of the other axis' duty that acts on this axis; for turning, by how much the right motor is stronger.
    mixed: Estimate = Estimate()
    time_known: bool = True  #: False if the gain was fitted with the base's time constant
    stretches: int = 0  #: number of stretches of motion in one direction
    peak: float = 0.0  #: largest rate
    missed: float = 0.0  #: rms error of the rate on stretches left out of the fit
    noise: float = 0.0  #: rms of the part of `missed` that is measurement noise
    changes: float = 0.0  #: rms of the rate without its mean in each stretch: what the model has to explain
    lag: float = 0.0  #: lag in s of a motor of the second order, if that fits better
    drag: float = 0.0  #: duty that drag takes at the peak rate, if that fits better
    refusal: str = ""  #: why there is no fit


def fit_motors(axis: Axis) -> MotorFit:
    """Fits the motors of an axis.

    Method: integrated twice, the model gives the position as a sum of known curves, linear in 1/T, K/T and K u0/T. So
    no measured signal is differentiated (Garnier and Wang, "Identification of continuous-time models from sampled
    data", 2008). Least squares over short stretches of motion in one direction, each with its own initial position and
    rate. Errors are those of a jackknife over blocks of stretches. If a model with lag or drag predicts blocks left out
    of the fit better, the errors include the changes that it would make. If residuals stay well above the noise even
    then, the errors grow by the unexplained share of the motion.
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
    """Spans of at least 80 ticks with motion in one direction faster than `slow`, cut into pieces of at most 300."""
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
    """Moving average over `filtered` rows, against vibration and encoder errors. It keeps linear equations valid."""
    sums = np.concatenate([np.zeros((1, *values.shape[1:])), np.cumsum(values, axis=0)])
    means: Array = (sums[filtered:] - sums[:-filtered]) / filtered
    return means


def _rate_changes(places: Array, filtered: int) -> Array:
    over = _COMPARED - filtered
    return (places[over:] - places[:-over]) / (over * TICK)


def _curves(axis: Axis, begin: int, end: int) -> Array:
    """The contribution of each unknown to the position, and the position itself, shape (ticks, 8). Filtered, without
    the best straight line: that removes the initial position and rate."""
    span = slice(begin, end)
    size, sign = end - begin, 1.0 if axis.rate[(begin + end) // 2] > 0.0 else -1.0
    place, rate = axis.place[span] - axis.place[begin], axis.rate[span]
    taken = np.zeros(size) if axis.taken is None else axis.taken[span]
    pushes = np.zeros((size, 8))
    pushes[:, _DUTY], pushes[:, _OTHER] = axis.duty[span] - axis.factor * taken, axis.other[span]
    pushes[:, _FRICTION], pushes[:, _TAKEN], pushes[:, _DRAG] = -sign, -taken, -rate * np.abs(rate)
    # As in the simulated body: the duty of a tick changes the rate of the next one, and that rate the position.
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
    missed: Array  # by block: sum of squared rate errors, predicted without that block


class _Model:
    def __init__(self, axis: Axis, stretches: list[tuple[int, int]]) -> None:
        self.count = min(20, len(stretches))
        block = [i * self.count // len(stretches) for i in range(len(stretches))]
        curves = [_curves(axis, begin, end) for begin, end in stretches]
        numbers = np.repeat(block, [len(one) for one in curves])
        whole = np.concatenate(curves)
        self.blocks = Blocks(whole[:, :7], whole[:, 7], numbers)
        changes = [_rate_changes(one, axis.filtered) for one in curves]
        #: The normal equations of the rates by block, from which the rate errors of a solution follow.
        every = np.concatenate(changes)
        self.rates = Blocks(every[:, :7], every[:, 7], np.repeat(block, [len(one) for one in changes]))
        self.ticks, self.changes = len(every), float((every[:, 7] ** 2).sum())

    def fit(self, fixed: dict[int, float]) -> Optional[_ModelFit]:
        """Fits the model. None if the log does not determine it, or if gain or time constant are not positive."""
        solved = self.blocks.solve(fixed)
        if solved is None:
            return None
        answers = np.vstack([solved[0], solved[1]])
        if not ((answers[:, _DUTY] > 0.0) & (answers[:, _RATE] > 0.0) & (answers[:, _RATE] < 1.0 / TICK)).all():
            return None
        duty, rate = answers[:, _DUTY], answers[:, _RATE]
        # Discrete time: each tick, a rate approaches its steady value by the factor 1 - exp(-tick/T).
        time = -TICK / np.log1p(-rate * TICK)
        numbers = np.column_stack([duty / rate, time, answers[:, _FRICTION] / duty, answers[:, _OTHER] / duty, answers[:, _TAKEN] / duty])
        return _ModelFit(solved[0], numbers[0], jackknife(numbers[1:]), self.rates.squares(solved[1]))

    def rms(self, squares: Any) -> float:
        return float(np.sqrt(squares / self.ticks))


def _choose(model: _Model, axis: Axis) -> "tuple[dict[int, float], Optional[_ModelFit]]":
    """The fixed unknowns and the fit of the first model that the log determines well; if none, those of the last model.

    The time constant is fitted first; if the log does not determine it, the base robot's is used. The duty that turning
    takes (`MotorFit.taking`) is handled in the same way.
    """
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
    """Increases the errors by the changes under better models with lag or drag. Returns the smallest sum of squares."""
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
    """The measurement noise as a rate: the median rms residual of a cubic fitted to pieces of 120 ticks."""
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
