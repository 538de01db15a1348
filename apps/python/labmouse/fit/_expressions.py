"""Expressions of columns, such as (forward + rotation) / 7000."""

import ast
import operator
import re
from typing import Any, Callable, Sequence

import numpy as np

from .. import Error

_SIGNS: "dict[type, Callable[..., Any]]" = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.UAdd: operator.pos,
    ast.USub: operator.neg,
}
_MARK = "_column_"  # names of columns may be no names of Python
_LONGEST = 1000  # characters


class UnknownName(LookupError):
    """A name in an expression that is neither a column nor a number. name: that name."""

    def __init__(self, name: str) -> None:
        super().__init__(f"no column '{name}'")
        self.name = name


class Expression:
    """An expression of the columns of a log: + - * / ( ), numbers, `pi`, names of columns, and #3 for the third one.

    columns: the indices of the columns that it needs. Raises Error, or UnknownName.
    """

    def __init__(self, text: str, names: Sequence[str], width: int) -> None:
        if len(text) > _LONGEST:
            raise Error(f"--columns: an expression has more than {_LONGEST} characters")
        self.text = text
        self.columns: list[int] = []
        try:
            self._tree = ast.parse(self._with_marks(text, names, width), mode="eval").body
            self._check(self._tree)
        except (SyntaxError, RecursionError, MemoryError, ValueError):
            raise Error(f"--columns: '{text}' is no sum or product of columns; use + - * / ( ), numbers and names") from None

    def of(self, values: "dict[int, Any]") -> Any:
        """The value, where values[i] are those of column i. A division by 0 gives nan or inf."""
        with np.errstate(all="ignore"):
            return self._value(self._tree, values)

    def _with_marks(self, text: str, names: Sequence[str], width: int) -> str:
        """Replaces each name by a mark with its column. Where several names fit, the longest one counts."""
        ordered = sorted((name for name in set(names) if name), key=len, reverse=True)
        out, at = "", 0
        while at < len(text):
            rest = text[at:]
            name = next((one for one in ordered if rest.startswith(one) and _ends(one, rest)), "")
            if rest[0] in "+-*/() \t" and not name:
                out, at = out + rest[0], at + 1
                continue
            number = re.match(r"(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?(?=[-+*/()\s]|$)", rest)
            if name:
                mark = self._mark(list(names).index(name))
            elif number:
                name = mark = number[0]
            else:
                name = re.match(r"[^-+*/()\s]+", rest)[0]  # type: ignore[index]
                mark = self._other(name, width)
            out, at = f"{out} {mark} ", at + len(name)
        return out.strip()

    def _mark(self, column: int) -> str:
        if column not in self.columns:
            self.columns.append(column)
        return f"{_MARK}{column}"

    def _other(self, name: str, width: int) -> str:
        if name == "pi":
            return "3.141592653589793"
        if name.startswith("#") and name[1:].isdecimal() and 1 <= int(name[1:]) <= width:
            return self._mark(int(name[1:]) - 1)
        raise UnknownName(name)

    def _check(self, node: ast.AST) -> None:
        if isinstance(node, ast.BinOp) and type(node.op) in _SIGNS:
            self._check(node.left)
            self._check(node.right)
        elif isinstance(node, ast.UnaryOp) and type(node.op) in _SIGNS:
            self._check(node.operand)
        elif not (isinstance(node, ast.Name) or (isinstance(node, ast.Constant) and isinstance(node.value, (int, float)))):
            raise ValueError(type(node).__name__)

    def _value(self, node: Any, values: "dict[int, Any]") -> Any:
        if isinstance(node, ast.BinOp):
            left, right = self._value(node.left, values), self._value(node.right, values)
            return _SIGNS[type(node.op)](left, right)
        if isinstance(node, ast.UnaryOp):
            return _SIGNS[type(node.op)](self._value(node.operand, values))
        if isinstance(node, ast.Constant):
            number: Any = node.value
            return np.float64(number)
        return values[int(node.id[len(_MARK) :])]


def _ends(name: str, text: str) -> bool:
    """Whether the name at the beginning of a text is not the beginning of a longer one."""
    return len(text) == len(name) or text[len(name)] in "+-*/() \t"
