"""Fits all parameters that a log determines, and pools the fits of several logs."""

import dataclasses
import math
from dataclasses import dataclass, field
from typing import Any, Sequence

import numpy as np

from ._counts import CountFit, fit_count
from ._estimates import Estimate
from ._gyro import GyroFit, fit_gyro
from ._infrared import InfraredFit, fit_infrared
from ._logs import Log
from ._motion import Motion, Numbers, motion_of, rates
from ._motors import Axis, MotorFit, fit_motors


@dataclass
class LogFit:
    """The fits of a log. A fit that the log does not determine has a `refusal`. log, motion: the data, for plots."""

    log: Log
    motion: Motion
    count: CountFit = field(default_factory=CountFit)
    drive: MotorFit = field(default_factory=MotorFit)
    turn: MotorFit = field(default_factory=MotorFit)
    gyro: GyroFit = field(default_factory=GyroFit)
    infrared: InfraredFit = field(default_factory=InfraredFit)

    def numbers(self) -> dict[str, Estimate]:
        """The fitted parameters by the keys of robot files, in their units; times in ms."""
        numbers = {"sensors.count": self.count.count, "noise.gyro": self.gyro.noise}
        for axis, fit in (("drive", self.drive), ("turn", self.turn)):
            in_ms = Estimate(1e3 * fit.time.value, 1e3 * fit.time.error)
            numbers |= {f"motors.{axis}_gain": fit.gain, f"motors.{axis}_time": in_ms, f"motors.{axis}_dead_zone": fit.dead_zone}
        numbers |= {
            "motors.turning": self.drive.taking,
            "sensors.infrared_gain": self.infrared.gain,
            "sensors.infrared_fall": self.infrared.fall,
        }
        return {key: number for key, number in numbers.items() if number.known}


def fit_log(log: Log, robot: Numbers, *, way: float = 0.0, way_error: float = 1.0) -> LogFit:
    """Fits encoders, motors, gyro and infrared sensors to a log.

    robot: parameters of the base robot, with hardware (`base_numbers`), for all that the log does not determine.
    way, way_error: measured distance of the whole log in mm, and its standard error; 0 if it was not measured.
    Distances use the fitted mm per count or, if it was not fitted, the base robot's. Errors of the motors include the
    error of mm per count; where a gyro measures turning, that of the gyro's scale instead. Raises Error.
    """
    count = fit_count(log, way, way_error)
    counted = {**robot, **({"sensors.count": count.count.value} if count.count.known else {})}
    fit = LogFit(log, motion_of(log, counted), count)
    fit.gyro = fit_gyro(log, fit.motion)
    fit.infrared = fit_infrared(log, robot)
    scale = count.count.error / count.count.value if count.count.known else robot["noise.encoder_scale"]
    _fit_motors(fit, robot, scale)
    return fit


def _fit_motors(fit: LogFit, robot: Numbers, scale: float) -> None:
    motion = fit.motion
    if motion.left is None or motion.right is None:
        fit.drive.refusal = fit.turn.refusal = "the log has no duties"
        return
    onwards, around = (motion.left + motion.right) / 2.0, motion.right - motion.left
    base = {axis: {"gain": robot[f"motors.{axis}_gain"], "time": robot[f"motors.{axis}_time"] / 1e3} for axis in ("drive", "turn")}
    if motion.way is None:
        fit.drive.refusal = "the log has no encoders"
    else:
        speed, taken = rates(motion.way), None
        if motion.angle is not None:
            # Averaged over about one period of the body's vibration, so that vibration does not count as turning.
            taken = np.clip(speed, -1.0, 1.0) * np.abs(rates(motion.angle, 16))
        fit.drive = fit_motors(Axis(motion.way, speed, onwards, around, 40, taken=taken, factor=robot["motors.turning"], **base["drive"]))
        fit.drive.gain = _less_sure(fit.drive.gain, scale)
        fit.drive.taking = _less_sure(fit.drive.taking, 0.02)  # vibration limits the turning rate to this accuracy
    if motion.angle is None:
        fit.turn.refusal = "the log has neither gyro nor encoders"
    else:
        fit.turn = fit_motors(Axis(motion.angle, rates(motion.angle), around, onwards, 8, **base["turn"]))
        fit.turn.gain = _less_sure(fit.turn.gain, robot["noise.gyro_scale"] if motion.by_gyro else scale)


def _less_sure(number: Estimate, share: float) -> Estimate:
    return Estimate(number.value, math.hypot(number.error, share * number.value)) if number.known else number


def pooled(fits: Sequence[LogFit]) -> dict[str, Estimate]:
    """Pools the fits of several logs of one mouse; the keys are those of robot files.

    Means are weighted by inverse variances. If logs differ by more than their errors, the error grows by the Birge
    ratio (Birge 1932), so that it includes the variation between logs.
    """
    by_key: dict[str, list[Estimate]] = {}
    for fit in fits:
        for key, number in fit.numbers().items():
            by_key.setdefault(key, []).append(number)
    return {key: _pool(numbers) for key, numbers in by_key.items()}


def _pool(numbers: list[Estimate]) -> Estimate:
    if len(numbers) == 1:
        return dataclasses.replace(numbers[0])
    values, errors = np.array([[one.value, one.error] for one in numbers]).T
    weights: Any = errors**-2.0
    mean = float((weights * values).sum() / weights.sum())
    ratio = math.sqrt(float((weights * (values - mean) ** 2).sum()) / (len(numbers) - 1))
    return Estimate(mean, float(weights.sum()) ** -0.5 * max(1.0, ratio))
