"""The motion of a mouse by its log, resampled to ticks of 1 ms."""

from dataclasses import dataclass, field
from typing import Any, Optional

import numpy as np

from .. import Error
from ._estimates import Array
from ._logs import LONGEST_GAP, Log

#: Seconds of a tick.
TICK = 1e-3
#: ms: up to this, rows are as fine as the steps of a controller, which change the duties.
_FINE = 1.5
Numbers = dict[str, Any]


@dataclass
class Motion:
    """The motion by ticks. An array is None if the log does not have the quantity."""

    ticks: int
    left: Optional[Array] = None  #: PWM duty of the left motor, scaled to the voltage of a full battery; constant from row to row
    right: Optional[Array] = None  #: the same of the right one
    #: Both duties; if rows are above 1.5 ms apart and a controller changes the duties between them, interpolated linearly.
    interpolated: Optional[tuple[Array, Array]] = None
    unloaded: Optional[tuple[Array, Array]] = None  #: the same without sag, if the log has no voltages
    steps: bool = False  #: whether the duties are set in steps, not by a controller
    resolution: float = 0.0  #: 0.01 or 0.001 if the duties have so few digits
    way: Optional[Array] = None  #: travel of the middle of the axle in mm, by encoders
    angle: Optional[Array] = None  #: heading in rad, to the left
    by_gyro: bool = False  #: whether the angle is from the gyro; otherwise it is from encoders or the log's own heading
    spans: list[tuple[int, int]] = field(default_factory=list)  #: spans [begin, end) without a gap between rows
    rests: list[tuple[int, int]] = field(default_factory=list)  #: spans [begin, end) without motion, 0.1 s or longer


def motion_of(log: Log, robot: Numbers) -> Motion:
    """Computes the motion of a log.

    robot: parameters by the keys of robot files; uses mm per count, track, full voltage and sag of the battery. Duties
    are constant from row to row, all else is interpolated linearly. The gyro's bias is its mean over all rests. Raises
    Error if a wheel is too fast, or for a robot whose motors coast.
    """
    ticks = np.arange(int((log.times[-1] + 1e-3) / (1e3 * TICK)) + 1)
    rows = np.searchsorted(log.times, ticks + 1e-3, side="right") - 1

    def between(role: str) -> Array:
        return np.asarray(np.interp(ticks, log.times, log[role]), dtype=float)

    motion = Motion(len(ticks), by_gyro="gyro" in log, spans=_spans(log))
    wheels = _wheels(log, between, float(robot["sensors.count"]))
    if wheels is not None:
        motion.way = (wheels[0] + wheels[1]) / 2.0
    elif "travel" in log:
        motion.way = between("travel")
    elif "forward_speed" in log:
        motion.way = _sums(between("forward_speed"))
    duties = _duties(log, robot)
    if duties is not None:
        motion.left, motion.right = (duty[rows] for duty in duties)
        share = _voltage(log, robot, between, motion.left, motion.right)
        motion.left, motion.right = motion.left * share, motion.right * share
        plain = (duties[0][rows], duties[1][rows])
        motion.steps, motion.resolution = _in_steps(duties), _resolution(duties)
        if float(np.median(np.diff(log.times))) > _FINE and not motion.steps:
            plain = (np.interp(ticks, log.times, duties[0]), np.interp(ticks, log.times, duties[1]))
        motion.interpolated = (plain[0] * share, plain[1] * share)
        if "volts" not in log and "forward_volts" not in log and robot["motors.sag"] > 0.0:
            motion.unloaded = plain
    if motion.by_gyro:
        motion.angle = _sums(between("gyro"))
    elif "heading" in log:
        motion.angle = np.radians(between("heading"))
    elif "rotation_speed" in log:
        motion.angle = _sums(between("rotation_speed"))
    elif wheels is not None:
        motion.angle = (wheels[1] - wheels[0]) / (2.0 * robot["body.half_track"])
    motion.rests = _rests(motion, float(robot["sensors.count"]))
    if motion.by_gyro and motion.angle is not None and motion.rests:
        turned = sum(motion.angle[end - 1] - motion.angle[begin] for begin, end in motion.rests)
        motion.angle -= ticks * turned / sum(end - begin - 1 for begin, end in motion.rests)
    return motion


def _spans(log: Log) -> list[tuple[int, int]]:
    ends = np.flatnonzero(np.diff(log.times) > LONGEST_GAP)
    first, last = [0, *(ends + 1).tolist()], [*ends.tolist(), len(log.times) - 1]
    return [(int(np.ceil(log.times[begin] - 1e-3)), int(log.times[end] + 1e-3) + 1) for begin, end in zip(first, last)]


def _duties(log: Log, robot: Numbers) -> "Optional[tuple[Array, Array]]":
    """What the duties of both motors by rows do, limited to what a battery can give; None if the log has none."""
    if "left" in log:
        left, right = log["left"], log["right"]
    elif "duty" in log:
        left = right = log["duty"]
    elif "forward_volts" in log:
        around = log["rotation_volts"]
        left, right = (log["forward_volts"] - around) / robot["motors.volts"], (log["forward_volts"] + around) / robot["motors.volts"]
    else:
        return None
    if robot.get("motors.coast", 0.0) > 0.0:
        raise Error("the fit knows no motors that coast; set motors.coast to 0 in the robot that it begins with")
    dead = robot.get("motors.dead_time", 0.0)

    def effect(duty: Array, strength: float) -> Array:
        return np.asarray((np.clip(duty, -1.0, 1.0) - np.clip(duty, -dead, dead)) * strength)

    return effect(left, robot.get("motors.left", 1.0)), effect(right, robot.get("motors.right", 1.0))


def _in_steps(duties: tuple[Array, Array]) -> bool:
    """Whether the duties are set in steps, not by a controller: while they are not 0, most rows repeat the duties before."""
    same = (np.diff(duties[0]) == 0.0) & (np.diff(duties[1]) == 0.0)
    driven = (duties[0][1:] != 0.0) | (duties[1][1:] != 0.0)
    return bool(same[driven].mean() > 0.5) if driven.any() else True


def _resolution(duties: tuple[Array, Array]) -> float:
    for step in (0.01, 0.001):
        if all(np.abs(duty / step - np.round(duty / step)).max() < 1e-6 for duty in duties):
            return step
    return 0.0


def saturated(log: Log, robot: Numbers) -> int:
    """The number of rows in which a duty or a voltage is beyond what the battery can give."""
    rows = np.zeros(len(log.times), dtype=bool)
    for role in ("left", "right", "duty"):
        if role in log:
            rows |= np.abs(log[role]) > 1.0
    if "forward_volts" in log:
        rows |= np.abs(log["forward_volts"]) + np.abs(log["rotation_volts"]) > robot["motors.volts"]
    return int(rows.sum())


def _voltage(log: Log, robot: Numbers, between: Any, left: Array, right: Array) -> Any:
    """The voltage under these duties, as a share of that of a full battery."""
    if "forward_volts" in log:  # duties are voltages already
        return 1.0
    if "volts" not in log:
        return 1.0 - robot["motors.sag"] * (np.abs(left) + np.abs(right)) / 2.0
    volts = between("volts")  # the voltage under a tick's duties is measured one tick later
    return np.append(volts[1:], volts[-1]) / robot["motors.volts"]


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
    elif "left_travel" in log:
        wheels = (between("left_travel"), between("right_travel"))
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
    rows = np.zeros(motion.ticks, dtype=bool)
    for begin, end in motion.spans or [(0, motion.ticks)]:
        rows[begin:end] = True
    still = rows[about:-about].copy()
    if motion.left is not None and motion.right is not None:
        still &= (np.abs(motion.left) + np.abs(motion.right))[about:-about] <= 0.01
    for places, most in ((motion.way, max(0.15, 2.0 * count)), (motion.angle, 0.01)):
        if places is not None:
            still &= np.abs(places[2 * about :] - places[: -2 * about]) <= most
    edges = np.flatnonzero(np.diff(still.astype(int), prepend=0, append=0)) + about
    return [(int(begin), int(end)) for begin, end in zip(edges[::2], edges[1::2]) if end - begin >= shortest]
