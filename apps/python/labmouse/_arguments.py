"""What users give, looked at before it goes to the compiled part, which would answer with its own signatures."""

import operator
import os
import reprlib
from typing import Any

from ._native import Error

#: What no compiled number is beyond.
LARGEST_SEED = 2**64 - 1


def whole(name: str, value: Any, low: int, high: int) -> int:
    """A whole number within these limits; raises Error with its name."""
    try:
        number = operator.index(value)
    except TypeError:
        number = low - 1
    if not low <= number <= high:
        raise Error(f"{name} is a whole number from {low} to {high}, not {shown(value)}")
    return number


def runs_given(runs: Any) -> "int | None":
    """Contests in a maze; None for as many as are usual in the world. Raises Error."""
    return None if runs is None else whole("runs", runs, 1, 1_000_000)


def path(name: str, value: Any) -> str:
    """A path as text; raises Error with its name."""
    try:
        return os.fsdecode(value)
    except TypeError:
        raise Error(f"{name} is the path of a file, not {shown(value)}") from None


def shown(value: Any) -> str:
    """What a user gave, in a few words on one line."""
    if hasattr(value, "dtype") and hasattr(value, "shape"):
        return f"an array of {value.dtype} of the shape {value.shape}"
    words = " ".join(reprlib.repr(value).split())
    return words if len(words) <= 80 else words[:77] + "..."
