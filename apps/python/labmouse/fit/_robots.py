"""Makes robot files from fits."""

import json
import math
import os
from dataclasses import dataclass, replace
from typing import Any, Sequence, Union

import numpy as np

from .. import Error, _native
from ._constants import constants_of
from ._estimates import Estimate
from ._headers import Header
from ._infrared import SENSORS
from ._log_fit import LogFit, pooled, together
from ._logs import LONGEST_GAP
from ._missing import missing
from ._motion import Numbers
from ._motors import MotorFit
from ._turn import TURNS, Turn
from ._turns import LIMITS, TurnFit, fit_turns


@dataclass
class FittedRobot:
    """A robot file made from fits."""

    text: str  #: content of the file; each number has a comment with its standard error or its source
    warning: str  #: why the robot may be wrong, or ''
    numbers: dict[str, Estimate]  #: the fitted parameters by the keys of robot files
    fits: "Sequence[Union[LogFit, TurnFit]]" = ()  #: the fits, for plots


def robot_numbers(name: "Union[str, os.PathLike[str]]") -> tuple[str, Numbers]:
    """The name of a robot, and its parameters by the keys of robot files, in their units.

    name: a built-in robot, or a file whose name has a slash or ends in .toml. Raises Error.
    """
    own_name, numbers = _native.robot_numbers(os.fspath(name))
    # Rounding undoes the error of the conversion to internal units and back.
    return own_name, {key: _rounded(value, 12) if isinstance(value, float) else value for key, value in json.loads(numbers).items()}


def robot_of_logs(fits: Sequence[LogFit], base: "Union[str, os.PathLike[str]]") -> FittedRobot:
    """Makes the robot file of one or more logs of a mouse. All other parameters are those of the base.

    Several logs are pooled (`pooled`). The warning names a part that a log has columns for but does not determine.
    Raises Error if the base has no hardware.
    """
    name, robot = robot_numbers(base)
    head, parts = "", []
    for fit in fits:
        lines = _head(fit, robot)
        head += f"# Fitted to {_plain(fit.log.name)}; all else is from {_plain(name)}. Intervals are 95 % intervals.\n"
        head += "".join(f"# {part}: {words}\n" if part else f"# {words}\n" for part, words, _ in lines)
        parts += lines
    numbers, remarks = pooled(fits), {}
    head += _joint(fits)
    ranges = _native.robot_ranges()
    for key, number in numbers.items():
        value, (low, high) = _rounded(number.value), ranges[key]
        found = f"{_interval(number)}" + (f", unsure: {number.unsure}" if number.unsure else "")
        if low <= value <= high and not number.error > max(number.value, _LEAST_ERROR.get(key, 0.0)):
            robot[key] = value
            remarks[key] = f"fitted, {found}"
        else:
            remarks[key] = f"from {_plain(name)}: the log says {value:g}, {found}" + ("" if low <= value <= high else ", which it cannot be")
    head += _per_volt(fits, numbers, robot)
    lacking = missing(fits, numbers)
    head += "".join(f"# missing: {line}\n" for line in lacking)
    warnings = _warnings(parts, numbers)
    text, problem = _native.robot_file(json.dumps(robot), remarks, f"from {_plain(name)}: the log does not determine it")
    if problem and not warnings:
        warnings.append(f"the robot is refused as it stands: {problem}")
    return FittedRobot(f"{head}\n{text}", warnings[0] if warnings else "", numbers, fits)


#: A dead zone near 0 may have an error above its value, in duty; so may the duty that turning takes.
_LEAST_ERROR = {"motors.drive_dead_zone": 0.03, "motors.turn_dead_zone": 0.03, "motors.turning": 0.001}


def _interval(number: Estimate) -> str:
    low, high = number.interval
    return f"95 % {low:.4g} to {high:.4g}"


def _percent(number: Estimate) -> str:
    low, high = sorted(abs(100.0 * end) for end in number.interval)
    return f"95 % {low:.3g} to {high:.3g} %"


def _joint(fits: Sequence[LogFit]) -> str:
    """Lines on the fits to all logs together."""
    head = ""
    for axis, part, unit in (("drive", "driving", "mm/s"), ("turn", "turning", "rad/s")):
        motor = together(fits, axis)
        if motor is not None:
            head += f"# {part}, all logs together: {motor.refusal or _motor_words(motor, unit)}\n"
    return head


def _per_volt(fits: Sequence[LogFit], numbers: dict[str, Estimate], robot: Numbers) -> str:
    """Lines with the gains per volt, if a log has voltages. A turning gain is that of the voltage of each motor."""
    if not any("forward_volts" in fit.log for fit in fits):
        return ""
    volts, degrees = robot["motors.volts"], math.degrees(2.0)
    lines = ""
    for key, what, factor, unit in (
        ("motors.drive_gain", "driving", 1.0 / volts, "mm/s per V"),
        ("motors.turn_gain", "turning", degrees / volts, "degrees/s per V, right motor + and left motor -"),
        ("motors.drive_dead_zone", "dead zone of driving", volts, "V"),
        ("motors.turn_dead_zone", "dead zone of turning", 0.5 * volts, "V, right motor + and left motor -"),
    ):
        if key in numbers:
            number = numbers[key].scaled(factor)
            lines += f"# {what}: {number.value:.4g} {unit}, {_interval(number)}" + (", unsure\n" if number.unsure else "\n")
    return lines


def _warnings(parts: "list[tuple[str, str, bool]]", numbers: dict[str, Estimate]) -> list[str]:
    """Parts that a log has columns for and that no log determines, and motors that are unsure."""
    found = {part for part, _, refused in parts if part and not refused}
    warnings = [f"{part}: {words.replace('nothing fitted, ', '', 1)}" for part, words, refused in parts if refused and part not in found]
    for key, what in (("motors.drive_gain", "driving"), ("motors.turn_gain", "turning")):
        if key in numbers and numbers[key].unsure:
            warnings.append(f"{what}: its gain is unsure ({_interval(numbers[key])}): {numbers[key].unsure}")
    return warnings


def base_numbers(base: "Union[str, os.PathLike[str]]") -> Numbers:
    """The parameters of a base robot for fit_log. Raises Error if it has no hardware."""
    name, robot = robot_numbers(base)
    if "motors.drive_gain" not in robot:
        raise Error(f"'{_plain(name)}' does not say what it is built of; take the rest from a robot that does, such as classic or kerise")
    return robot


def _head(fit: LogFit, robot: Numbers) -> "list[tuple[str, str, bool]]":
    """Lines on the quality of each fit or its refusal: part, words, and whether it is refused in spite of its columns."""
    log = fit.log
    steps = [after - before for before, after in zip(log.times, log.times[1:])]
    gaps = [step for step in steps if step > LONGEST_GAP]
    mean, most = float(np.median(steps)), max(steps)
    missing = f", where some are missing {most:.3g} ms" if most > 1.5 * mean else ""
    if gaps:
        missing = f"; {len(gaps)} gaps of up to {most:.3g} ms separate its parts"
    lines = [("", f"log: {log.times[-1] / 1e3:.3g} s; rows are {mean:.3g} ms apart{missing}", False)]
    if fit.saturated:
        lines.append(("", f"{fit.saturated} rows have duties beyond 1; the battery gives no more, so they count as 1", False))

    def tell(part: str, refusal: str, asked: bool, words: str) -> None:
        lines.append((part, f"nothing fitted, {refusal}" if refusal else words, asked and bool(refusal)))

    duties = fit.motion.left is not None
    known = f"misses places left out by {fit.count.missed:.2g} mm" if fit.count.missed else "as a whole, so that nothing could be left out"
    tell("encoders", fit.count.refusal, "way" in log or fit.count.way > 0.0, f"{fit.count.way:.0f} mm known{';' if fit.count.missed else ''} {known}")
    tell("driving", fit.drive.refusal, duties and fit.motion.way is not None, _motor_words(fit.drive, "mm/s"))
    tell("turning", fit.turn.refusal, duties and fit.motion.angle is not None, _motor_words(fit.turn, "rad/s"))
    mixed = fit.turn.mixed
    if mixed.sure and abs(mixed.value) > 2.0 * mixed.error:
        than = "stronger" if mixed.value > 0.0 else "weaker"
        words = f"the right motor is {100 * abs(mixed.value):.1f} % {than} than the left one ({_percent(mixed)})"
        lines.append(("", f"{words}; a robot's motors are alike", False))
    tell("gyro", fit.gyro.refusal, "gyro" in log, f"{fit.gyro.rest:.2g} s at rest; quarters of it left out differ by {100 * fit.gyro.missed:.1f} %")
    gains = ", ".join(f"{name.replace('_', ' ')} {fit.infrared.of_sensor[name]:.3g}" for name in SENSORS if name in fit.infrared.of_sensor)
    bends = "; readings follow another law: errors contain what that would change" if fit.infrared.bends else ""
    words = f"{fit.infrared.places} places; misses readings at those left out by {100 * fit.infrared.missed:.1f} %; {gains}{bends}"
    tell("infrared", fit.infrared.refusal, any(f"wall_{side}" in log for side in ("right", "left", "ahead")), words)
    return lines


def _motor_words(fit: MotorFit, unit: str) -> str:
    share = 100.0 * fit.missed / fit.peak if fit.peak else 0.0
    words = (
        f"{fit.stretches} stretches of moving; misses the speed on those left out by {fit.missed:.2g} of {fit.peak:.4g} {unit} "
        f"({share:.1f} %), {min(fit.noise, fit.missed):.2g} of it noise"
    )
    if fit.by_input:
        words += "; the dead zone is that of the input, not friction"
    if fit.lag:
        words += f"; a lag of {1e3 * fit.lag:.1f} ms fits better: errors contain what it would change"
    if fit.drag:
        words += "; drag that grows with the speed fits better: errors contain what it would change"
    return words


def cell_of(turns: Sequence[Turn]) -> float:
    """The side of a cell in mm, derived from the turn S90 and its straight; 0 if turns do not have these."""
    return next((2.0 * (turn.y + turn.before) for turn in turns if turn.name == "S90" and turn.y > 0.0 and turn.before), 0.0)


def robot_of_turns(turns: Sequence[Turn], base: "Union[str, os.PathLike[str]]", cell: float = 0.0) -> FittedRobot:
    """Makes the robot file of turns. All other parameters are those of the base.

    cell: side of a cell in mm; 0: from the turn S90 (`cell_of`), or else the base's. Turns with speeds give limits and
    paths; the base must have limits. Turns with times only give a table of times; the base must have such a table.
    Raises Error.
    """
    name, robot = robot_numbers(base)
    robot = {key: value for key, value in robot.items() if not _is_hardware(key)}
    return _robot_of(Header(list(turns)), name, robot, {}, cell)


def robot_of_header(header: Header, base: "Union[str, os.PathLike[str]]", cell: float = 0.0) -> FittedRobot:
    """Makes the robot file of the turns and constants of a C header. All other parameters are those of the base.

    cell: side of a cell in mm; 0: from the header, or else the base's. The text lists what of the header was not used. Raises Error
    as robot_of_turns does, and if the constants are those of a search and the base has the times of one.
    """
    if not header.constants:
        found = robot_of_turns(header.turns, base, cell)
        return replace(found, text=_listed(header.notes) + found.text)
    name, robot = robot_numbers(base)
    numbers, remarks, notes = constants_of(header.constants, robot)
    if "search.cell" in robot and any(key.startswith("search.") for key in numbers):
        raise Error(f"'{name}' gives the times of a search, and the header its speeds; take the rest from a robot with speeds, such as beginner")
    if not any(_is_hardware(key) for key in numbers):
        robot = {key: value for key, value in robot.items() if not _is_hardware(key)}
    robot.update(numbers)
    found = _robot_of(header, name, robot, remarks, cell or numbers.get("cell", 0.0))
    return replace(found, text=_listed([*notes, *header.notes]) + found.text)


def _listed(notes: Sequence[str]) -> str:
    return "".join(f"# {_plain(note)}\n" for note in notes) + ("\n" if notes else "")


def _is_hardware(key: str) -> bool:
    return key.split(".")[0] in ("body", "motors", "sensors", "noise", "variation", "infrared", "ranger")


def _robot_of(header: Header, name: str, robot: Numbers, remarks: dict[str, str], cell: float) -> FittedRobot:
    """A robot with these parameters and the turns of a header; cell 0: from the turn S90, or else the robot's."""
    turns, own_cell = header.turns, robot["cell"]
    cell = cell or cell_of(turns) or own_cell
    speeds, fixed = any(turn.speed > 0.0 for turn in turns), "turns.speed" in robot
    if speeds and fixed:
        raise Error(
            f"'{name}' gives the times of its turns, and the table has speeds; take the rest from a robot with limits, such as "
            "classic or kerise"
        )
    if turns and not speeds and not fixed:
        raise Error(
            f"the table has times without speeds, which tell nothing of limits, and '{name}' has limits; take the rest from a robot with "
            "times of turns, such as mm2021"
        )
    source = f"from {_plain(name)}: {'the header does' if header.constants else 'turns do'} not determine it"
    remarks = {"cell": source if cell == own_cell else "given", **remarks}
    robot = robot | {"cell": cell}
    fit = _add_limits(turns, robot, remarks, cell) if speeds else None
    for turn in turns if fixed else ():
        key = f"turns.{turn.name}"
        if turn.name != "K90" and robot.get(key) is not False:
            robot[key], remarks[key] = round(turn.ms, 3), "given"
    text, problem = _native.robot_file(json.dumps(robot), remarks, source)
    warning = f"the robot is refused as it stands: {problem}" if problem else ""
    if not warning and fit and max(fit.errors) > 0.01:
        warning = f"the limits miss a turn by {100 * max(fit.errors):.1f} %: are all turns of one robot, and the units right?"
    numbers = {} if fit is None else {f"curve.{limit}": Estimate(value) for limit, value in zip(LIMITS, fit.limits)}
    return FittedRobot((f"# {warning}\n" if warning else "") + text, warning, numbers, [fit] if fit else [])


def _add_limits(turns: Sequence[Turn], robot: Numbers, remarks: dict[str, str], cell: float) -> TurnFit:
    fit = fit_turns(turns, cell)
    if not fit.numbers:
        raise Error("no limits follow from these turns; are speeds in mm/s, lengths in mm and times in ms?")
    for key in [key for key in robot if key.startswith("layout.")]:
        del robot[key]
    for limit, value, reached in zip(LIMITS, fit.limits, fit.reached):
        key = f"curve.{limit}"
        robot[key] = _rounded(value)
        if not value:
            del robot[key]
        many = f"one of many answers: {fit.numbers} limits from {fit.figures} figures"
        remarks[key] = "no turn reaches it; it may be anything above" if not reached else many if fit.figures < fit.numbers else "fitted"
    driven = [turn for turn in turns if turn.speed > 0.0]
    for turn, error in zip(turns, fit.errors):
        given = turn.before if turn.name == "180" else turn.speed
        if turn.speed > 0.0 and turn.name != "K90" and given > 0.0:
            robot[f"layout.{turn.name}"] = given
            remarks[f"layout.{turn.name}"] = f"given; the limits miss it by {100 * error:.3f} %"
    limits = [float(robot.get(f"curve.{limit}", 0.0)) for limit in LIMITS]
    kept = [_native.turn_clearance(turn.name, turn.speed, limits, cell) for turn in driven if turn.name not in ("K90", "180")]
    clearance = max(0.0, math.floor(min([cell, *kept]) * 10.0 - 1.0) / 10.0)
    # Turns that the table lacks may pass posts more closely than those that it has.
    if clearance < robot["clearance"] or {turn.name for turn in driven} >= set(TURNS) - {"K90"}:
        robot["clearance"], remarks["clearance"] = clearance, "what the paths below keep"
    small = robot.get("layout.S90", 0.0)
    if "search.speed" in robot and not robot.get("search.turn_speed") and 0.0 < small < robot["search.speed"]:
        robot["search.speed"] = small
        remarks["search.speed"] = "that of S90: as fast as the other robot it could not turn"
    return fit


def _rounded(value: float, digits: int = 5) -> float:
    """A number to so many significant digits. Five are more than a log or published turns determine."""
    return float(f"{value:.{digits}g}")


def _plain(text: Any) -> str:
    return "".join(c if c.isprintable() else "�" for c in os.fspath(text))
