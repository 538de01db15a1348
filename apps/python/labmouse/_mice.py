"""Mice written in Python, and the conversion of mice to the types of the compiled part."""

import contextlib
import inspect
import os
import random
import shutil
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, Literal, NamedTuple, Protocol, Union

from . import _native
from ._arguments import shown
from ._native import Briefing, Error
from ._workers import Workers


class Sighting(NamedTuple):
    """A sensor reading: the number of open cells up to the next wall in three directions, 0 to 63 each."""

    left: int
    ahead: int
    right: int


_native.set_sighting_type(Sighting)

#: The answer of a mouse: (rotation in degrees clockwise: -90, 0 or 90; movement in cells: -3 to 3, negative backwards);
#: 'reset' to go back to the start for the speed run; or 'forfeit' to give up.
Action = Union[tuple[int, int], Literal["reset", "forfeit"]]


class Mouse(Protocol):
    """A mouse in Python. Each contest makes a new one.

    Worlds in seconds call two more methods, if the mouse has them:

    - `carried(self, seconds)`: the mouse was put back to the start, `seconds` after the contest began.
    - `show(self, x, y, heading, seen)`: a reading where the mouse does not decide, such as in a cell that it passes.

    Its class may have two attributes:

    - `uses_chance`: whether the mouse is stochastic and so runs several contests per maze. Without it, labmouse derives
      this from the code.
    - `version`: any value, for stores. Change it when something outside of the code changes that the mouse depends on.
    """

    def decide(self, seen: Sighting) -> Action:
        """Returns the next action for the reading in the present pose. Called once per step until the contest ends."""
        ...


#: A class or function that makes the mouse of a contest. It gets the briefing if it takes a positional argument.
MouseMaker = Union[Callable[[], Mouse], Callable[[Briefing], Mouse]]
#: A mouse of a race: a SPEC as on the command line ('flood:stride=1', 'program:python3 mouse.py') or a MouseMaker.
AnyMouse = Union[str, MouseMaker]
#: Mice of a race: one, several, or a mapping from names to mice.
Mice = Union[AnyMouse, Iterable[AnyMouse], Mapping[str, AnyMouse]]

_Own = tuple[str, "Maker", bool]
_Native = tuple[list[tuple[str, str]], list[tuple[str, object, bool, object, str]], str, str]


class Given(NamedTuple):
    """The mice of a call, SPECs and mice in Python apart."""

    specs: "list[tuple[str, str]]"
    """(name, SPEC); the name is '' if the user gave none."""
    own: "list[_Own]"
    """Mice in Python: (name, maker, whether it is stochastic)."""

    def native(self, workers: "Workers | None", label: "str | None" = None, stored: bool = False) -> "_Native":
        """The mice as the compiled part takes them. `stored`: also computes identities for a store; raises Error if
        the identity of a mouse cannot be determined."""
        own: list[tuple[str, object, bool, object, str]] = []
        for number, (name, maker, uses_chance) in enumerate(self.own):
            elsewhere = workers.elsewhere(number) if workers is not None else None
            own.append((name, maker, uses_chance, elsewhere, _identity(name, maker, label) if stored else ""))
        return self.specs, own, _python(), label or ""


def _takes_briefing(maker: Callable[..., Mouse]) -> bool:
    try:
        parameters = inspect.signature(maker).parameters.values()
    except (TypeError, ValueError):
        return False
    places = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD, inspect.Parameter.VAR_POSITIONAL)
    return any(parameter.kind in places for parameter in parameters)


def seed_chance(seed: int) -> None:
    """Seeds the global generators of the process: `random`, and `numpy.random` if it is loaded."""
    random.seed(seed)
    numpy = sys.modules.get("numpy")
    if numpy is not None:
        numpy.random.seed(seed % 2**32)


@contextlib.contextmanager
def kept_chance() -> "Iterator[None]":
    """A context that restores the state of the generators of seed_chance at its end."""
    before = random.getstate()
    numpy = sys.modules.get("numpy")
    numbers = numpy.random.get_state() if numpy is not None else None
    try:
        yield
    finally:
        random.setstate(before)
        if numpy is not None:
            numpy.random.set_state(numbers)


class Maker:
    """Seeds the global generators and makes the mouse of a contest. The user's class need not take a briefing."""

    def __init__(self, maker: Callable[..., Mouse]) -> None:
        self.maker = maker
        self.briefs = _takes_briefing(maker)

    def __call__(self, briefing: Briefing) -> Mouse:
        seed_chance(briefing.seed)
        return self.maker(briefing) if self.briefs else self.maker()


def _identity(name: str, made: Maker, label: "str | None") -> str:
    """The text by which a store tells this mouse from others. Raises Error if it depends on things that labmouse cannot
    see and the user gives neither version nor label."""
    from ._identity import Walk, identity_of

    walk = Walk().go(made.maker)
    stated = label or getattr(made.maker, "version", None) is not None
    if walk.outside and not stated:
        raise Error(f"mouse '{name}' depends on what a store cannot see ({', '.join(sorted(walk.outside))}); give it a version, as in "
                    "`version = 1` in its class, or a label, as in label='v1', and another one when that changes")
    return identity_of(walk, name, made.maker, label)


def _uses_chance(maker: Any) -> bool:
    """The attribute `uses_chance`; without it, whether the mouse's code can reach random numbers or the seed."""
    from ._identity import Walk

    stated = getattr(maker, "uses_chance", None)
    return Walk().go(maker).chance if stated is None else bool(stated)


def _own(name: str, maker: Any) -> _Own:
    if not callable(maker):
        if hasattr(maker, "decide"):
            raise Error(f"'{name}' is an object; give its class, so that each contest has a mouse of its own")
        raise Error(f"'{name}' is no mouse; give a SPEC, or a class with decide(self, seen)")
    return name, Maker(maker), _uses_chance(maker)


def _name_of(maker: Any) -> str:
    return str(getattr(maker, "__name__", type(maker).__name__))


def given(mice: "Mice | None") -> Given:
    """Checks the argument `mice` and splits it by kind. Raises Error if something is not a mouse."""
    if mice is None:
        return Given([], [])
    if isinstance(mice, str):
        found: "list[tuple[str, AnyMouse]]" = [("", mice)]
    elif isinstance(mice, Mapping):
        for name in mice:
            if not isinstance(name, str):
                raise Error(f"{shown(name)} is no name of a mouse; give each one as a text, as in {{'name': mouse}}")
            if not name:
                raise Error("a mouse has an empty name; give it one, as in {'name': mouse}")
        found = list(mice.items())
    elif callable(mice) or not isinstance(mice, Iterable):
        found = [(_name_of(mice), mice)]
    else:
        found = [("" if isinstance(mouse, str) else _name_of(mouse), mouse) for mouse in mice]
    if not found:
        raise Error("there are no mice here; name one, or omit the mice to race all built-in ones")
    return Given([(name, mouse) for name, mouse in found if isinstance(mouse, str)],
                 [_own(name, mouse) for name, mouse in found if not isinstance(mouse, str)])


def _python() -> str:
    """The interpreter of capstone robots: '' for the python3 of PATH or, if there is none, the path of this one."""
    return "" if shutil.which("python3") else os.fspath(sys.executable)
