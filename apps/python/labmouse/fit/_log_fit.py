"""Fits all parameters that a log determines, and pools the fits of several logs."""

import dataclasses
import math
from dataclasses import dataclass, field
from typing import Any, Optional, Sequence

import numpy as np

from ._counts import CountFit, fit_count
from ._estimates import Estimate
from ._gyro import GyroFit, fit_gyro
from ._infrared import InfraredFit, fit_infrared
from ._logs import Log
from ._motion import Motion, Numbers, motion_of, rates, saturated
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
    axes: dict[str, Axis] = field(default_factory=dict)  #: the data of the motors by "drive" and "turn", to fit several logs
    scales: dict[str, float] = field(default_factory=dict)  #: relative standard error of the rates of each axis
    saturated: int = 0  #: number of rows with a duty beyond what the battery can give

    def numbers(self) -> dict[str, Estimate]:
        """The estimates by the keys of robot files, in their units; times in ms. Unsure ones are among them."""
        numbers = {"sensors.count": self.count.count, "noise.gyro": self.gyro.noise}
        numbers |= _motor_numbers("drive", self.drive) | _motor_numbers("turn", self.turn)
        numbers |= {
            "sensors.infrared_gain": self.infrared.gain,
            "sensors.infrared_fall": self.infrared.fall,
        }
        return {key: number for key, number in numbers.items() if number.known}


def _motor_numbers(axis: str, fit: MotorFit) -> dict[str, Estimate]:
    numbers = {f"motors.{axis}_gain": fit.gain, f"motors.{axis}_time": fit.time.scaled(1e3), f"motors.{axis}_dead_zone": fit.dead_zone}
    return numbers | ({"motors.turning": fit.taking} if axis == "drive" else {})


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
    fit.saturated = saturated(log, robot)
    counted_scale = count.count.error / count.count.value if count.count.known else robot["variation.encoder_scale"] / math.sqrt(2.0)  # mean of two wheels
    fit.scales = {"drive": counted_scale, "turn": robot.get("variation.gyro_scale", counted_scale) if fit.motion.by_gyro else counted_scale}
    _add_axes(fit, robot)
    _fit_motors(fit)
    return fit


def _add_axes(fit: LogFit, robot: Numbers) -> None:
    motion, log = fit.motion, fit.log
    if motion.interpolated is None:
        fit.drive.refusal = fit.turn.refusal = "the log has no duties"
        return
    left, right = motion.interpolated
    onwards, around = (left + right) / 2.0, right - left
    unloaded: dict[str, Any] = {"drive": None, "turn": None}
    if motion.unloaded is not None:
        straight, turned = (motion.unloaded[0] + motion.unloaded[1]) / 2.0, motion.unloaded[1] - motion.unloaded[0]
        unloaded = {"drive": (straight, turned), "turn": (turned, straight)}
    base = {
        axis: {
            "gain": robot[f"motors.{axis}_gain"],
            "time": robot[f"motors.{axis}_time"] / 1e3,
            "dead_zone": robot[f"motors.{axis}_dead_zone"],
            "times": log.times,
            "spans": motion.spans,
            "steps": motion.steps,
            "resolution": motion.resolution,
            "unloaded": unloaded[axis],
        }
        for axis in ("drive", "turn")
    }
    about = round(max(10.0, 2.5 * float(np.median(np.diff(log.times)))))
    if motion.way is None:
        fit.drive.refusal = "the log has no encoders"
    else:
        speed, taken = rates(motion.way, about), None
        if motion.angle is not None:
            # Averaged over about one period of the body's vibration, so that vibration does not count as turning.
            taken = np.clip(speed, -1.0, 1.0) * np.abs(rates(motion.angle, max(16, about)))
        fit.axes["drive"] = Axis(
            motion.way,
            speed,
            onwards,
            around,
            taken=taken,
            factor=robot["motors.turning"],
            **base["drive"],
        )
    if motion.angle is None:
        fit.turn.refusal = "the log has neither gyro nor encoders of both wheels"
    else:
        fit.axes["turn"] = Axis(
            motion.angle,
            rates(motion.angle, about),
            around,
            onwards,
            **base["turn"],
        )


def _fit_motors(fit: LogFit) -> None:
    for name, axis in fit.axes.items():
        setattr(fit, name, _scaled(fit_motors(axis), fit.scales[name]))


def _scaled(motor: MotorFit, scale: float) -> MotorFit:
    """With the errors of the scale of encoders or gyro."""
    motor.gain = motor.gain.with_error(scale * motor.gain.value)
    motor.taking = motor.taking.with_error(0.02 * motor.taking.value)  # vibration limits the turning rate to this accuracy
    return motor


def together(fits: Sequence[LogFit], axis: str) -> Optional[MotorFit]:
    """The fit of an axis ("drive" or "turn") to all logs together. None if each log determines the motors by itself, so
    that `pooled` can compare them, or if only one log has that axis."""
    some = [fit for fit in fits if axis in fit.axes]
    motors: list[MotorFit] = [getattr(fit, axis) for fit in some]
    if len(some) < 2 or all(motor.gain.sure and motor.time.sure for motor in motors):
        return None
    return _scaled(fit_motors([fit.axes[axis] for fit in some]), max(fit.scales[axis] for fit in some))


def pooled(fits: Sequence[LogFit]) -> dict[str, Estimate]:
    """Pools the fits of several logs of one mouse; the keys are those of robot files.

    Motors that some log does not determine by itself are fitted to all logs together (`together`). Otherwise, means are
    weighted by inverse variances, and unsure estimates are left out if there are others. If logs differ by more than their errors, the error grows by the Birge
    ratio (Birge 1932), so that it includes the variation between logs.
    """
    by_key: dict[str, list[Estimate]] = {}
    for fit in fits:
        for key, number in fit.numbers().items():
            by_key.setdefault(key, []).append(number)
    numbers = {key: _pool([one for one in some if one.sure] or some[:1]) for key, some in by_key.items()}
    for axis in ("drive", "turn"):
        motor = together(fits, axis)
        if motor is not None and motor.gain.known:
            numbers |= {key: number for key, number in _motor_numbers(axis, motor).items() if number.known}
    return numbers


def _pool(numbers: list[Estimate]) -> Estimate:
    if len(numbers) == 1:
        return dataclasses.replace(numbers[0])
    values, errors = np.array([[one.value, one.error] for one in numbers]).T
    weights: Any = errors**-2.0
    mean = float((weights * values).sum() / weights.sum())
    ratio = math.sqrt(float((weights * (values - mean) ** 2).sum()) / (len(numbers) - 1))
    error = float(weights.sum()) ** -0.5 * max(1.0, ratio)
    return dataclasses.replace(numbers[0], value=mean, error=error, freedom=min(one.freedom for one in numbers) + len(numbers) - 1.0)
