"""A process that holds contests of mice in Python for a race: see _workers.py."""

import os
import pickle
import sys


def main() -> None:
    """Reads where modules are, then mice, then contests, until the input ends; answers each with what was played."""
    questions = os.fdopen(os.dup(0), "rb")
    answers = os.fdopen(os.dup(1), "wb")
    # What a mouse prints is no answer.
    os.dup2(2, 1)
    sys.path[:] = pickle.load(questions)
    makers = pickle.load(questions)
    from ._native import play

    while True:
        try:
            mouse, contest = pickle.load(questions)
        except EOFError:
            return
        pickle.dump(play(makers[mouse], *contest), answers)
        answers.flush()


if __name__ == "__main__":
    main()
