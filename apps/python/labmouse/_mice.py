"""Mice that are written in Python, and what the library takes for a mouse."""

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
    """What a mouse reads: the number of open cells in three directions, up to the next wall; 0 to 63 each."""

    left: int
    ahead: int
    right: int


_native.set_sighting_type(Sighting)

#: What a mouse answers: a turn in degrees clockwise (-90, 0 or 90) and then cells to go (-3 to 3, negative backwards);
#: 'reset', back to the start for the speed run; or 'forfeit', it gives up.
Action = Union[tuple[int, int], Literal["reset", "forfeit"]]


class Mouse(Protocol):
    """A mouse in Python. There is a new one for each contest.

    It may have two more methods, which worlds in seconds call: `carried(self, seconds)`, it was carried to the start so many
    seconds after the contest began; and `show(self, x, y, heading, seen)`, what it reads on a way on which it is driven, or in a
    cell that it passes. Its class may have `uses_chance`, whether it has several contests in a maze, in place of what labmouse
    finds in its code; and `version`, for stores, where it depends on what lies outside of its code.
    """

    def decide(self, seen: Sighting) -> Action:
        """The next action, given what the mouse sees in its present pose. Called once a step until the contest ends."""
        ...


#: What makes the mouse of a contest: a class, or a function. It is called with the briefing if it takes an argument.
MouseMaker = Union[Callable[[], Mouse], Callable[[Briefing], Mouse]]
#: A mouse of a race: a SPEC as on the command line ('flood:stride=1', 'program:python3 mouse.py'), or what makes one.
AnyMouse = Union[str, MouseMaker]
#: Mice of a race: one, several, or several under names of their own.
Mice = Union[AnyMouse, Iterable[AnyMouse], Mapping[str, AnyMouse]]

_Own = tuple[str, "Maker", bool]
_Native = tuple[list[tuple[str, str]], list[tuple[str, object, bool, object, str]], str, str]


class Given(NamedTuple):
    """Mice in their kinds."""

    specs: "list[tuple[str, str]]"
    """Names, where the user gave one, and SPECs."""
    own: "list[_Own]"
    """Mice in Python: name, maker, and whether they are stochastic."""

    def native(self, workers: "Workers | None", label: "str | None" = None, stored: bool = False) -> "_Native":
        """The mice as the compiled part takes them; raises Error where nothing is known of one that is to be stored."""
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
    """Seeds the random numbers that all of the process shares: those of `random`, and of `numpy.random` where it is loaded."""
    random.seed(seed)
    numpy = sys.modules.get("numpy")
    if numpy is not None:
        numpy.random.seed(seed % 2**32)


@contextlib.contextmanager
def kept_chance() -> "Iterator[None]":
    """Leaves these random numbers as they were."""
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
    """Makes the mouse of a contest from its briefing, whether or not the user's class takes one."""

    def __init__(self, maker: Callable[..., Mouse]) -> None:
        self.maker = maker
        self.briefs = _takes_briefing(maker)

    def __call__(self, briefing: Briefing) -> Mouse:
        seed_chance(briefing.seed)
        return self.maker(briefing) if self.briefs else self.maker()


def _identity(name: str, made: Maker, label: "str | None") -> str:
    """What tells a mouse from another in a store; raises Error where that cannot be known and the user does not say it."""
    from ._identity import Walk, identity_of

    walk = Walk().go(made.maker)
    stated = label or getattr(made.maker, "version", None) is not None
    if walk.outside and not stated:
        raise Error(f"mouse '{name}' depends on what a store cannot see ({', '.join(sorted(walk.outside))}); give it a version, as in "
                    "`version = 1` in its class, or a label, as in label='v1', and another one when that changes")
    return identity_of(walk, name, made.maker, label)


def _uses_chance(maker: Any) -> bool:
    """What the mouse says of itself; otherwise whether its code comes to random numbers or to the seed."""
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
    """The mice by their kinds; raises Error where something is no mouse."""
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
    """What runs robots of the capstone project: the python3 of PATH, or this one where there is none."""
    return "" if shutil.which("python3") else os.fspath(sys.executable)
