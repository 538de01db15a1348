"""Compares a log with a simulated robot on the same drive: their differences, and where they begin to diverge."""

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Optional, Union

import numpy as np

from .. import Error, _native
from ._estimates import Array
from ._log_fit import fit_log
from ._logs import Log
from ._motion import TICK, Motion, motion_of, rates
from ._robots import base_numbers

if TYPE_CHECKING:
    import pandas as pd

#: Curves diverge where their mean difference over 50 ms exceeds this share of the log's peak.
PARTING_SHARE = 0.05


@dataclass
class Curve:
    """One quantity of the log and of the robot, by ticks (1 ms)."""

    unit: str
    log: Array
    robot: Array
    parts: Optional[int] = None  #: the tick at which they diverge; None if they do not


@dataclass
class Comparison:
    """The result of compare_log."""

    log_name: str
    robot_name: str
    curves: dict[str, Curve]  #: "speed" (mm/s), "yaw" (rad/s), "way" (mm), "turn" (degrees to the left), as the log has them
    by_duties: bool  #: whether the robot got the log's duties; otherwise its controller followed speeds
    stronger: float  #: share by which its right motor was made stronger than the left one

    def table(self) -> "pd.DataFrame":
        """One row per curve: peak of the log, rms, largest and last difference, and the time of divergence in s."""
        import pandas as pd

        rows = {}
        for name, curve in self.curves.items():
            off, peak = curve.robot - curve.log, float(np.abs(curve.log).max())
            rms = float(np.sqrt((off**2).mean()))
            rows[f"{name} {curve.unit}"] = {
                "peak": peak,
                "rms off": rms,
                "% of it": 100.0 * rms / peak if peak else 0.0,
                "most off": float(np.abs(off).max()),
                "at the end": float(off[-1]),
                "parts at s": np.nan if curve.parts is None else curve.parts * TICK,
            }
        return pd.DataFrame.from_dict(rows, orient="index")

    def __str__(self) -> str:
        how = "got the same duties" if self.by_duties else "was driven after the same speeds"
        ticks = max(len(curve.log) for curve in self.curves.values())
        text = f"{self.log_name} beside {self.robot_name}, which {how}; {ticks * TICK:.4g} s\n"
        if self.stronger:
            than = "stronger" if self.stronger > 0.0 else "weaker"
            text += f"its right motor was made {100 * abs(self.stronger):.1f} % {than} than the left one, as the log's is\n"
        forms = ["{:.4g}", "{:.3g}", "{:.1f}", "{:.3g}", "{:.3g}", "{:.3f}"]
        table = self.table()
        formats = {column: form.format for column, form in zip(table.columns, forms)}
        return text + table.to_string(formatters=formats, na_rep="-", col_space=8) + "\n" + self._parting()

    def _parting(self) -> str:
        parting = [(curve.parts, name) for name, curve in self.curves.items() if curve.parts is not None]
        if not parting:
            return f"they do not part: nothing differs by {100 * PARTING_SHARE:g} % of its peak"
        tick, first = min(parting, key=lambda one: one[0])
        where = []
        if "way" in self.curves:
            where.append(f"{self.curves['way'].log[tick]:.0f} mm on its way")
        if "turn" in self.curves:
            where.append(f"turned {self.curves['turn'].log[tick]:.0f} degrees")
        return f"they part at {tick * TICK:.3f} s, first in {first}: the log's mouse was then {', '.join(where)}"


def compare_log(log: Log, robot: "Union[str, os.PathLike[str]]") -> Comparison:
    """Drives a robot as in a log, without noise and on an open floor, and compares the two.

    If the log has PWM duties, the robot's motors get these. The motors are made as unequal as those of the log, because
    duties that keep a real mouse straight make a mouse with equal motors turn. Otherwise, the robot's controller
    follows the log's set speeds or, without these, its measured speeds. The log must begin at rest, and the robot must
    have hardware. Raises Error.
    """
    name = os.fspath(robot)
    numbers = base_numbers(robot)
    motion = motion_of(log, numbers)
    _check(log, motion)
    stronger = 0.0
    if motion.left is not None:
        mixed = fit_log(log, numbers).turn.mixed
        stronger = mixed.value if mixed.sure else 0.0
        rows = np.searchsorted(log.times, np.arange(motion.ticks) + 1e-3, side="right") - 1
        ways, angles = _native.drive_duties(name, stronger, log["left"][rows].copy(), log["right"][rows].copy())
    else:
        ways, angles = _follow(log, motion, name)
    curves: dict[str, Curve] = {}
    for place, rate, units, least in (("way", "speed", ("mm", "mm/s"), (3.0, 20.0)), ("turn", "yaw", ("degrees", "rad/s"), (0.04, 0.5))):
        of_log = motion.way if place == "way" else motion.angle
        if of_log is None:
            continue
        of_robot = np.array(ways if place == "way" else angles)
        factor = 1.0 if place == "way" else float(np.degrees(1.0))
        for key, unit, one, other, most, scale in (
            (rate, units[1], rates(of_log, 5), rates(of_robot, 5), least[1], 1.0),
            (place, units[0], of_log - of_log[0], of_robot - of_robot[0], least[0], factor),
        ):
            curves[key] = Curve(unit, scale * one, scale * other, _parting(one, other, most))
    names: tuple[str, ...] = ("speed", "yaw", "way", "turn")
    return Comparison(log.name, name, {key: curves[key] for key in names if key in curves}, motion.left is not None, stronger)


def _follow(log: Log, motion: Motion, robot: str) -> tuple[list[float], list[float]]:
    rows = np.searchsorted(log.times, np.arange(motion.ticks) + 1e-3, side="right") - 1
    if "speed" in log:
        speed, turning = log["speed"][rows], log["turning"][rows]
    else:
        assert motion.way is not None and motion.angle is not None  # _check
        speed, turning = rates(motion.way), rates(motion.angle)
    ways, angles = _native.drive_speeds(robot, speed.copy(), rates(speed, 5), turning.copy(), rates(turning, 5))
    return ways, angles


def _check(log: Log, motion: Motion) -> None:
    places = [(motion.way, 1.0), (motion.angle, 0.05)]
    early = min(20, motion.ticks - 1)
    reason = ""
    if motion.way is None and motion.angle is None:
        reason = "has neither encoders nor gyro, so there is nothing to compare with; name 'left_count' and 'right_count', or 'gyro'"
    elif motion.left is None and "speed" not in log and (motion.way is None or motion.angle is None):
        reason = "has no duties and no speeds to drive after; name 'left' and 'right', or 'speed' and 'turning'"
    elif any(one is not None and abs(one[early] - one[0]) > most for one, most in places):
        reason = "begins while the mouse moves; cut it so that it begins at rest"
    if reason:
        raise Error(f"{log.name}: error: {reason}")


def _parting(log: Array, robot: Array, least: float) -> Optional[int]:
    about = 50  # ticks; their mean removes most vibration
    sums = np.concatenate([[0.0], np.cumsum(robot - log)])
    means = np.abs(sums[about:] - sums[:-about]) / about
    beyond = np.flatnonzero(means > max(least, PARTING_SHARE * float(np.abs(log).max())))
    return int(beyond[0]) + about // 2 if len(beyond) else None
