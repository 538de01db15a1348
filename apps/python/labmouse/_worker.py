"""The main program of a worker process, which runs contests of mice in Python: see _workers.py."""

import os
import pickle
import sys
import threading
import time
from typing import Any, BinaryIO, Callable

from ._by_value import loads
from ._modules import is_own
from ._native import Strategy

#: The code that a worker process starts with. It first receives sys.path, by which it finds this module.
PROGRAM = """
import pickle, sys
sys.path[:] = pickle.load(sys.stdin.buffer)
from labmouse._worker import main
main()
"""


class _Surroundings:
    """sys.path, environment, working folder and modules of this process, to restore before each contest."""

    def __init__(self) -> None:
        self.path, self.environment = list(sys.path), dict(os.environ)
        try:
            self.folder: "str | None" = os.getcwd()
        except OSError:  # it is gone
            self.folder = None
        self.modules = set(sys.modules)

    def restore(self) -> None:
        """Restores all of it. Removes the user's modules that contests imported; later contests import them again."""
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
    """Unpickles the maker of a mouse. If that fails, returns a maker that raises the reason."""
    try:
        maker: Callable[..., Any] = loads(mouse)
        if b"numpy" in mouse:
            import numpy.random  # noqa: F401  seed_chance seeds it only if it is loaded
        return maker
    except Exception as error:  # what a user's object raises can be anything
        reason = error

        def broken(_: object) -> None:
            raise reason

        return broken


def _decide(strategy: Strategy, questions: BinaryIO, answer: "Callable[[object], None]") -> None:
    """Serves the requests of one contest until it ends."""
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
    """Ends this process when its parent is gone, even if a mouse never answers."""
    while os.getppid() == parent:
        time.sleep(1)
    os._exit(1)


def main() -> None:
    """Reads mice and contests from standard input until it ends."""
    threading.Thread(target=_end_with, args=(os.getppid(),), daemon=True).start()
    questions = sys.stdin.buffer
    answers = os.fdopen(os.dup(1), "wb")
    # Redirect standard output to standard error and empty standard input: a mouse must not write or read our protocol.
    os.dup2(2, 1)
    sys.stdin = open(os.devnull, encoding="utf-8")

    def answer(thing: object) -> None:
        try:
            pickle.dump(thing, answers)
            answers.flush()
        except BrokenPipeError:  # the parent is gone
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
