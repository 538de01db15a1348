"""A process that holds contests of mice in Python for a race: see _workers.py."""

import os
import pickle
import sys

from ._native import play

#: What such a process runs: it is first told where modules are, this one among them.
PROGRAM = """
import pickle, sys
sys.path[:] = pickle.load(sys.stdin.buffer)
from labmouse._worker import main
main()
"""


def main() -> None:
    """Reads mice and says that it has them; then contests, until the input ends, and answers each with what was played."""
    questions = sys.stdin.buffer
    answers = os.fdopen(os.dup(1), "wb")
    # What a mouse prints is no answer, and what it would read is no question to it.
    os.dup2(2, 1)
    sys.stdin = open(os.devnull, encoding="utf-8")
    makers = pickle.load(questions)
    pickle.dump(True, answers)
    answers.flush()
    while True:
        try:
            mouse, contest = pickle.load(questions)
        except EOFError:
            return
        pickle.dump(play(makers[mouse], *contest), answers)
        answers.flush()

