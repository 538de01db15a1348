"""Plots of fits and comparisons by matplotlib."""

import os
from importlib import import_module
from typing import Any, Union

import numpy as np

from .. import Error
from ._comparison import Comparison
from ._infrared import SENSORS
from ._log_fit import LogFit
from ._motion import TICK, rates
from ._motors import MotorFit
from ._turns import TurnFit


def _figure(panels: int) -> tuple[Any, Any]:
    try:
        figures: Any = import_module("matplotlib.figure")
    except ImportError as error:
        raise Error("plots need matplotlib: run pip install -v '.[fit]' in the source folder of labmouse") from error
    figure = figures.Figure(figsize=(9.0, 2.6 * panels), layout="constrained")
    return figure, figure.subplots(panels, 1, squeeze=False)[:, 0]


def save_plot(subject: Union[LogFit, TurnFit, Comparison], path: "Union[str, os.PathLike[str]]") -> None:
    """Saves the plot of a fit or a comparison in the format of the path's ending (.svg, .png, .pdf). Raises Error."""
    figure = plot(subject)
    try:
        figure.savefig(os.fspath(path), metadata={"Date": None} if os.fspath(path).endswith(".svg") else None)
    except (OSError, ValueError) as error:
        raise Error(f"{os.fspath(path)}: error: {error}") from error


def plot(subject: Union[LogFit, TurnFit, Comparison]) -> Any:
    """The matplotlib.figure.Figure of a fit or a comparison. Raises Error if matplotlib is missing."""
    if isinstance(subject, Comparison):
        return _of_comparison(subject)
    return _of_turns(subject) if isinstance(subject, TurnFit) else _of_log(subject)


def _of_log(fit: LogFit) -> Any:
    """Speed and yaw rate of the log and of the fitted motors under its duties, and infrared readings with their law."""
    figure, axes = _figure(3)
    motion, seconds = fit.motion, np.arange(fit.motion.ticks) * TICK
    for axis, name, motor, places in ((axes[0], "speed, mm/s", fit.drive, motion.way), (axes[1], "yaw speed, rad/s", fit.turn, motion.angle)):
        axis.set(xlabel="s", ylabel=name)
        if places is not None:
            axis.plot(seconds, rates(places), label=fit.log.name, linewidth=1.0)
        if motor.gain.known and motion.left is not None and motion.right is not None:
            onwards, around = (motion.left + motion.right) / 2.0, motion.right - motion.left
            duty = (onwards if motor is fit.drive else around) + motor.mixed.value * (around if motor is fit.drive else onwards)
            if motor.taking.known and motion.angle is not None:
                duty = duty - motor.taking.value * np.abs(rates(motion.angle, 16)) * np.sign(duty)
            axis.plot(seconds, _driven(motor, duty), label="fitted motors", linewidth=1.0)
        axis.set_title(motor.refusal or f"gain {motor.gain.value:.4g} ± {motor.gain.error:.2g}, missed {motor.missed:.2g}", fontsize="small")
        if axis.lines:
            axis.legend(fontsize="small")
    _infrared_panel(axes[2], fit)
    return figure


def _driven(motor: MotorFit, duty: Any) -> Any:
    """The rate by tick of a motor of the first order with a dead zone, from rest."""
    share = -np.expm1(-TICK / motor.time.value)
    rate, course = 0.0, []
    for one in duty:
        course.append(rate)
        free = rate + share * (motor.gain.value * one - rate)
        friction = share * motor.gain.value * motor.dead_zone.value
        rate = float(np.sign(free) * max(0.0, abs(free) - friction))
    return np.array(course)


def _infrared_panel(axis: Any, fit: LogFit) -> None:
    infrared = fit.infrared
    axis.set(xlabel="mm beyond the middle of a cell", ylabel="reading, counts", yscale="log")
    axis.set_title(infrared.refusal or f"fall {infrared.fall.value:.3g} ± {infrared.fall.error:.2g} mm", fontsize="small")
    if infrared.readings is None:
        return
    for sensor, name in enumerate(SENSORS):
        readings = infrared.readings[infrared.readings.sensor == sensor]
        if readings.empty:
            continue
        points = axis.plot(readings.farther, readings.level, ".", markersize=3, label=name.replace("_", " "))
        if infrared.fall.known:
            farther = np.linspace(readings.farther.min(), readings.farther.max(), 50)
            axis.plot(farther, infrared.of_sensor[name] * np.exp(-farther / infrared.fall.value), color=points[0].get_color(), linewidth=1.0)
    axis.legend(fontsize="small")


def _of_turns(fit: TurnFit) -> Any:
    """The relative error of each turn under the fitted limits."""
    figure, (axis,) = _figure(1)
    axis.bar([turn.name for turn in fit.turns], [100.0 * error for error in fit.errors])
    axis.set(ylabel="missed by, %")
    return figure


def _of_comparison(comparison: Comparison) -> Any:
    figure, axes = _figure(len(comparison.curves))
    for axis, (name, curve) in zip(axes, comparison.curves.items()):
        seconds = np.arange(len(curve.log)) * TICK
        axis.plot(seconds, curve.log, label=f"log {comparison.log_name}", linewidth=1.0)
        axis.plot(seconds, curve.robot, label=f"robot {comparison.robot_name}", linewidth=1.0)
        if curve.parts is not None:
            axis.axvline(curve.parts * TICK, color="grey", linewidth=1.0, linestyle=":", label="where they part")
        axis.set(xlabel="s", ylabel=f"{name}, {curve.unit}")
    axes[0].legend(fontsize="small")
    figure.suptitle(f"{comparison.log_name} beside {comparison.robot_name}", fontsize="medium")
    return figure
