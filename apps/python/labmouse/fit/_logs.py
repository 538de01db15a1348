"""Logs of a mouse: CSV files, read by pandas and checked strictly."""

import csv
import io
import os
import re
from dataclasses import dataclass, field
from typing import Any, Union

import numpy as np
import pandas as pd

from .. import Error
from ._columns import ROLES, Column, read_columns
from ._estimates import Array
from ._files import content_of

#: Limits: length of a log in ms, time from row to row in ms, size of the file in MiB.
LONGEST, LONGEST_GAP, LARGEST = 600_000.0, 50.0, 128
_EMPTY = ["", "-", "nan", "NaN"]


@dataclass
class Log:
    """The rows of a log.

    times: ms since the first row, increasing, shape (rows,). values: an array (rows,) for each role, in the role's unit
    (docs/how-to/robot-from-a-log.md); empty fields are NaN. name: of its file, for messages.
    """

    times: Array
    values: dict[str, Array] = field(default_factory=dict)
    name: str = "log"

    def __contains__(self, role: str) -> bool:
        return role in self.values

    def __getitem__(self, role: str) -> Array:
        return self.values[role]


def read_log(path: "Union[str, os.PathLike[str]]", columns: str, *, period: float = 0.0) -> Log:
    """Reads a log, at most 10 minutes and 128 MiB.

    columns: the roles of the columns, in the form of `--columns` (docs/how-to/robot-from-a-log.md). period: ms from row
    to row, if no column has the time. Raises Error with file, line and column of the first problem.
    """
    wanted = read_columns(columns, period)
    text = content_of(path, LARGEST).decode("utf-8-sig", errors="replace")
    return _Reader(os.fspath(path), text, wanted, period).log


class _Reader:
    def __init__(self, name: str, text: str, columns: dict[str, Column], period: float) -> None:
        self.name = name
        split = text.split("\n")
        kept = [(i + 1, line.rstrip("\r").replace("\r", " ")) for i, line in enumerate(split) if line.strip(' \t\r"') and not line.startswith("#")]
        if not kept:
            raise Error(f"{name}: error: is empty; a log has a line with names and two or more rows")
        self.has_tiny = re.search(r"e-\d{3}", text, re.IGNORECASE) is not None
        self.numbers = [number for number, _ in kept]
        self.lines = [line for _, line in kept]
        self.separator = next((one for one in ",;\t" if one in self.lines[0]), " ")
        first = self._fields(self.lines[0])
        named = any(one not in _EMPTY and pd.isna(pd.to_numeric(one, errors="coerce")) for one in first)
        self.start = 1 if named else 0
        places = {role: self._place(role, column, first, named) for role, column in columns.items()}
        self._check_widths(len(first), cut=text[-1:] != "\n")
        if len(kept) - self.start < 2:
            rows = "no rows below its first line" if len(kept) == self.start else "one row"
            raise Error(f"{name}: error: has {rows}; a fit needs two or more")
        frame = self._frame(sorted(set(places.values())), na_values=_EMPTY)
        self.problems: list[tuple[int, int, str]] = []
        log = Log(period * np.arange(float(len(frame))), name=name)
        for role, place in places.items():
            log.values[role] = self._values(frame[place], role, columns[role], place)
        if "time" in log.values:
            log.times = log.values["time"] - log.values["time"][0]
        self._check_times(log.times)
        if self.problems:
            row, place, reason = min(self.problems)
            raise self._error(self.start + row, place, reason)
        self.log = log

    def _fields(self, line: str) -> list[str]:
        if self.separator == " ":
            return [one.strip('"') for one in line.split()]
        return [one.strip(' \t"') for one in next(csv.reader([line], delimiter=self.separator))]

    def _error(self, index: int, place: int, reason: str) -> Error:
        """An error at a field. index: of the line in self.lines; place: of the field, from 0."""
        line = self.lines[index]
        at = len(self.separator.join(line.split(self.separator)[:place])) + (place > 0) if self.separator != " " else 0
        if self.separator == " " and place:
            at = len(line) - len(line.split(None, place)[place])
        return Error(f"{self.name}:{self.numbers[index]}:{at + 1}: error: {reason}")

    def _check_widths(self, width: int, cut: bool) -> None:
        for i, line in enumerate(self.lines):
            if line.count('"') % 2:
                raise self._error(i, 0, "has a quotation mark that is not closed; take it out")
            fields = line.count(self.separator) + 1 if self.separator != " " and '"' not in line else len(self._fields(line))
            if fields != width:
                end = cut and i + 1 == len(self.lines)
                reason = f"has {fields} fields, and the first line {width}" + (": the log is cut off here; take this line out" if end else "")
                raise self._error(i, 0, reason)

    def _place(self, role: str, column: Column, first: list[str], named: bool) -> int:
        name = _short(column.name)
        if column.name.startswith("#"):
            number = column.name[1:]
            if not number.isdecimal() or not 1 <= int(number) <= len(first):
                raise self._error(0, 0, f"has no column {name} for '{role}'; its first line has {len(first)}")
            return int(number) - 1
        if not named:
            raise self._error(0, 0, f"does not name its columns, so none is '{name}'; give them by their numbers, as in {role}=#1")
        found = [i for i, one in enumerate(first) if one == column.name]
        if not found:
            known = ", ".join(map(_short, first[:12])) + (f" and {len(first) - 12} more" if len(first) > 12 else "")
            raise self._error(0, 0, f"has no column '{name}' for '{role}'; its columns are {known}")
        if len(found) > 1:
            raise self._error(0, found[1], f"names '{name}' twice; give one by its number, as in {role}=#{found[1] + 1}")
        return found[0]

    def _frame(self, places: list[int], **how: Any) -> "pd.DataFrame":
        frame: pd.DataFrame = pd.read_csv(
            io.StringIO("\n".join(self.lines[self.start :])),
            sep=r"\s+" if self.separator == " " else self.separator,
            quoting=csv.QUOTE_NONE if self.separator == " " else csv.QUOTE_MINIMAL,
            header=None,
            usecols=places,
            skipinitialspace=True,
            keep_default_na=False,
            low_memory=False,
            **how,
        )
        return frame

    def _values(self, read: "pd.Series[Any]", role: str, column: Column, place: int) -> Array:
        what = ROLES[role]
        numbers = read.to_numpy(dtype=float, copy=True) if read.dtype.kind in "fi" else np.full(len(read), np.inf)
        empty = np.isnan(numbers)
        if np.isinf(numbers).any() or self.has_tiny:  # read fields again as text: some are not plain numbers
            texts = self._frame([place], dtype=str, na_filter=False)[place].str.strip(' \t"')
            numbers = pd.to_numeric(texts, errors="coerce").to_numpy(dtype=float, copy=True)
            empty = texts.isin(_EMPTY).to_numpy()
            underflows = (np.abs(numbers) < np.finfo(float).tiny) & texts.str.contains("^[^eE]*[1-9]").to_numpy()
            numbers[~np.isfinite(numbers) | underflows] = np.nan
            for row in np.flatnonzero(~empty & np.isnan(numbers))[:1]:
                comma = "; write decimals as in 0.5" if "," in texts.iloc[row] else ""
                self.problems.append((row, place, f"'{_short(texts.iloc[row])}' for '{role}' is not a number in range{comma}"))
        if not what.gaps:
            for row in np.flatnonzero(empty)[:1]:
                self.problems.append((row, place, f"has no value for '{role}'"))
        if column.wraps:
            steps = np.round(np.diff(numbers, prepend=numbers[0]) / column.wraps)
            numbers = numbers - np.cumsum(steps) * column.wraps
        values: Array = column.factor * numbers
        slack = 1e-6 * what.high  # for rounding in the factor
        for row in np.flatnonzero((values < what.low - slack) | (values > what.high + slack))[:1]:
            hint = f"; {what.hint}" if what.hint else ""
            self.problems.append((row, place, f"'{role}' is {values[row]:g}; it must be {what.low:g} to {what.high:g} {what.unit}".rstrip() + hint))
        return values

    def _check_times(self, times: Array) -> None:
        steps = np.diff(times)
        for row in np.flatnonzero(~(steps > 0.0) & np.isfinite(steps))[:1]:
            self.problems.append((row + 1, 0, f"the time goes from {times[row]:g} to {times[row + 1]:g} ms; it must grow"))
        for row in np.flatnonzero(steps > LONGEST_GAP)[:1]:
            reason = f"the time goes on by {steps[row]:g} ms; a log has no gaps of more than {LONGEST_GAP:g} ms: "
            reason += "cut it here, or give its unit, as in time=NAME*1000"
            self.problems.append((row + 1, 0, reason))
        for row in np.flatnonzero(times > LONGEST)[:1]:
            self.problems.append((row, 0, f"is longer than {LONGEST / 1000.0:g} s; cut it here"))


def _short(name: str) -> str:
    """A printable name of at most 24 characters, for messages."""
    plain = "".join(c if c.isprintable() else "�" for c in name)
    return plain if len(plain) <= 24 else plain[:24] + "..."
