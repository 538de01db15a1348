"""Estimates gain, time constant and dead zone of the motors from duties and motion, per axis (driving or turning).

Model: T dv/dt = K (u - u0 sign(v)) - v, with rate v, PWM duty u, gain K, time constant T and dead zone u0. In some logs,
the dead zone acts on the input instead: T dv/dt = K (u - clip(u, -u0, u0)) - v.
"""

import math
from dataclasses import dataclass
from typing import Any, Optional, Sequence, Union

import numpy as np

from ._estimates import Array, Blocks, Estimate, jackknife, within
from ._motion import TICK, rates
from ._response import Problem, Series, Solution, covariance_root, windows_of

# The pushes, by their index: the duty of the axis; that of the other axis (MotorFit.mixed); friction; the correction of
# Axis.factor. Extended models have one more: the lag in s, or the drag in duty per squared rate. The last one replaces the
# duty if friction is not fitted: the duty without the dead zone of the base. A duty comes first in a set of pushes.
_DUTY, _OTHER, _FRICTION, _TAKEN, _LAG, _DRAG, _REDUCED = range(7)
# Ticks: the longest and the shortest stretch.
_LONGEST, _SHORTEST = 1000, 80
_MOST_BLOCKS, _LEAST_WINDOWS = 20, 6
_ALTERNATING = -0.2  # correlation of a residual with the one before
_LEAST_ZONE = 0.03  # duty: standard error of a dead zone that is assumed
_FINE = 0.0015  # s: up to this, rows are as fine as the steps of a controller
_DECIDED = 4.0  # ln of a ratio of likelihoods
_BETTER = 0.05  # the same for each equation
_MUCH = 3.0  # residuals above this multiple of the noise count as unexplained


@dataclass
class Axis:
    """The data of a log for one axis. Arrays have the shape (ticks,), except times."""

    place: Array  #: position in mm or rad
    rate: Array  #: its derivative per second
    duty: Array  #: of this axis
    other: Array  #: duty of the other axis, since unequal motors mix them
    times: Array  #: of the rows in ms
    gain: float  #: of the base robot; rates below 0.6 % of it count as slow
    time: float  #: time constant of the base robot in s
    dead_zone: float = 0.0  #: of the base robot
    resolution: float = 0.0  #: step from a duty to the next one that the log can tell
    unloaded: Optional[tuple[Array, Array]] = None  #: duty and other if the battery did not sag; None: voltages are known
    taken: Optional[Array] = None  #: turning rate in rad/s with the sign of the speed; the duty loses factor * taken
    factor: float = 0.0  #: of the base robot, duty per rad/s
    steps: bool = False  #: whether the duties are set in steps, so that a delay of the log can be fitted
    spans: Sequence[tuple[int, int]] = ()  #: [begin, end) in ticks, without gaps; empty: all


@dataclass
class MotorFit:
    """The result of fit_motors. Rates are in mm/s (driving) or rad/s (turning)."""

    gain: Estimate = Estimate()  #: rate at full duty
    time: Estimate = Estimate()  #: time constant in s
    dead_zone: Estimate = Estimate()  #: duty that friction takes
    taking: Estimate = Estimate()  #: duty that turning takes from driving, per rad/s
    #: Share of the other axis' duty that acts on this axis; for turning, by how much the right motor is stronger.
    mixed: Estimate = Estimate()
    by_input: bool = False  #: whether the dead zone acts on the input; otherwise it is friction
    stretches: int = 0  #: number of stretches of motion in one direction, at most a second each
    peak: float = 0.0  #: largest rate
    missed: float = 0.0  #: rms error of the rate on blocks left out of the fit
    noise: float = 0.0  #: rms of the part of `missed` that the rows before do not predict
    lag: float = 0.0  #: lag in s of a motor of the second order, if that fits better
    drag: float = 0.0  #: duty that drag takes at the peak rate, if that fits better
    refusal: str = ""  #: why there is no fit


def fit_motors(axes: "Union[Axis, Sequence[Axis]]") -> MotorFit:
    """Fits the motors of an axis to one log or several.

    Method: an output-error fit (Ljung, "System Identification", 1999). First-order motors are simulated under the duties
    of the log; least squares over windows of motion in one direction, each with its own initial position and rate, so
    six stretches or one are enough. Errors are those of a jackknife over blocks of windows. Residuals that depend on
    their predecessors (vibration, slip) enter a controller's duties and bias the fit. So a second fit uses their
    autoregressive covariance; its difference from the first one is part of the errors. If a model with lag or drag
    halves the squared errors on blocks left out of the fit, the errors include the changes that it would make. The dead
    zone is friction or that of the input, whichever is more likely.
    """
    axes = [axes] if isinstance(axes, Axis) else list(axes)
    result = MotorFit(peak=max(float(np.abs(axis.rate).max()) for axis in axes))
    stretches = [_one_way_stretches(axis, _slow(axis)) for axis in axes]
    windows = [window for i, axis in enumerate(axes) for window in windows_of(axis.times, stretches[i], i)]
    result.stretches = len(windows)
    if not windows or sum(len(window.rows) - 1 for window in windows) < 12:
        result.refusal = "it does not move long enough in one direction (0.1 s)"
        return result
    fit = _best(axes, stretches, windows)
    if fit is None:
        result.refusal = "its speeds do not follow from its duties: are these the right columns, with the right signs?"
        return result
    _fill(result, fit, axes)
    return result


def _slow(axis: Axis) -> float:
    """The rate below which a direction is uncertain. Coarse positions make it larger."""
    rows = np.interp(axis.times, np.arange(len(axis.place)), axis.place)
    steps = np.abs(np.diff(rows))
    moved = steps[steps > 1e-9]
    unit = float(moved.min()) if len(moved) else 0.0
    around = max(10.0, 2.5 * float(np.median(np.diff(axis.times)))) * TICK
    return max(0.05 * float(np.abs(axis.rate).max()), 0.006 * axis.gain, unit / (2.0 * around))


def _one_way_stretches(axis: Axis, slow: float) -> list[tuple[int, int]]:
    """Spans of at least 80 ticks with motion in one direction faster than `slow`, cut into pieces of at most 1000."""
    ways = np.where(axis.rate > slow, 1, np.where(axis.rate < -slow, -1, 0))
    stretches = []
    for first, last in axis.spans or [(0, len(ways))]:
        edges = np.concatenate([[first], first + np.flatnonzero(np.diff(ways[first:last])) + 1, [last]])
        for begin, end in zip(edges[:-1].tolist(), edges[1:].tolist()):
            size = end - begin
            if size >= _SHORTEST and ways[begin]:
                parts = -(-size // _LONGEST)
                stretches += [(begin + i * size // parts, begin + (i + 1) * size // parts) for i in range(parts)]
    return stretches


def _series(axis: Axis, stretches: list[tuple[int, int]], ahead: int = 0) -> Series:
    """The data of a log for its simulation. ahead: ticks by which duties act before their row."""
    duty, other = _moved(axis.duty, ahead), _moved(axis.other, ahead)
    ticks = len(axis.place)
    rate = rates(axis.place, 31)  # without vibration, which would be explained by itself
    sign, taken = np.zeros(ticks), np.zeros(ticks) if axis.taken is None else axis.taken
    for begin, end in stretches:
        sign[begin:end] = 1.0 if axis.rate[(begin + end) // 2] > 0.0 else -1.0
    pushes = np.column_stack([duty - axis.factor * taken, other, -sign, -taken, -np.diff(duty, prepend=duty[0]) / TICK, -rate * np.abs(rate)])
    pushes = np.column_stack([pushes, pushes[:, _DUTY] - axis.dead_zone * sign])
    place = np.interp(axis.times, np.arange(ticks), axis.place)
    return Series(place, axis.times * TICK, pushes, duty, ahead)


def _moved(values: Array, ahead: int) -> Array:
    return np.append(values[ahead:], np.full(ahead, values[-1]))


@dataclass
class _Fit:
    """A fit of a problem by a jackknife. The numbers are ln gain, ln time, dead zone, mixed, taken."""

    problem: Problem
    chosen: list[int]
    solution: Solution
    numbers: Array
    errors: Array
    missed: Array  # by block: sum of squared errors, predicted without that block
    blocks: int
    root: Optional[Array]  # of the covariance that the fit used; None: residuals counted as independent
    at_zero: bool = False  # whether the dead zone is 0 because it came out as negative
    likely: float = 0.0  # ln of the likelihood, by the part of the residuals that their predecessors do not predict


def _numbers(chosen: list[int], answer: Array, unknowns: Array, by_input: bool, dead_zone: float) -> Array:
    """The numbers of a solution, or of several: shape (..., 5). Only for a positive gain."""
    gain = answer[..., 0]

    def share(push: int) -> Any:
        return answer[..., chosen.index(push)] / gain if push in chosen else np.zeros_like(gain)

    fixed = np.full_like(gain, dead_zone if _REDUCED in chosen else 0.0)
    zone = unknowns[..., 1] if by_input else share(_FRICTION) if _FRICTION in chosen else fixed
    return np.stack([np.log(gain), unknowns[..., 0], zone, share(_OTHER), share(_TAKEN)], axis=-1)


def _fit(problem: Problem, chosen: list[int], start: Array, dead_zone: float, root: Optional[Array] = None) -> Optional[_Fit]:
    """Fits the chosen pushes. None if the log does not determine them, or if the gain is not positive."""
    solution = problem.solve(chosen, start, root)
    jacobian = np.column_stack([solution.equations, problem.slopes(solution, chosen, root)])
    windows = len(problem.windows)
    if windows >= _LEAST_WINDOWS:
        count = min(_MOST_BLOCKS, windows)
        block = np.repeat(np.arange(windows) * count // windows, problem.sizes)
    else:
        count = int(min(_MOST_BLOCKS, max(4, len(problem) // (15 if root is None else 8))))
        block = np.arange(len(problem)) * count // len(problem)
    blocks = Blocks(jacobian, solution.rest, block)
    solved = blocks.solve({})
    if solved is None:
        return None
    size = len(chosen)
    answers = solution.answer + solved[1][:, :size]
    if solution.answer[0] <= 0.0 or (windows >= _LEAST_WINDOWS and (answers[:, 0] <= 0.0).any()):
        return None
    numbers = _numbers(chosen, solution.answer, solution.unknowns, problem.by_input, dead_zone)
    if windows >= _LEAST_WINDOWS:
        errors = jackknife(_numbers(chosen, answers, solution.unknowns + solved[1][:, size:], problem.by_input, dead_zone))
    else:
        errors = _errors(problem, chosen, solution, jacobian, root, dead_zone)
    return _Fit(problem, chosen, solution, numbers, errors, blocks.squares(solved[1]), count, root)


def _errors(problem: Problem, chosen: list[int], solution: Solution, jacobian: Array, root: Optional[Array], dead_zone: float) -> Array:
    """Standard errors of the numbers if there are too few windows for a jackknife: by the covariance of residuals, which
    an autoregressive model describes (Newey and West 1987 use the same formula with another covariance)."""
    units = np.linalg.norm(jacobian, axis=0)
    plain, size = jacobian / units, len(chosen)
    left = len(jacobian) - jacobian.shape[1] - len(problem.windows)
    variance = float(solution.rest @ solution.rest) / max(1, left)
    middle = plain.T @ plain
    if root is None:
        own = covariance_root(problem.split(solution.rest))[0]
        parts = [own[: len(part), : len(part)].T @ part for part in problem.split(plain)]
        middle = sum(part.T @ part for part in parts)
    inverse = np.linalg.inv(plain.T @ plain)
    covariance = variance * inverse @ middle @ inverse / np.outer(units, units)
    slopes = []
    for i in range(jacobian.shape[1]):
        step = np.zeros(jacobian.shape[1])
        step[i] = 1e-4 * (abs(solution.answer[i]) if i < size else 1.0) + 1e-12
        ends = [
            _numbers(chosen, solution.answer + sign * step[:size], solution.unknowns + sign * step[size:], problem.by_input, dead_zone)
            for sign in (1.0, -1.0)
        ]
        slopes.append((ends[0] - ends[1]) / (2.0 * step[i]))
    errors: Array = np.sqrt(np.maximum(0.0, np.einsum("in,ij,jn->n", np.array(slopes), covariance, np.array(slopes))))
    return errors


def _weighted(fit: _Fit, dead_zone: float) -> _Fit:
    """The fit with the weights that its residuals call for.

    Coarse positions make residuals alternate: the noise of a position enters two steps with opposite signs. Then the
    inverse of their covariance as weights makes a far better fit. Otherwise, equal weights are robust.
    """
    rest = fit.solution.rest
    root, innovation = covariance_root(fit.problem.split(rest))
    if float(rest[1:] @ rest[:-1]) < _ALTERNATING * float(rest @ rest):
        better = _fit(fit.problem, fit.chosen, fit.solution.unknowns, dead_zone, root)
        if better is not None:
            fit = better
            innovation = covariance_root(fit.problem.split(fit.problem.rest(fit.solution, fit.chosen)))[1]
    fit.likely = -len(rest) * float(np.log(max(innovation, 1e-300)))
    return fit


def _row(axis: Axis) -> float:
    """Seconds from row to row."""
    return float(np.median(np.diff(axis.times))) * TICK


def _without_friction(fit: _Fit, dead_zone: float) -> _Fit:
    """The fit with a dead zone of 0 in place of a negative one, which no motor has. Its errors include the difference."""
    chosen = [push for push in fit.chosen if push != _FRICTION]
    other = _fit(fit.problem, chosen, fit.solution.unknowns, dead_zone, fit.root)
    if other is None:
        return fit
    other.errors = np.hypot(other.errors, other.numbers - fit.numbers)
    other.errors[2], other.likely, other.at_zero = fit.errors[2], fit.likely, True
    return other


def _stepwise(axis: Axis) -> bool:
    """Whether the duties are set in steps and the rows are coarse, so that the time of a step is to be fitted."""
    return axis.steps and _row(axis) > _FINE


def _pushes(problem: Problem, axis: Axis) -> "list[list[int]]":
    """The sets of pushes to try, from all to the duty alone; those that do not occur in the windows are left out."""
    rows = [problem.series[one.series].pushes for one in problem.windows]
    late = (_LAG,) if _stepwise(axis) else ()
    ever = np.max([np.abs(one).max(axis=0) for one in rows], axis=0) > 1e-9
    every = [push for push in (_DUTY, _OTHER, _FRICTION, _TAKEN, *late) if ever[push] and not (problem.by_input and push == _FRICTION)]
    sets: list[list[int]] = []
    without = [(*late, *more) for late in ((), (_LAG,)) for more in ((), (_TAKEN,), (_TAKEN, _OTHER))]
    for dropped in [*without, (_LAG, _TAKEN, _OTHER, _FRICTION)]:
        fewer = [push for push in every if push not in dropped]
        if fewer not in sets:
            sets.append(fewer)
    if not problem.by_input:
        sets[-1] = [_REDUCED]
    return sets


def _determined(problem: Problem, axis: Axis) -> Optional[_Fit]:
    """The fit of the first set of pushes that the log determines."""
    for chosen in _pushes(problem, axis):
        fit = _fit(problem, chosen, problem.start(axis.time), axis.dead_zone)
        if fit is None:
            continue
        fit = _weighted(fit, axis.dead_zone)
        if not problem.by_input and _FRICTION in chosen and fit.numbers[2] < 0.0:
            fit = _without_friction(fit, axis.dead_zone)
        little = (_LAG in chosen and not fit.errors[0] < 0.25) or (_OTHER in chosen and len(chosen) > 2 and not fit.errors[0] < 1.0)
        if not little and (_TAKEN not in chosen or fit.errors[4] < axis.factor):
            return fit
    return None


def _best(axes: "list[Axis]", stretches: "list[list[tuple[int, int]]]", windows: Any) -> Optional[_Fit]:
    """The most likely fit of both kinds of dead zone. If the log does not decide, the errors include the difference.

    Some loggers write the duties of the time before a row: where duties are set in steps, that is tried, too.
    """
    shifts = [0, round(_row(axes[0]) / TICK)] if _stepwise(axes[0]) else [0]
    courses = [[_series(axis, some, ahead) for axis, some in zip(axes, stretches)] for ahead in shifts]

    def likeliest(by_input: bool) -> Optional[_Fit]:
        fits = [_determined(Problem(series, windows, by_input=by_input), axes[0]) for series in courses]
        return max((fit for fit in fits if fit is not None), key=lambda fit: fit.likely, default=None)

    best, other = likeliest(False), likeliest(True)
    if best is None or other is None:
        return best or other
    better = other.likely - best.likely
    if better > max(_DECIDED, _BETTER * len(other.problem)):
        return other
    if better > -_DECIDED and (_FRICTION in best.chosen or best.at_zero):
        best.errors = np.hypot(best.errors, other.numbers - best.numbers)
    return best


def _fill(result: MotorFit, fit: _Fit, axes: "list[Axis]") -> None:
    axis, problem, errors = axes[0], fit.problem, fit.errors.copy()
    rest = problem.rest(fit.solution, fit.chosen)
    root, innovation = covariance_root(problem.split(rest))
    if fit.root is None:
        errors = np.hypot(errors, _with_covariance(fit, root, axis) - fit.numbers)
    result.by_input = problem.by_input
    result.missed = float(np.sqrt((fit.missed.sum() if fit.root is None else rest @ rest) / len(rest))) / problem.seconds
    result.noise = innovation / problem.seconds
    # Within coarse rows, duties may change at any time: half a row early or late, evenly distributed.
    row = _row(axis) * (1.0 / math.sqrt(12.0) if _row(axis) > _FINE else 0.1)
    errors[1] = math.hypot(errors[1], row / math.exp(fit.numbers[1]))
    errors[2] = math.hypot(errors[2], axis.resolution / math.sqrt(12.0))
    errors = np.hypot(errors, _without_sag(fit, axes) - fit.numbers)
    _widen(fit, result, errors, axis)
    gain, time = float(np.exp(fit.numbers[0])), float(np.exp(fit.numbers[1]))
    freedom = float(fit.blocks - 1)
    friction = problem.by_input or _FRICTION in fit.chosen or fit.at_zero
    if not friction:  # at one duty, gain and dead zone cannot be told apart
        duty = float(np.abs(axis.duty[np.abs(axis.rate) > 0.5 * result.peak]).mean())
        errors[0] = math.hypot(errors[0], max(axis.dead_zone, _LEAST_ZONE) / max(duty - axis.dead_zone, _LEAST_ZONE))
        without = _fit(problem, [_DUTY], fit.solution.unknowns, 0.0)
        errors[1] = math.hypot(errors[1], without.numbers[1] - fit.numbers[1]) if without else math.inf
    why = _reason(result, friction)
    most = 0.25 if friction else 0.0
    result.gain = within(gain, gain * errors[0], most * gain, why, freedom, True)
    result.time = within(time, time * errors[1], most * time, why, freedom, True)
    if friction:
        result.dead_zone = within(max(0.0, fit.numbers[2]), errors[2], 0.03, why, freedom)
    result.mixed = within(fit.numbers[3], errors[3], 0.1, "the duties of both axes change together", freedom) if _OTHER in fit.chosen else Estimate()
    if _TAKEN in fit.chosen:
        result.taking = within(max(0.0, axis.factor + fit.numbers[4]), errors[4], axis.factor, "it hardly turns while it drives", freedom)


def _without_sag(fit: _Fit, axes: "list[Axis]") -> Array:
    """The numbers if the battery did not sag, as it is assumed to where the log has no voltages."""
    if all(axis.unloaded is None for axis in axes):
        return fit.numbers
    series = []
    for axis, one in zip(axes, fit.problem.series):
        pushes, duty = one.pushes, one.duty
        if axis.unloaded is not None:
            change = np.zeros_like(pushes)
            duty = _moved(axis.unloaded[0], one.ahead)
            change[:, _DUTY] = change[:, _REDUCED] = duty - one.duty
            change[:, _OTHER] = _moved(axis.unloaded[1] - axis.other, one.ahead)
            pushes = pushes + change
        series.append(Series(one.place, one.times, pushes, duty, one.ahead))
    problem = Problem(series, fit.problem.windows, by_input=fit.problem.by_input)
    solution = problem.solve(fit.chosen, fit.solution.unknowns, fit.root)
    if solution.answer[0] <= 0.0:
        return fit.numbers
    return _numbers(fit.chosen, solution.answer, solution.unknowns, problem.by_input, axes[0].dead_zone)


def _with_covariance(fit: _Fit, root: Array, axis: Axis) -> Array:
    """The numbers of the fit that uses the covariance of residuals."""
    solution = fit.problem.solve(fit.chosen, fit.solution.unknowns, root)
    if solution.answer[0] <= 0.0:
        return fit.numbers + 1.0
    return _numbers(fit.chosen, solution.answer, solution.unknowns, fit.problem.by_input, axis.dead_zone)


def _widen(fit: _Fit, result: MotorFit, errors: Array, axis: Axis) -> None:
    """Increases the errors by the changes under models with lag or drag, if they fit better."""
    if len(fit.problem.windows) < _LEAST_WINDOWS:
        return  # too little is left out to compare models
    for more in (_DRAG,) if _LAG in fit.chosen else (_LAG, _DRAG):
        other = _fit(fit.problem, [*fit.chosen, more], fit.solution.unknowns, axis.dead_zone, fit.root)
        if other is None or other.missed.sum() > 0.5 * fit.missed.sum():
            continue
        size = float(other.solution.answer[-1] / other.solution.answer[0])
        if more == _DRAG and size <= 0.0:
            continue
        errors[:] = np.hypot(errors, other.numbers - fit.numbers)
        if more == _LAG:
            result.lag = size
        else:
            result.drag = size * result.peak**2


def _reason(fit: MotorFit, friction: bool) -> str:
    if not friction:
        return "its dead zone is that of the base robot: it moves at one duty alone"
    if fit.lag:
        return f"it is no motor of the first order, but lags by {1e3 * fit.lag:.1f} ms more"
    if fit.drag:
        return "something brakes it more, the faster it goes"
    if fit.noise > 0.0 and fit.missed > _MUCH * fit.noise:
        return "the motion does not follow from the duties alone"
    return "speeds and duties differ too little"
