"""Reads numbers from C headers of firmware: tables of turns and constants, as in mazerunner-core of UKMARS.

Only numbers are read. Code and conditions (#if) are ignored.
"""

import ast
import math
import operator
import re
from bisect import bisect_left, bisect_right
from dataclasses import dataclass, field
from typing import Callable, Optional, Union

import numpy as np

from .. import Error
from ._turn import Turn

Number = Union[int, float]

#: Names of turns in firmware; L or R may follow. A turn from a diagonal is the one onto it, driven backwards. The names of
#: UKMARS and kerikun11 are assumed from their use in articles and repositories.
TURN_NAMES = {
    **{"SS90E": "S90", "SS90": "90", "SS180": "180", "SD45": "45", "SD135": "135", "DD90": "V90", "DD90K": "K90"},
    **{"DS45": "45", "DS135": "135"},
    **{f"TURN_{name}": name for name in ("45", "90", "135", "180", "V90", "S90")},
    **{"F45": "45", "F90": "90", "F135": "135", "F180": "180", "FV90": "V90", "S90": "S90"},
}
#: What columns of structs are called; those of mazerunner-core come first.
COLUMNS = {
    **{name: name for name in ("speed", "entry_offset", "exit_offset", "angle", "omega", "alpha", "lead_in", "profile")},
    **{"yaw_rate": "omega", "yaw_acceleration": "alpha"},
}
#: The struct of mazerunner-core, for tables whose struct stands in another file.
_USUAL = ("speed", "entry_offset", "exit_offset", "angle", "omega", "alpha", "trigger")
_NEEDED = ("speed", "omega", "alpha")
#: How often constants are read: a #define may use names that are defined below it.
_PASSES = 4
_DEGREE = math.pi / 180.0
_NAME = re.compile(rf"\b({'|'.join(sorted(TURN_NAMES, key=len, reverse=True))})[LR]?\b")
_OPERATORS: "dict[type[ast.operator], Callable[[Number, Number], Number]]" = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul}


@dataclass
class Header:
    """Numbers of a header."""

    turns: "list[Turn]" = field(default_factory=list)
    constants: "dict[str, Number]" = field(default_factory=dict)
    notes: "list[str]" = field(default_factory=list)  #: what was approximated or left out, in lines


def is_header(text: str) -> bool:
    """Whether a text is C rather than a table of columns."""
    return re.search(r"\{|^[ \t]*#[ \t]*define\b|^[ \t]*(static|const|constexpr)\b", text, re.MULTILINE) is not None


def header_of(text: str, name: str) -> Header:
    """The turns and constants of a header. Raises Error with file, line and column of up to ten problems."""
    code = re.sub(r"//[^\n]*|/\*.*?(?:\*/|\Z)", lambda found: re.sub(r"[^\n]", " ", found.group()), text, flags=re.DOTALL)
    header = Header()
    _read_constants(code, header)
    problems = _Rows(text, code, header).read()
    if problems:
        raise Error("\n".join(f"{name}:{place}: error: {reason}" for place, reason in problems[:10]))
    return header


def _read_constants(code: str, header: Header) -> None:
    defined = [(found[1], found[2], False) for found in re.finditer(r"^[ \t]*#[ \t]*define[ \t]+(\w+)[ \t]+(\S[^\n]*)$", code, re.MULTILINE)]
    declared = re.finditer(r"\b(?:const|constexpr)\b([^;={}()\[\]*]{0,100}?)\b(\w+)\s*=\s*([^;{}]{1,400});", code)
    texts = [*defined, *((found[2], found[3], "float" in found[1] or "double" in found[1]) for found in declared)]
    left = [*texts]
    for _ in range(_PASSES):
        unknown = []
        for name, text, floating in left:
            value = _value(text, header.constants)
            if value is None:
                unknown.append((name, text, floating))
            elif name not in header.constants:
                header.constants[name] = float(value) if floating else value
            elif header.constants[name] != value:
                header.notes.append(f"{name} is there twice, as {header.constants[name]:g} and {value:g}: the first one counts")
        left = unknown
    header.notes += [f"{name} is no number: not used" for name, _, _ in left]


def _value(text: str, constants: "dict[str, Number]") -> Optional[Number]:
    """The number of an expression of numbers and known names, as C computes it; None if there is none."""
    if len(text) > 300:
        return None
    plain = re.sub(r"(?<![\w.])((?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)[fFlLuU]*(?![\w.])", r"\1", text.strip())
    try:
        value = _computed(ast.parse(plain, mode="eval").body, {"PI": math.pi, "M_PI": math.pi, **constants})
        return value if value is not None and math.isfinite(value) else None
    except (SyntaxError, ValueError, ArithmeticError, RecursionError, MemoryError):
        return None


def _computed(node: ast.expr, names: "dict[str, Number]") -> Optional[Number]:
    if isinstance(node, ast.Constant):
        value = node.value
        return value if isinstance(value, float) or (type(value) is int and value < 1 << 32) else None
    if isinstance(node, ast.Name):
        return names.get(node.id)
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.USub, ast.UAdd)):
        inner = _computed(node.operand, names)
        return inner if inner is None or isinstance(node.op, ast.UAdd) else -inner
    if not isinstance(node, ast.BinOp):
        return None
    left, right = _computed(node.left, names), _computed(node.right, names)
    if left is None or right is None:
        return None
    if isinstance(node.op, ast.Div):
        # C cuts the quotient of whole numbers.
        return int(left / right) if isinstance(left, int) and isinstance(right, int) else left / right
    compute = _OPERATORS.get(type(node.op))
    return None if compute is None else compute(left, right)


@dataclass
class _Row:
    """A row of a table."""

    name: str  #: of the turn in the header
    turn: Turn
    notes: "list[str]"


class _Rows:
    """The rows of all tables of turns in a header."""

    def __init__(self, text: str, code: str, header: Header) -> None:
        self.text, self.code, self.header = text, code, header
        self.line_ends = [found.start() for found in re.finditer(r"\n", code)]
        self.structs = {}
        for found in re.finditer(r"\bstruct\s+(\w+)\s*\{([^{}]*)\}\s*(\w*)", code):
            members = re.findall(r"\b(\w+)(?:\s|\[[^\]]{0,60}\])*(?=[;,])", found[2])
            self.structs[found[1]] = self.structs[found[3] or found[1]] = members
        #: Where each array or struct with values begins, its type and its name.
        self.arrays = [(found.start(), found[1], found[2]) for found in re.finditer(r"\b(\w+)\s+(\w+)\s*(?:\[[^\]]{0,60}\]\s*)?=\s*\{", code)]
        self.others: "set[str]" = set()
        self.problems: "list[tuple[str, str]]" = []
        self.rows: "dict[str, list[_Row]]" = {}

    def read(self) -> "list[tuple[str, str]]":
        for row in re.finditer(r"\{([^{}]*)\}", self.code):
            if ";" not in row[1] and "," in row[1] and not re.search(r"\benum\b[\w\s:]*$", self.code[max(0, row.start() - 100) : row.start()]):
                self._read(row)
        for rows in self.rows.values():
            self._choose(rows)
        return self.problems

    def _read(self, row: "re.Match[str]") -> None:
        elements = [(row.start(1) + found.start(), found.group().strip()) for found in re.finditer(r"[^,]+", row[1]) if found.group().strip()]
        if not elements:
            return
        columns = self._columns(row.start())
        name = self._name(row, elements)
        if not all(column in columns for column in _NEEDED) or (not name and len(elements) != len(columns)):
            self._leave(row.start())
            return
        if not name:
            self.header.notes.append(f"line {self._line(row.start())}: a row without the name of a turn: not used; write it behind the row, as in // SS90E")
            return
        if _NAME.fullmatch(elements[0][1].strip('"')):
            elements = elements[1:]
        values = {}
        for (at, word), column in zip(elements, columns):
            if column in COLUMNS.values() and column != "profile":
                values[column] = self._number(at, word, column)
        for column in _NEEDED:
            if column not in values:
                self._problem(row.start(), f"has no {column}; the columns are {', '.join(columns)}")
        if None in values.values() or any(column not in values for column in _NEEDED):
            return
        comment = self._comment(row)
        profile = dict(zip(columns, (word for _, word in elements))).get("profile", "")
        self._add(name, row.start(), {key: float(value or 0.0) for key, value in values.items()}, "sin" in (comment + profile).lower())

    def _add(self, name: str, at: int, values: "dict[str, float]", is_sine: bool) -> None:
        turn = TURN_NAMES[name.rstrip("LR")]
        angle = {"45": 45.0, "135": 135.0, "180": 180.0}.get(turn, 90.0)
        if abs(abs(values.get("angle", angle)) - angle) > 0.1 * angle:
            self._problem(at, f"{name} turns by {angle:g} degrees, and its angle is {values['angle']:g}")
            return
        speed, omega, alpha = values["speed"], abs(values["omega"]) * _DEGREE, abs(values["alpha"]) * _DEGREE
        if is_sine:
            alpha *= 2.0 / math.pi
        read = Turn(turn, speed, before=values.get("lead_in", 0.0), yaw_speed=omega, yaw_acceleration=alpha)
        notes = _notes(name, read, values, angle * _DEGREE, is_sine)
        self.rows.setdefault(turn, []).append(_Row(name, read, notes))

    def _choose(self, rows: "list[_Row]") -> None:
        """Takes the first of the fastest rows of a turn: a robot has one path for each."""
        chosen = max(rows, key=lambda row: row.turn.speed)
        others = {row.turn for row in rows} - {chosen.turn}
        self.header.turns.append(chosen.turn)
        self.header.notes += chosen.notes
        if others:
            self.header.notes.append(f"{chosen.name} at {chosen.turn.speed:g} mm/s is the fastest of {len(rows)} rows of {chosen.turn.name}; the others are not used")

    def _array(self, at: int) -> "tuple[int, str, str]":
        """The array around a place: where it begins, its type and its name."""
        return self.arrays[bisect_right(self.arrays, (at, chr(0x10FFFF), "")) - 1] if self.arrays and self.arrays[0][0] <= at else (-1, "", "")

    def _leave(self, at: int) -> None:
        """Notes once that an array has something else than turns."""
        _, _, name = self._array(at)
        if name not in self.others:
            self.header.notes.append(f"line {self._line(at)}: {name or 'a list'} is no table of turns: not used")
        self.others.add(name)

    def _columns(self, at: int) -> "list[str]":
        """The names of the columns of the array around a place: those of its struct, or those of mazerunner-core."""
        members = self.structs.get(self._array(at)[1])
        return [COLUMNS.get(member, member) for member in (_USUAL if members is None else members)]

    def _name(self, row: "re.Match[str]", elements: "list[tuple[int, str]]") -> str:
        """The name of the turn of a row: before it, as its first value, in a comment behind it, or as the array's name."""
        designator = re.search(r"\[\s*(\w+)\s*\]\s*=\s*$", self.code[max(0, row.start() - 100) : row.start()])
        places = [designator[1] if designator else "", elements[0][1].strip('"') if elements else "", self._comment(row)]
        for place in [*places, self._array(row.start())[2]]:
            found = _NAME.search(place)
            if found:
                return found.group()
        return ""

    def _comment(self, row: "re.Match[str]") -> str:
        """The comment behind a row: at most 200 characters of the rest of its line."""
        return re.split(r"[\n{]", self.text[row.end() : row.end() + 200], maxsplit=1)[0]

    def _number(self, at: int, word: str, column: str) -> Optional[float]:
        value = _value(word, self.header.constants)
        if value is None:
            self._problem(at, f"'{word}' is no number, and this file does not define it")
        elif column in _NEEDED and not 0.001 <= abs(value) <= 1e7:
            self._problem(at, f"{column} is {value:g}; it must be 0.001 to 10000000")
        elif column == "speed" and value < 0.0 or abs(value) > 1e7:
            self._problem(at, f"{column} is {value:g}, which no turn has")
        else:
            return float(value)
        return None

    def _line(self, at: int) -> int:
        return bisect_left(self.line_ends, at) + 1

    def _problem(self, at: int, reason: str) -> None:
        while self.code[at].isspace():
            at += 1
        self.problems.append((f"{self._line(at)}:{at - self.code.rfind(chr(10), 0, at)}", reason))


def _notes(name: str, turn: Turn, values: "dict[str, float]", angle: float, is_sine: bool) -> "list[str]":
    """What is to be said of a turn: how far its offsets are from its curve, and what a sine ramp becomes."""
    notes = []
    end = _end(turn, angle, False)
    if "entry_offset" in values and "exit_offset" in values and math.sin(angle) > 1e-9:
        curve = end[1] / math.sin(angle)
        entry, leave = values["entry_offset"] + 0.0, values["exit_offset"] + 0.0
        notes.append(f"{name} is {turn.name}: offsets {entry:g} and {leave:g} mm, {curve:.1f} mm each by its speed and yaw rates, which count")
    if is_sine:
        error = math.dist(end, _end(turn, angle, True))
        notes.append(
            f"{name}: its sine ramps become steady ones of the same angle and time; the curve ends {error:.2f} mm from that of the sine"
        )
    return notes


def _end(turn: Turn, angle: float, is_sine: bool) -> "tuple[float, float]":
    """Where the curve of a turn ends in mm, ahead and aside of its beginning: with steady ramps of the yaw rate or with sine ramps,
    which are half a cosine wave: (1 - cos(pi t / T)) / 2."""
    alpha = turn.yaw_acceleration
    omega = min(turn.yaw_speed, math.sqrt(angle * alpha))
    ramp, arc = omega / alpha, angle / omega - omega / alpha
    times = np.linspace(0.0, 2.0 * ramp + arc, 4001)
    share = np.clip(np.minimum(times, times[-1] - times) / ramp, 0.0, 1.0)
    rates = omega * ((1.0 - np.cos(math.pi * share)) / 2.0 if is_sine else share)
    step = times[1]
    headings = np.concatenate([[0.0], np.cumsum((rates[1:] + rates[:-1]) * step / 2.0)])
    ahead, aside = np.cos(headings), np.sin(headings)
    scale = turn.speed * step / 2.0
    return float(np.sum(ahead[1:] + ahead[:-1]) * scale), float(np.sum(aside[1:] + aside[:-1]) * scale)
