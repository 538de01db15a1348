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
from ._expressions import Expression, UnknownName
from ._files import content_of
from ._presets import prepared

#: Limits: length of a log in ms, time from row to row in ms beyond which the log has a gap, size of the file in MiB.
LONGEST, LONGEST_GAP, LARGEST = 600_000.0, 50.0, 128
MOST_GAPS = 0.1  #: share of rows after a gap
_EMPTY = ["", "-", "nan", "NaN"]


@dataclass
class Log:
    """The rows of a log.

    times: ms since the first row, increasing, shape (rows,). values: an array (rows,) for each role, in the role's unit
    (docs/how-to/robot-from-a-log.md); empty fields are NaN. name: of its file, for messages. Where rows are more than
    50 ms apart, the log has a gap.
    """

    times: Array
    values: dict[str, Array] = field(default_factory=dict)
    name: str = "log"

    def __contains__(self, role: str) -> bool:
        return role in self.values

    def __getitem__(self, role: str) -> Array:
        return self.values[role]


def read_log(path: "Union[str, os.PathLike[str]]", columns: str = "", *, period: float = 0.0, preset: str = "") -> Log:
    """Reads a log, at most 10 minutes and 128 MiB.

    columns: the roles of the columns, in the form of `--columns` (docs/how-to/robot-from-a-log.md). Without them, the
    log must have the format `preset` ("ukmars" or "kerise") or, with an empty `preset`, the first line of one of these.
    period: ms from row to row, if no column has the time. Raises Error with file, line and column of the first problem.
    """
    wanted = read_columns(columns, period) if columns else {}
    text = content_of(path, LARGEST).decode("utf-8-sig", errors="replace")
    text, of_preset, usual = prepared(os.fspath(path), text, preset)
    if not columns:
        if not of_preset:
            raise Error("--columns must say which column is what, as in time=ms,left=pwm_l/255,gyro*0.001")
        period = 0.0 if "time=" in of_preset else period or usual
        wanted = read_columns(of_preset, period)
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
        formulas = {role: self._formula(role, column, first, named) for role, column in columns.items()}
        self._check_widths(len(first), cut=text[-1:] != "\n")
        if len(kept) - self.start < 2:
            rows = "no rows below its first line" if len(kept) == self.start else "one row"
            raise Error(f"{name}: error: has {rows}; a fit needs two or more")
        frame = self._frame(sorted({place for formula in formulas.values() for place in formula.columns} or {0}), na_values=_EMPTY)
        self.problems: list[tuple[int, int, str]] = []
        log = Log(period * np.arange(float(len(frame))), name=name)
        for role, formula in formulas.items():
            log.values[role] = self._values(frame, role, columns[role], formula)
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

    def _formula(self, role: str, column: Column, first: list[str], named: bool) -> Expression:
        """The expression of a role. Only a name that is nothing else is an error of the first line."""
        names = first if named else []
        try:
            formula = Expression(column.name, names, len(first))
        except UnknownName as unknown:
            raise self._unknown(role, unknown.name, first, named) from None
        for place in formula.columns:
            again = next((i for i in range(place + 1, len(first)) if named and first[i] == first[place] and f"#{place + 1}" not in column.name), 0)
            if again:
                raise self._error(0, again, f"names '{_short(first[place])}' twice; give one by its number, as in {role}=#{again + 1}")
        return formula

    def _unknown(self, role: str, name: str, first: list[str], named: bool) -> Error:
        name = _short(name)
        if name.startswith("#"):
            return self._error(0, 0, f"has no column {name} for '{role}'; its first line has {len(first)}")
        if not named:
            return self._error(0, 0, f"does not name its columns, so none is '{name}'; give them by their numbers, as in {role}=#1")
        known = ", ".join(map(_short, first[:12])) + (f" and {len(first) - 12} more" if len(first) > 12 else "")
        return self._error(0, 0, f"has no column '{name}' for '{role}'; its columns are {known}")

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

    def _values(self, frame: "pd.DataFrame", role: str, column: Column, formula: Expression) -> Array:
        what = ROLES[role]
        known = len(self.problems)
        read = {place: self._numbers(frame[place], role, place) for place in formula.columns}
        place = formula.columns[0] if formula.columns else 0
        numbers = np.broadcast_to(np.asarray(formula.of(read), dtype=float), (len(frame),)).copy()
        if np.isinf(numbers).any():
            for row in np.flatnonzero(np.isinf(numbers))[:1]:
                self.problems.append((row, place, f"'{_short(formula.text)}' for '{role}' divides by 0"))
            numbers[np.isinf(numbers)] = np.nan
        if not what.gaps and known == len(self.problems):
            for row in np.flatnonzero(np.isnan(numbers))[:1]:
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

    def _numbers(self, read: "pd.Series[Any]", role: str, place: int) -> Array:
        """The numbers of a column; empty fields are NaN."""
        numbers = read.to_numpy(dtype=float, copy=True) if read.dtype.kind in "fi" else np.full(len(read), np.inf)
        if np.isinf(numbers).any() or self.has_tiny:  # read fields again as text: some are not plain numbers
            texts = self._frame([place], dtype=str, na_filter=False)[place].str.strip(' \t"')
            numbers = pd.to_numeric(texts, errors="coerce").to_numpy(dtype=float, copy=True)
            empty = texts.isin(_EMPTY).to_numpy()
            underflows = (np.abs(numbers) < np.finfo(float).tiny) & texts.str.contains("^[^eE]*[1-9]").to_numpy()
            numbers[~np.isfinite(numbers) | underflows] = np.nan
            for row in np.flatnonzero(~empty & np.isnan(numbers))[:1]:
                comma = "; write decimals as in 0.5" if "," in texts.iloc[row] else ""
                self.problems.append((row, place, f"'{_short(texts.iloc[row])}' for '{role}' is not a number in range{comma}"))
        return numbers

    def _check_times(self, times: Array) -> None:
        steps = np.diff(times)
        for row in np.flatnonzero(~(steps > 0.0) & np.isfinite(steps))[:1]:
            self.problems.append((row + 1, 0, f"the time goes from {times[row]:g} to {times[row + 1]:g} ms; it must grow"))
        gaps = steps > LONGEST_GAP
        for row in np.flatnonzero(gaps)[: int(gaps.sum() > MOST_GAPS * len(steps))]:
            reason = f"the time goes on by {steps[row]:g} ms; rows must be at most {LONGEST_GAP:g} ms apart, except at a few gaps: "
            reason += "cut it here, or give its unit, as in time=NAME*1000"
            self.problems.append((row + 1, 0, reason))
        for row in np.flatnonzero(times > LONGEST)[:1]:
            self.problems.append((row, 0, f"is longer than {LONGEST / 1000.0:g} s; cut it here"))


def _short(name: str) -> str:
    """A printable name of at most 24 characters, for messages."""
    plain = "".join(c if c.isprintable() else "�" for c in name)
    return plain if len(plain) <= 24 else plain[:24] + "..."
