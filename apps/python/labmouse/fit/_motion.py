"""The motion of a mouse by its log, resampled to ticks of 1 ms."""

from dataclasses import dataclass, field
from typing import Any, Optional

import numpy as np

from .. import Error
from ._estimates import Array
from ._logs import Log

#: Seconds of a tick.
TICK = 1e-3
Numbers = dict[str, Any]


@dataclass
class Motion:
    """The motion by ticks. An array is None if the log does not have the quantity."""

    ticks: int
    left: Optional[Array] = None  #: PWM duty of the left motor, scaled to the voltage of a full battery
    right: Optional[Array] = None  #: the same of the right one
    way: Optional[Array] = None  #: travel of the middle of the axle in mm, by encoders
    angle: Optional[Array] = None  #: heading in rad, to the left
    by_gyro: bool = False  #: whether the angle is from the gyro; otherwise it is from encoders
    rests: list[tuple[int, int]] = field(default_factory=list)  #: spans [begin, end) without motion, 0.1 s or longer


def motion_of(log: Log, robot: Numbers) -> Motion:
    """Computes the motion of a log.

    robot: parameters by the keys of robot files; uses mm per count, track, full voltage and sag of the battery. Duties
    are constant from row to row, all else is interpolated linearly. The gyro's bias is its mean over all rests. Raises
    Error if a wheel is too fast.
    """
    ticks = np.arange(int((log.times[-1] + 1e-3) / (1e3 * TICK)) + 1)
    rows = np.searchsorted(log.times, ticks + 1e-3, side="right") - 1

    def between(role: str) -> Array:
        return np.asarray(np.interp(ticks, log.times, log[role]), dtype=float)

    motion = Motion(len(ticks), by_gyro="gyro" in log)
    wheels = _wheels(log, between, float(robot["sensors.count"]))
    if wheels is not None:
        motion.way = (wheels[0] + wheels[1]) / 2.0
    if "left" in log:
        left, right = log["left"][rows], log["right"][rows]
        if "volts" in log:  # the voltage under a tick's duties is measured one tick later
            volts = between("volts")
            share = np.append(volts[1:], volts[-1]) / robot["motors.volts"]
        else:
            share = 1.0 - robot["motors.sag"] * (np.abs(left) + np.abs(right)) / 2.0
        motion.left, motion.right = left * share, right * share
    if motion.by_gyro:
        motion.angle = _sums(between("gyro"))
    elif wheels is not None:
        motion.angle = (wheels[1] - wheels[0]) / (2.0 * robot["body.half_track"])
    motion.rests = _rests(motion, float(robot["sensors.count"]))
    if motion.by_gyro and motion.angle is not None and motion.rests:
        turned = sum(motion.angle[end - 1] - motion.angle[begin] for begin, end in motion.rests)
        motion.angle -= ticks * turned / sum(end - begin - 1 for begin, end in motion.rests)
    return motion


def rates(places: Array, about: int = 10) -> Array:
    """The derivative per second, shape (ticks,): central differences over `about` ticks to each side."""
    ticks = np.arange(len(places))
    start, end = np.maximum(ticks - about, 0), np.minimum(ticks + about, len(places) - 1)
    changes: Array = (places[end] - places[start]) / (np.maximum(end - start, 1) * TICK)
    return changes


def _sums(speeds: Array) -> Array:
    return np.concatenate([[0.0], np.cumsum(speeds[1:] * TICK)])


def _wheels(log: Log, between: Any, count: float) -> "Optional[tuple[Array, Array]]":
    if "left_count" in log:
        wheels = (between("left_count") * count, between("right_count") * count)
    elif "left_speed" in log:
        wheels = (_sums(between("left_speed")), _sums(between("right_speed")))
    else:
        return None
    for wheel, name in zip(wheels, ("left", "right")):
        steps = np.diff(wheel)
        for tick in np.flatnonzero(np.abs(steps) > 30_000.0 * TICK)[:1]:
            raise Error(
                f"{log.name}: error: the {name} wheel goes {steps[tick]:.0f} mm in a millisecond at {tick + 1} ms; does its counter wrap? "
                f"then say where, as in {name}_count=NAME%65536; otherwise the robot's sensors.count is not that of this mouse"
            )
    return wheels


def _rests(motion: Motion, count: float) -> list[tuple[int, int]]:
    """Spans [begin, end) in ticks in which neither wheels nor body move and no motor is driven."""
    about, shortest = 25, 100
    if motion.ticks <= 2 * about or (motion.way is None and motion.left is None):
        return []
    still = np.ones(motion.ticks - 2 * about, dtype=bool)
    if motion.left is not None and motion.right is not None:
        still &= (np.abs(motion.left) + np.abs(motion.right))[about:-about] <= 0.01
    for places, most in ((motion.way, max(0.15, 2.0 * count)), (motion.angle, 0.01)):
        if places is not None:
            still &= np.abs(places[2 * about :] - places[: -2 * about]) <= most
    edges = np.flatnonzero(np.diff(still.astype(int), prepend=0, append=0)) + about
    return [(int(begin), int(end)) for begin, end in zip(edges[::2], edges[1::2]) if end - begin >= shortest]
