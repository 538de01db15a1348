"""Constants of firmware as numbers of robot files: those of mazerunner-core of UKMARS (config-robot-*.h)."""

import math
from typing import Mapping, Union

from .. import _native
from ._motion import Numbers

Number = Union[int, float]

_DEGREE = math.pi / 180.0
#: For each constant the key of robot files, and the factor to its unit.
_KEYS: "dict[str, tuple[str, float]]" = {
    "FULL_CELL": ("cell", 1.0),
    "FAST_RUN_SPEED_MAX": ("straight.speed", 1.0),
    "FAST_RUN_ACCELERATION": ("straight.acceleration", 1.0),
    "SEARCH_ACCELERATION": ("straight.acceleration", 1.0),
    "SEARCH_SPEED": ("search.speed", 1.0),
    "SEARCH_TURN_SPEED": ("search.turn_speed", 1.0),
    "OMEGA_SPIN_TURN": ("search.pivot_speed", _DEGREE),
    "ALPHA_SPIN_TURN": ("search.pivot_acceleration", _DEGREE),
    "MOUSE_RADIUS": ("body.half_track", 1.0),
    "FWD_TM": ("motors.drive_time", 1e3),
    "ROT_TM": ("motors.turn_time", 1e3),
    "MM_PER_COUNT": ("sensors.count", 1.0),
    "MM_PER_COUNT_LEFT": ("sensors.count", 1.0),
    "MM_PER_COUNT_RIGHT": ("sensors.count", 1.0),
}
#: The same of constants for a volt: a robot's gains are for full duty. Full duty on both motors is a difference of 2 in a rotation.
_KEYS_FOR_A_VOLT = {"FWD_KM": ("motors.drive_gain", 1.0), "ROT_KM": ("motors.turn_gain", _DEGREE / 2.0)}
_VOLTS = "motors.volts"


def constants_of(constants: "Mapping[str, Number]", robot: Numbers) -> "tuple[Numbers, dict[str, str], list[str]]":
    """The parameters of a robot that constants give, a remark on each, and lines on all that were not used.

    robot: the parameters of the base, by the keys of robot files; its battery's voltage turns gains for a volt into gains.
    """
    numbers: Numbers = {}
    remarks: "dict[str, str]" = {}
    notes, unknown = [], []
    ranges = _native.robot_ranges()
    # The acceleration of a search counts where there is no other one.
    for name in sorted(constants, key=lambda each: each == "SEARCH_ACCELERATION"):
        value = constants[name]
        key, factor = _KEYS.get(name) or _KEYS_FOR_A_VOLT.get(name) or ("", 0.0)
        if not key:
            unknown.append(f"{name} = {value:g}")
            continue
        if key.split(".")[0] in ("body", "motors", "sensors") and key not in robot:
            notes.append(f"{name} = {value:g}: not used; the base does not say what it is built of")
            continue
        volts = float(robot[_VOLTS]) if name in _KEYS_FOR_A_VOLT else 1.0
        number, remark = float(f"{value * factor * volts:.6g}"), name + (f", at {volts:g} V" if name in _KEYS_FOR_A_VOLT else "")
        low, high = ranges[key]
        if not low <= number <= high:
            notes.append(f"{name} = {value:g}: not used; {key} would be {number:g}, and must be {low:g} to {high:g}")
        elif key == "sensors.count" and key in numbers:
            numbers[key] = (float(numbers[key]) + number) / 2.0
            remarks[key] = "mean of MM_PER_COUNT_LEFT and MM_PER_COUNT_RIGHT"
        elif key in numbers:
            notes.append(f"{name} = {value:g}: not used; {remarks[key]} gives {key}")
        else:
            numbers[key], remarks[key] = number, remark
    if "straight.acceleration" in numbers:
        numbers["straight.braking"], remarks["straight.braking"] = numbers["straight.acceleration"], remarks["straight.acceleration"]
    return numbers, remarks, notes + _lines_of(unknown)


def _lines_of(unknown: "list[str]") -> "list[str]":
    """Constants without a place in robot files, several in a line."""
    lines: "list[str]" = []
    for each in unknown:
        if lines and len(lines[-1]) + len(each) < 110:
            lines[-1] += f", {each}"
        else:
            lines.append(f"not used, as robot files have no such number: {each}" if not lines else each)
    return lines
