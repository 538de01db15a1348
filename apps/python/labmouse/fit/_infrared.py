"""Estimates gain and fall-off length of infrared sensors from readings at known distances from walls.

The law: reading = gain * exp(-(distance - distance in the middle of a cell) / fall), with distances and fall in mm.
"""

import math
from dataclasses import dataclass, field
from typing import Any, Optional

import numpy as np
import pandas as pd

from ._estimates import Array, Blocks, Estimate, fits_better, jackknife, robust_weights, within
from ._logs import Log
from ._motion import Numbers

SENSORS = ("right", "right_ahead", "left", "left_ahead")
_WALLS = {"wall_right": (0,), "wall_left": (2,), "wall_ahead": (1, 3)}
_EQUAL_WALLS = 0.05  # share by which equal walls of one maze differ; logs: 4 to 8 %
_EQUAL_SENSORS = 0.03  # share by which the sensors of one mouse differ after their calibration, assumed
_LEAST_RUNS, _MOST_BLOCKS = 5, 20
# Unknowns 0 to 3 are the ln of each sensor's gain. Then follow 1/fall, and those of the alternative laws: a quadratic
# term, and an offset in counts.
_DISTANCE, _BEND, _OFFSET = 4, 5, 6


@dataclass
class InfraredFit:
    """The result of fit_infrared."""

    gain: Estimate = Estimate()  #: counts in the middle of a cell, weighted mean of the sensors
    fall: Estimate = Estimate()  #: mm in which the reading falls by the factor e
    of_sensor: dict[str, float] = field(default_factory=dict)  #: gain in counts by the names of SENSORS
    places: int = 0  #: number of runs of rows along one wall (see _parts), summed over the sensors
    missed: float = 0.0  #: relative rms error of readings at places left out of the fit
    bends: bool = False  #: whether readings deviate from the law
    readings: "Optional[pd.DataFrame]" = None  #: the fitted data: columns sensor, farther (mm), level (counts)
    refusal: str = ""  #: why there is no fit


#: What the fit needs to know of the base robot.
_NEEDED = ("sensors.side_angle", "sensors.front_angle", "sensors.infrared_most", "noise.infrared")


def fit_infrared(log: Log, robot: Numbers) -> InfraredFit:
    """Fits the law to the readings of a log.

    robot: parameters by the keys of robot files; its sensor angles, highest reading and noise are used.
    Method: ln(reading) is linear in the distance, with a gain per sensor and one fall-off for all; least squares with
    Huber's loss. All rows of a run along one wall (see _parts) share its reflectance. So a run counts once, and errors
    are those of a jackknife over blocks of runs. If a law with a quadratic term or an offset predicts runs left out of
    the fit better, the errors include the changes that it would make.
    """
    result = InfraredFit()
    if not all(key in robot for key in _NEEDED):
        result.refusal = "the base robot has no pairs of side and front sensors; take one that does, such as kerise"
        return result
    readings = _readings(log, robot)
    if readings is None:
        result.refusal = "the log has no readings of a wall at a known distance"
        return result
    kept, runs = _readable(readings, robot, {0, 1, 2, 3}, None)
    fit: "Optional[_LawFit]" = None
    for _ in range(5):  # the fitted law, not the noisy reading, decides which readings are usable
        if max(runs.values(), default=0) < _LEAST_RUNS:
            break
        fit = _Problem(kept, runs, robot, fit.law if fit else None).fit()
        if fit is None:
            break
        kept, runs = _readable(readings, robot, {one for one in runs if runs[one] >= _LEAST_RUNS}, fit.law)
    if max(runs.values(), default=0) < _LEAST_RUNS:
        result.refusal = f"no sensor has readings between noise and limit at {_LEAST_RUNS} places"
        return result
    problem = _Problem(kept, runs, robot, fit.law if fit else None)
    fit = fit and problem.fit()
    if fit is None:
        result.refusal = "readings do not fall with the distance, or the distances hardly differ"
        return result
    result.missed = problem.rms(fit.missed)
    _widen(problem, _EQUAL_WALLS, fit, result)
    for sensor in problem.sensors:
        result.of_sensor[SENSORS[sensor]] = float(np.exp(fit.law[sensor]))
        result.places += runs[sensor]
    result.readings = kept[["sensor", "farther", "level"]]
    why = "readings follow another law" if result.bends else "distances differ too little"
    freedom = len(problem.blocks) - 1.0
    result.gain = within(fit.gain, fit.gain_error, 0.25 * fit.gain, why, freedom, True)
    result.fall = within(fit.fall, fit.fall_error, 0.25 * fit.fall, why, freedom, True)
    return result


def _parts(walls: Array) -> list[tuple[int, int, bool]]:
    """Splits rows into parts at almost the same distance: [begin, end) and whether the part begins a new run.

    A run is one wall that the mouse passes or approaches. It ends where the distance jumps by more than 3 mm, or
    changes after 10 equal rows (the mouse is moved by hand). A part ends where the distance has changed by 1 mm.
    """
    parts: list[tuple[int, int, bool]] = []
    same, before, begun, start, begins = 0, np.nan, 0.0, -1, False
    for row, wall in enumerate(walls.tolist()):
        goes_on = wall == before or (abs(wall - before) <= 3.0 and same < 10)
        same = same + 1 if wall == before else 0
        before = wall
        if start >= 0 and (math.isnan(wall) or not goes_on or abs(wall - begun) > 1.0):
            parts.append((start, row, begins))
            start = -1
        if start < 0 and not math.isnan(wall):
            start, begun, begins = row, wall, not goes_on
    return parts + ([(start, len(walls), begins)] if start >= 0 else [])


def _readings(log: Log, robot: Numbers) -> "Optional[pd.DataFrame]":
    """The mean readings by sensor and part, or None if the log has no distances from walls. Columns: wall, run, sensor,
    farther (mm, distance beyond that in the middle of a cell), level (counts), rows."""
    cell = robot["cell"]
    face = cell / 2.0 - cell / 30.0
    rows: list[tuple[Any, ...]] = []
    for wall, (role, sensors) in enumerate(_WALLS.items()):
        if role not in log:
            continue
        run = 0
        for begin, end, begins in _parts(log[role]):
            run += begins
            for sensor in sensors:
                name = "ir_" + SENSORS[sensor]
                if name not in log:
                    continue
                angle = robot["sensors.front_angle" if role == "wall_ahead" else "sensors.side_angle"]
                slant = max(abs(np.sin(angle)), np.cos(angle))
                rows.append((wall, run, sensor, (log[role][begin:end].mean() - face) / slant, log[name][begin:end].mean(), end - begin))
    known = any(role in log for role in _WALLS)
    return pd.DataFrame(rows, columns=["wall", "run", "sensor", "farther", "level", "rows"]) if known else None


def _expected(readings: "pd.DataFrame", law: Optional[Array]) -> Array:
    """The levels that a law predicts, so that weights do not follow noise; without a law, the measured levels."""
    if law is None:
        return readings.level.to_numpy(dtype=float)
    levels: Array = np.exp(law[readings.sensor] - law[_DISTANCE] * readings.farther.to_numpy(dtype=float))
    return levels


def _readable(readings: "pd.DataFrame", robot: Numbers, sensors: set[int], law: Optional[Array]) -> "tuple[pd.DataFrame, dict[int, int]]":
    """The readings well above the noise and below the sensor's limit, and the number of runs of each sensor."""
    level = _expected(readings, law)
    low, high = max(8.0, 5.0 * robot["noise.infrared"]), 0.9 * robot["sensors.infrared_most"]
    keep = (level >= low) & (level <= high) & (readings.level > 0.0) & readings.sensor.isin(sensors)
    kept = readings[keep]
    seen = kept[["wall", "run", "sensor"]].drop_duplicates().sensor.to_numpy(dtype=int)
    return kept, {sensor: int((seen == sensor).sum()) for sensor in np.unique(seen).tolist()}


@dataclass
class _LawFit:
    law: Array
    gain: float
    fall: float
    gain_error: float
    fall_error: float
    missed: Array  # by block: sum of squared errors of ln(reading), predicted without that block


class _Problem:
    def __init__(self, readings: "pd.DataFrame", runs: dict[int, int], robot: Numbers, law: Optional[Array]) -> None:
        self.sensors = sorted(sensor for sensor in runs if runs[sensor] >= _LEAST_RUNS)
        count = min([_MOST_BLOCKS, *(runs[sensor] for sensor in self.sensors)])
        used = readings[readings.sensor.isin(self.sensors)]
        level, usual = _expected(used, law), 0.05  # relative variation of readings between places
        rows = np.zeros((len(used), 7))
        farther = used.farther.to_numpy(dtype=float)
        rows[np.arange(len(used)), used.sensor] = 1.0
        rows[:, _DISTANCE], rows[:, _BEND], rows[:, _OFFSET] = -farther, farther**2, 1.0 / level
        values = np.log(used.level.to_numpy(dtype=float))
        # All readings of a run together have the weight of one exact reading, since they share the same wall.
        shares = readings.groupby(["wall", "run"])["level"].transform("size")[used.index].to_numpy(dtype=float)
        unsure = (robot["noise.infrared"] / level) ** 2 / used.rows.to_numpy(dtype=float)
        weights = usual**2 / (usual**2 + unsure) / shares
        self.weight = float(weights.sum())
        number = readings.groupby("wall")["run"].transform(lambda run: pd.factorize(run)[0])
        of_wall = number.groupby(readings.wall).transform("max") + 1
        blocks = (number * count // of_wall)[used.index].to_numpy()
        plain = rows[:, [*self.sensors, _DISTANCE]]
        weights *= robust_weights(plain, values, usual)
        self.blocks = Blocks(rows, values, blocks, weights)
        self.spread = _EQUAL_SENSORS

    def fit(self, more: Optional[int] = None) -> Optional[_LawFit]:
        """Fits the law, with `more` as another unknown. None if it is undetermined, or readings grow with distance."""
        fixed = {i: 0.0 for i in range(7) if i not in (*self.sensors, _DISTANCE, more)}
        solved = self.blocks.solve(fixed)
        if solved is None or solved[0][_DISTANCE] <= 0.0 or (solved[1][:, _DISTANCE] <= 0.0).any():
            return None
        law, others = solved
        # Weights of a random-effects mean: each sensor's variance plus the variance between sensors.
        weights = 1.0 / (jackknife(others[:, self.sensors]) ** 2 + self.spread**2)
        weights /= weights.sum()
        gain = float(np.exp(law[self.sensors]) @ weights)
        gain_error = np.hypot(jackknife(np.exp(others[:, self.sensors]) @ weights), gain * self.spread * np.sqrt((weights**2).sum()))
        fall_error = jackknife(1.0 / others[:, _DISTANCE])
        return _LawFit(law, gain, float(1.0 / law[_DISTANCE]), float(gain_error), float(fall_error), self.blocks.squares(others))

    def rms(self, squares: Array) -> float:
        """The relative rms error of readings, from sums of squares."""
        return float(np.sqrt(squares.sum() / self.weight))


def _widen(problem: _Problem, usual: float, fit: _LawFit, result: InfraredFit) -> None:
    """Increases the errors by the changes under other laws, if they fit better.

    If even the best law has large residuals, the errors also grow by these.
    """
    left = problem.rms(fit.missed)
    for more in (_BEND, _OFFSET):
        other = problem.fit(more)
        if other is None or not fits_better(other.missed, fit.missed):
            continue
        result.bends = True
        left = min(left, problem.rms(other.missed))
        fit.gain_error = float(np.hypot(fit.gain_error, other.gain - fit.gain))
        fit.fall_error = float(np.hypot(fit.fall_error, other.fall - fit.fall))
    if left > 3.0 * usual:
        result.bends = True
        fit.gain_error = float(np.hypot(fit.gain_error, left * fit.gain))
        fit.fall_error = float(np.hypot(fit.fall_error, left * fit.fall))
