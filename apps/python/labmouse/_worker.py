"""A process that holds contests of mice in Python: see _workers.py."""

import os
import pickle
import sys
import threading
import time
from typing import Any, BinaryIO, Callable

from ._by_value import loads
from ._modules import is_own
from ._native import Strategy

#: What such a process runs: it is first told where modules are, this one among them.
PROGRAM = """
import pickle, sys
sys.path[:] = pickle.load(sys.stdin.buffer)
from labmouse._worker import main
main()
"""


class _Surroundings:
    """What a contest may change in this process, as it was before."""

    def __init__(self) -> None:
        self.path, self.environment = list(sys.path), dict(os.environ)
        try:
            self.folder: "str | None" = os.getcwd()
        except OSError:  # it is gone
            self.folder = None
        self.modules = set(sys.modules)

    def restore(self) -> None:
        """What contests have imported from files of the user's own is imported anew by the next."""
        sys.path[:] = self.path
        if dict(os.environ) != self.environment:
            os.environ.clear()
            os.environ.update(self.environment)
        if self.folder is not None:
            os.chdir(self.folder)
        for name in set(sys.modules) - self.modules:
            module = sys.modules[name]
            if module is None or is_own(module):
                del sys.modules[name]
            else:
                self.modules.add(name)


def _maker(mouse: bytes) -> "Callable[..., Any]":
    """What makes the mouse; what raises in its place where it cannot be made here."""
    try:
        maker: Callable[..., Any] = loads(mouse)
        if b"numpy" in mouse:
            import numpy.random  # noqa: F401  so that it is there to be seeded
        return maker
    except Exception as error:  # what a user's object raises can be anything
        reason = error

        def broken(_: object) -> None:
            raise reason

        return broken


def _decide(strategy: Strategy, questions: BinaryIO, answer: "Callable[[object], None]") -> None:
    """Answers the questions of a contest, until it has ended."""
    answer(strategy.started)
    while True:
        what, words = pickle.load(questions)
        if what == "decide":
            answer(strategy.decide(*words))
        elif what == "show":
            strategy.show(*words)
        elif what == "carried":
            strategy.carried(*words)
        else:
            answer((strategy.last_words(), strategy.microseconds))
            return


def _end_with(parent: int) -> None:
    """A mouse that never answers does not outlive the race."""
    while os.getppid() == parent:
        time.sleep(1)
    os._exit(1)


def main() -> None:
    """Reads mice and contests until the input ends."""
    threading.Thread(target=_end_with, args=(os.getppid(),), daemon=True).start()
    questions = sys.stdin.buffer
    answers = os.fdopen(os.dup(1), "wb")
    # What a mouse prints is no answer, and what it would read is no question to it.
    os.dup2(2, 1)
    sys.stdin = open(os.devnull, encoding="utf-8")

    def answer(thing: object) -> None:
        try:
            pickle.dump(thing, answers)
            answers.flush()
        except BrokenPipeError:  # nobody listens any more
            os._exit(1)

    mice: list[bytes] = []
    surroundings = _Surroundings()
    while True:
        try:
            what, *words = pickle.load(questions)
        except EOFError:
            return
        if what == "mice":
            [mice] = words
            continue
        number, briefing = words
        surroundings.restore()
        _decide(Strategy(_maker(mice[number]), briefing), questions, answer)
