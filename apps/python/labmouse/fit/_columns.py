"""The roles of the columns of a log, and the parser of `--columns`."""

import difflib
import math
from dataclasses import dataclass
from typing import Optional

from .. import Error


@dataclass(frozen=True)
class Role:
    """A quantity that a column can have. Values must be `low` to `high`, in `unit`; `gaps`: fields may be empty."""

    unit: str
    low: float
    high: float
    hint: str = ""
    gaps: bool = False


_DUTY = "a duty is a share of what the battery can give: write left=NAME/255, say"
_MOST_DUTY = 4.0  # duties beyond 1 are limited to 1; larger ones have another unit
_MILLIVOLTS = "if it is in mV, write {}=NAME/1000"
_YAW = "if it is in degrees/s, write {}=NAME*0.0174533"

#: The table of docs/how-to/robot-from-a-log.md.
ROLES = {
    "time": Role("ms", -1e12, 1e12),
    "left": Role("", -_MOST_DUTY, _MOST_DUTY, _DUTY),
    "right": Role("", -_MOST_DUTY, _MOST_DUTY, _DUTY),
    "duty": Role("", -_MOST_DUTY, _MOST_DUTY, "a duty is a share of what the battery can give: write duty=NAME/255, say"),
    "forward_volts": Role("V", -100.0, 100.0, _MILLIVOLTS.format("forward_volts")),
    "rotation_volts": Role("V", -100.0, 100.0, _MILLIVOLTS.format("rotation_volts")),
    "left_count": Role("counts", -1e12, 1e12),
    "right_count": Role("counts", -1e12, 1e12),
    "left_speed": Role("mm/s", -20_000.0, 20_000.0),
    "right_speed": Role("mm/s", -20_000.0, 20_000.0),
    "left_travel": Role("mm", -1e7, 1e7),
    "right_travel": Role("mm", -1e7, 1e7),
    "travel": Role("mm", -1e7, 1e7),
    "forward_speed": Role("mm/s", -20_000.0, 20_000.0),
    "heading": Role("degrees", -1e7, 1e7),
    "rotation_speed": Role("rad/s", -100.0, 100.0, _YAW.format("rotation_speed")),
    "gyro": Role("rad/s", -100.0, 100.0, _YAW.format("gyro")),
    "volts": Role("V", 0.1, 100.0, _MILLIVOLTS.format("volts")),
    **{name: Role("counts", -1e6, 1e6) for name in ("ir_right", "ir_right_ahead", "ir_left", "ir_left_ahead")},
    **{
        name: Role("mm", 0.0, 5000.0, f"if it is in m, write {name}=NAME*1000", gaps=True)
        for name in ("wall_right", "wall_left", "wall_ahead")
    },
    "way": Role("mm", -1e7, 1e7, gaps=True),
    "speed": Role("mm/s", -20_000.0, 20_000.0),
    "turning": Role("rad/s", -100.0, 100.0, _YAW.format("turning")),
}

#: Roles that go together, and roles of which a log has one.
_PAIRS = (
    *((f"left{what}", f"right{what}") for what in ("", "_count", "_travel", "_speed")),
    ("forward_volts", "rotation_volts"),
    ("speed", "turning"),
)
_SAME = (
    ("left", "duty", "forward_volts"),
    ("left_count", "left_travel", "left_speed", "travel", "forward_speed"),
    ("gyro", "heading", "rotation_speed"),
)


@dataclass(frozen=True)
class Column:
    """The column of a role.

    name: as in the first line of the log, "#3" for the third column, or an expression of such names (_expressions.py).
    factor: converts its values to the unit of the role. wraps: the number of counts after which the counter wraps around; 0 if it does not.
    """

    name: str
    factor: float = 1.0
    wraps: float = 0.0


def read_columns(text: str, period: float = 0.0) -> dict[str, Column]:
    """Parses a text such as "time=ms,left=pwm_l/255,gyro*0.001,left_count=enc%65536" into columns by their roles.

    period: ms from row to row if no column has the time; 0 otherwise. Raises Error.
    """
    columns: dict[str, Column] = {}
    for part in filter(None, (part.strip() for part in text.split(","))):
        role, column = _read_column(part)
        if role in columns:
            raise Error(f"--columns: '{role}' is there twice; name it once")
        columns[role] = column
    for one, other in _PAIRS:
        if (one in columns) != (other in columns):
            raise Error(f"--columns: '{one}' and '{other}' go together; name both or neither")
    for same in _SAME:
        given = [role for role in same if role in columns]
        if len(given) > 1:
            raise Error(f"--columns: '{given[0]}' and '{given[1]}' say the same; name one of them")
    if ("time" in columns) == (period > 0.0):
        raise Error(
            "--columns: the time is a column and has a period; give one of them"
            if period > 0.0
            else "--columns: no column has the time; name one, as in time=NAME, or give --period MS"
        )
    return columns


def _read_column(part: str) -> tuple[str, Column]:
    text, wraps = _cut_number(part, "%")
    if wraps is not None and not 2.0 <= wraps <= 1e12:
        raise Error(f"--columns: '{part}': a counter wraps at a number from 2 on, such as 65536")
    text, factor = _cut_factor(text)
    if not 1e-12 <= abs(factor) <= 1e12:
        raise Error(f"--columns: '{part}': the factor must be from 1e-12 to 1e12")
    role, equals, name = (word.strip() for word in text.partition("="))
    name = name if equals else role
    if role not in ROLES:
        near = difflib.get_close_matches(role, ROLES, 1)
        raise Error(f"--columns: no column can be '{role}'; " + (f"did you mean '{near[0]}'?" if near else f"they are {', '.join(ROLES)}"))
    if not name:
        raise Error(f"--columns: '{role}' has no column; write {role}=NAME")
    if wraps and not role.endswith("_count"):
        raise Error(f"--columns: '{role}' is no counter, so it does not wrap; take the % out")
    return role, Column(name, factor, wraps or 0.0)


def _cut_factor(text: str) -> tuple[str, float]:
    """Cuts a factor or a divisor from a plain name; from expressions, which are read with the names of the log, nothing."""
    name, factor = _cut_number(text, "*")
    if factor is None:
        name, divisor = _cut_number(text, "/")
        factor = 1.0 if divisor is None else 1.0 / divisor if divisor else math.inf
    return (text, 1.0) if any(sign in name for sign in "+-*/()") else (name, factor)


def _cut_number(text: str, sign: str) -> tuple[str, Optional[float]]:
    before, found, number = text.rpartition(sign)
    try:
        return (before, float(number)) if found else (text, None)
    except ValueError:
        return text, None
