"""Simulates motors of the first order along a log, and fits their parameters to the measured motion.

A log is cut into windows of motion in one direction. In each window, the simulated motion starts from the rate that fits
best, so that a disturbance (a bump, a slip) affects one window alone.
"""

from dataclasses import dataclass
from importlib import import_module
from typing import Any, Optional

import numpy as np

from ._estimates import Array
from ._motion import TICK

_BIN = 5.0  # ms: faster rows are averaged over bins of about this length, which keeps noise of encoders out of the rates
_ORDER = 8  # of the autoregressive model of residuals
_FASTEST, _SLOWEST = 0.003, 3.0  # limits of a time constant, in s


@dataclass
class Window:
    """Rows of one window by bins, shape (bins, rows of a bin)."""

    rows: Any
    series: int  #: index of the log


@dataclass
class Series:
    """One log of an axis. place: by rows, in mm or rad; times: of rows in s; pushes: inputs by ticks, shape (ticks, k)."""

    place: Array
    times: Array
    pushes: Array
    duty: Array  #: of the axis, by ticks
    ahead: int = 0  #: ticks by which duties act before their row


def windows_of(times: Array, stretches: "list[tuple[int, int]]", series: int) -> list[Window]:
    """The windows of a log. times: of its rows in ms; stretches: [begin, end) in ticks."""
    size = max(1, round(_BIN / float(np.median(np.diff(times)))))
    windows = []
    for begin, end in stretches:
        rows = np.flatnonzero((times >= begin) & (times < end))
        bins = len(rows) // size
        if bins >= 4:
            windows.append(Window(rows[: bins * size].reshape(bins, size), series))
    return windows


def driven(pushes: Array, time: float) -> Array:
    """The travel by ticks of first-order motors with these inputs, from rest; as in the simulated body, the input of a
    tick changes the rate of the next one, and that rate the travel. pushes: (ticks, k)."""
    signal: Any = import_module("scipy.signal")
    share = -np.expm1(-TICK / time)
    rates: Array = signal.lfilter([0.0, share], [1.0, share - 1.0], pushes, axis=0)
    travel: Array = np.cumsum(rates, axis=0) * TICK
    return travel


class Problem:
    """The equations of all windows: the measured travel from bin to bin is that of the motors.

    The unknowns are the coefficients of the pushes, and the nonlinear ones: ln of the time constant in s and, if
    `by_input`, the dead zone of the input.
    """

    def __init__(self, series: "list[Series]", windows: "list[Window]", *, by_input: bool = False) -> None:
        self.series, self.windows, self.by_input = series, windows, by_input
        self.sizes = np.array([len(window.rows) - 1 for window in windows])
        self.seconds = float(np.mean([np.diff(series[one.series].times[one.rows].mean(axis=1)).mean() for one in windows]))

    def __len__(self) -> int:
        return int(self.sizes.sum())

    def split(self, values: Array) -> "list[Array]":
        """The values of each window."""
        return np.split(values, np.cumsum(self.sizes)[:-1])

    def equations(self, unknowns: Array, chosen: "list[int]", root: Optional[Array]) -> Array:
        """Coefficients of the chosen pushes and the measured travel, shape (equations, k + 1), without what the initial
        rate of each window explains. root: Cholesky root of the covariance of residuals, or None."""
        linear: Any = import_module("scipy.linalg")
        time = float(np.exp(unknowns[0]))
        travels = [self._by_rows(one, unknowns, chosen, time) for one in self.series]
        every = []
        for window in self.windows:
            times = self.series[window.series].times[window.rows]
            decay = np.exp((times[0, 0] - times) / time).mean(axis=1)
            steps = np.diff(np.column_stack([travels[window.series][window.rows].mean(axis=1), decay]), axis=0)
            if root is not None:
                steps = linear.solve_triangular(root[: len(steps), : len(steps)], steps, lower=True)
            free = steps[:, -1] / max(float(np.linalg.norm(steps[:, -1])), 1e-300)
            every.append(steps[:, :-1] - np.outer(free, free @ steps[:, :-1]))
        return np.concatenate(every)

    def _by_rows(self, one: Series, unknowns: Array, chosen: "list[int]", time: float) -> Array:
        pushes = one.pushes[:, chosen]
        if self.by_input:
            pushes = pushes.copy()
            pushes[:, 0] -= np.clip(one.duty, -unknowns[1], unknowns[1])
        travel = driven(pushes, time)
        ticks = np.arange(len(travel)) * TICK
        columns = [np.interp(one.times, ticks, travel[:, i]) for i in range(travel.shape[1])]
        return np.column_stack([*columns, one.place])

    def rest(self, solution: "Solution", chosen: "list[int]") -> Array:
        """The residuals of a solution, not whitened."""
        equations = self.equations(solution.unknowns, chosen, None)
        rest: Array = equations[:, -1] - equations[:, :-1] @ solution.answer
        return rest

    def start(self, time: float) -> Array:
        """Unknowns to start from. time: a time constant in s."""
        return np.array([np.log(time), 0.02]) if self.by_input else np.array([np.log(time)])

    def solve(self, chosen: "list[int]", start: Array, root: Optional[Array] = None) -> "Solution":
        """Least squares over all unknowns; for each value of the nonlinear ones, the others follow from linear equations
        (variable projection: Golub and Pereyra 1973)."""
        optimize: Any = import_module("scipy.optimize")

        def residuals(unknowns: Array) -> Array:
            return _rest(self.equations(unknowns, chosen, root))[1]

        low, high = np.array([np.log(_FASTEST), 0.0])[: len(start)], np.array([np.log(_SLOWEST), 0.9])[: len(start)]
        scale = np.array([0.3, 0.05])[: len(start)]
        start = np.clip(start, low + 1e-6, high - 1e-6)
        unknowns = optimize.least_squares(residuals, start, bounds=(low, high), diff_step=1e-3, x_scale=scale, max_nfev=60).x
        equations = self.equations(unknowns, chosen, root)
        answer, rest = _rest(equations)
        return Solution(unknowns, answer, equations[:, :-1], rest)

    def slopes(self, solution: "Solution", chosen: "list[int]", root: Optional[Array]) -> Array:
        """The derivatives of the predicted travel by the nonlinear unknowns, shape (equations, their number)."""
        columns = []
        for i in range(len(solution.unknowns)):
            step = np.zeros(len(solution.unknowns))
            step[i] = 1e-3
            one, other = (self.equations(solution.unknowns + sign * step, chosen, root) for sign in (1.0, -1.0))
            change = (one - other) / 2e-3
            columns.append(change[:, :-1] @ solution.answer - change[:, -1])
        return np.column_stack(columns)


@dataclass
class Solution:
    """A solution of a Problem."""

    unknowns: Array  #: the nonlinear ones
    answer: Array  #: the coefficients of the pushes
    equations: Array  #: (equations, k)
    rest: Array  #: residuals: measured minus predicted travel


def _rest(equations: Array) -> "tuple[Array, Array]":
    units = np.linalg.norm(equations[:, :-1], axis=0)
    units[units == 0.0] = 1.0
    answer = np.linalg.lstsq(equations[:, :-1] / units, equations[:, -1], rcond=1e-9)[0] / units
    rest: Array = equations[:, -1] - equations[:, :-1] @ answer
    return answer, rest


def covariance_root(parts: "list[Array]") -> "tuple[Array, float]":
    """The Cholesky root of the correlation of residuals from bin to bin by an autoregressive model, and the model's
    one-step prediction error as a standard deviation. parts: residuals of each window. Source: Burg 1975."""
    linear: Any = import_module("scipy.linalg")
    longest = max(len(part) for part in parts)
    order = min(_ORDER, max(1, longest // 3))
    forward, backward = [part.copy() for part in parts], [part.copy() for part in parts]
    power = sum(float(part @ part) for part in parts) / sum(len(part) for part in parts)
    covariances, model = [power * (1.0 + 1e-9)], np.zeros(0)
    for _ in range(order):
        pairs = [(one[1:], other[:-1]) for one, other in zip(forward, backward) if len(one) > 1]
        sums = sum(float(one @ one + other @ other) for one, other in pairs)
        reflection = 2.0 * sum(float(one @ other) for one, other in pairs) / sums if sums > 0.0 else 0.0
        covariances.append(reflection * power + float(model @ np.array(covariances[:0:-1])))
        model = np.append(model - reflection * model[::-1], reflection)
        power *= 1.0 - reflection * reflection
        forward = [one - reflection * other for one, other in pairs]
        backward = [other - reflection * one for one, other in pairs]
    while len(covariances) < longest:
        covariances.append(float(model @ np.array(covariances[: -order - 1 : -1])))
    if not covariances[0] > 0.0:
        return np.eye(longest), 0.0
    matrix = linear.toeplitz(np.array(covariances[:longest]) / covariances[0])
    return np.linalg.cholesky(matrix + 1e-9 * np.eye(longest)), float(np.sqrt(max(0.0, power)))
