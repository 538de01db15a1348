"""Checks of arguments. Without them, a wrong argument gives nanobind's message, a list of C++ signatures."""

import operator
import os
import reprlib
from typing import Any

from ._native import Error

#: The largest unsigned 64-bit number.
LARGEST_SEED = 2**64 - 1


def whole(name: str, value: Any, low: int, high: int) -> int:
    """The value as an int from `low` to `high`. Raises Error, with the argument's name, for any other value."""
    try:
        number = operator.index(value)
    except TypeError:
        number = low - 1
    if not low <= number <= high:
        raise Error(f"{name} is a whole number from {low} to {high}, not {shown(value)}")
    return number


def runs_given(runs: Any) -> "int | None":
    """Checks `runs`, the number of contests per maze; None stands for the world's default. Raises Error."""
    return None if runs is None else whole("runs", runs, 1, 1_000_000)


def path(name: str, value: Any) -> str:
    """The path as a str. Raises Error, with the argument's name, if it is not a path."""
    try:
        return os.fsdecode(value)
    except TypeError:
        raise Error(f"{name} is the path of a file, not {shown(value)}") from None


def shown(value: Any) -> str:
    """A value as at most 80 characters on one line, for messages."""
    if hasattr(value, "dtype") and hasattr(value, "shape"):
        return f"an array of {value.dtype} of the shape {value.shape}"
    words = " ".join(reprlib.repr(value).split())
    return words if len(words) <= 80 else words[:77] + "..."
