"""Mice for semantics_test.py: one whose module has all kinds of objects, and one that is stochastic."""

from __future__ import annotations

import abc
import dataclasses
import enum
import functools
import itertools
import logging
import random
import threading
import typing
import weakref

import labmouse
import numpy

log = logging.getLogger(__name__)
lock = threading.RLock()
counter = itertools.count()
T = typing.TypeVar("T")


class Side(enum.Enum):
    north = 0
    east = 1


class Flag(enum.IntFlag):
    one = 1
    two = 2


@dataclasses.dataclass(frozen=True, order=True)
class Node:
    x: int
    y: int = 0

    def next(self, side: Side) -> Node:
        return Node(self.x + (0, 1)[side.value], self.y + (1, 0)[side.value])


class Pair(typing.NamedTuple):
    first: int = 0


class Base(abc.ABC, typing.Generic[T]):
    @abc.abstractmethod
    def decide(self, seen: labmouse.Sighting) -> labmouse.Action: ...

    @property
    def cost(self):
        return self._cost


class Meta(type):
    def __new__(mcs, name, bases, space):
        made = super().__new__(mcs, name, bases, space)
        made.tag = name
        return made


class Slotted(metaclass=Meta):
    __slots__ = ("one", "__weakref__")

    def __init__(self):
        self.one = 1


@functools.lru_cache(maxsize=None)
def fibonacci(number):
    return number if number < 2 else fibonacci(number - 1) + fibonacci(number - 2)


@functools.singledispatch
def kind_of(thing):
    return "other"


@kind_of.register
def _(thing: int):
    return "whole"


@kind_of.register
def _(thing: Node):
    return "node"


TABLE = {Side.north: Node(0, 1), "numbers": numpy.arange(5.0), "words": {"one", "two", "three"}}


class Rich(Base[int]):
    made: typing.ClassVar[int] = 0

    def __init__(self, told: labmouse.Briefing):
        super().__init__()
        self._cost = fibonacci(10)
        self.slotted = Slotted()
        self.weak = weakref.ref(self.slotted)
        self.node = Node(*told.start)
        Rich.made += 1
        assert type(self).made == 1 and next(counter) == 0

    def decide(self, seen: labmouse.Sighting) -> labmouse.Action:
        @dataclasses.dataclass
        class Local:
            number: int

        class Other(Node):
            beside: Node = TABLE[Side.north]

            def wait(self, seen: labmouse.Sighting) -> Node:
                return self

        log.debug("nobody listens")
        with lock:
            assert Local(1).number == 1 and Other(1).wait(seen).beside == Node(0, 1)
        assert isinstance(self.node.next(Side.east), Node) and self.weak() is self.slotted and Pair().first == 0
        assert Flag.one | Flag.two == 3 and kind_of(3) == "whole" and kind_of(self.node) == "node" and Slotted.tag == "Slotted"
        assert isinstance(self, Base) and TABLE[Side.north] == Node(0, 1) and self.cost == 55 and TABLE["numbers"].sum() == 10
        return (0, 1) if seen.ahead else (90, 0)


class Dicer:
    """Depends on the order of a set and on the global generators of random and numpy."""

    def decide(self, seen):
        words = list({"north", "east", "south", "west", "up", "down"})
        turn = (-90, 0, 90)[(random.randrange(3) + len(words[0])) % 3]
        return turn, int(numpy.random.randint(1, 4))
