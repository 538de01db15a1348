"""Estimates the noise of the gyro from a mouse at rest."""

from dataclasses import dataclass

import numpy as np

from ._estimates import Array, Estimate, jackknife, within
from ._logs import Log
from ._motion import Motion


@dataclass
class GyroFit:
    """The result of fit_gyro."""

    noise: Estimate = Estimate()  #: standard deviation of a reading in rad/s, without rounding
    rest: float = 0.0  #: s at rest
    missed: float = 0.0  #: relative rms difference between each quarter of the rest and the others
    refusal: str = ""  #: why there is no fit


def fit_gyro(log: Log, motion: Motion) -> GyroFit:
    """Estimates the standard deviation of the gyro's readings from rows in which the mouse stands still.

    Method: second differences of white noise have six times its variance, and contain neither bias nor drift; first
    differences have twice its variance. If the two disagree, the noise is not white, and the error includes the
    difference. The standard error is that of a jackknife over 20 blocks. Rounding adds the variance of a uniform
    distribution over one quantization step, which is subtracted (Sheppard 1898).
    """
    if "gyro" not in log:
        return GyroFit(refusal="the log has no gyro")
    fit = GyroFit(rest=sum(1e-3 * (end - begin) for begin, end in motion.rests))
    pairs, unit = _differences(log, motion)
    if len(pairs) < 100:
        fit.refusal = f"the mouse stands for {len(pairs)} rows, and must for 100, no motor driven"
        return fit

    def by_second(squares: Array, count: float) -> float:
        return float(np.sqrt(max(0.0, squares[1] / count / 6.0 - unit * unit / 12.0)))

    sums, count = (pairs**2).sum(axis=0), len(pairs)
    noise = by_second(sums, count)

    def parts(number: int) -> list[Array]:
        return [part**2 for part in np.split(pairs, [-(-i * count // number) for i in range(1, number)])]

    without = [by_second(sums - part.sum(axis=0), count - len(part)) for part in parts(20)]
    not_white = np.sqrt(sums[0] / count / 2.0) - np.sqrt(sums[1] / count / 6.0)
    error = float(np.hypot(jackknife(without), not_white))
    quarters = [(part[:, 1].mean(), (sums[1] - part[:, 1].sum()) / (count - len(part))) for part in parts(4)]
    fit.missed = float(np.sqrt(np.mean([(np.sqrt(own / other) - 1.0) ** 2 if other > 0.0 else 0.0 for own, other in quarters])))
    fit.noise = within(noise, error, 0.5 * noise, "its noise at rest is not white", 19.0)
    if not noise > 0.0:
        fit.noise, fit.refusal = Estimate(), "it shows no noise at rest that is more than a unit of it"
    return fit


def _differences(log: Log, motion: Motion) -> tuple[Array, float]:
    """First and second differences of rows at rest, shape (n, 2), and the smallest step of the gyro."""
    pairs = []
    for begin, end in motion.rests:
        first = np.diff(log["gyro"][(log.times >= begin) & (log.times < end)])
        pairs.append(np.column_stack([first[1:], np.diff(first)]) if len(first) > 1 else np.empty((0, 2)))
    every = np.concatenate(pairs) if pairs else np.empty((0, 2))
    steps = np.abs(every[:, 0])
    return every, float(steps[steps > 0.0].min()) if (steps > 0.0).any() else 0.0
