"""What a contest of a mouse in Python begins with: the same, however many processes there are and whatever was held before."""

import io
import random
import subprocess
import sys
import textwrap

import labmouse
import numpy
import pandas
import pytest

MAZES = ["contest-01", "contest-02", "contest-05", "capstone-1"]
steps_wanted = 5
MODULE = textwrap.dedent('''
    """Files of a user: state that the race's caller changed, and that contests leave behind."""
    import nearby_helper

    wanted = 5
    contests = 0

    class Counter:
        made = []

        def __init__(self):
            global contests
            contests += 1
            self.made.append(self)
            nearby_helper.note()
            self.left = wanted + 10 * (contests - 1) + 100 * (len(self.made) - 1) + 1000 * (nearby_helper.notes - 1)

        def decide(self, seen):
            self.left -= 1
            return "forfeit" if self.left < 0 else (0, 0)
''')
HELPER = "notes = 0\n\ndef note():\n    global notes\n    notes += 1\n"


@pytest.fixture
def nearby(monkeypatch, tmp_path):
    (tmp_path / "nearby.py").write_text(MODULE)
    (tmp_path / "nearby_helper.py").write_text(HELPER)
    monkeypatch.syspath_prepend(tmp_path)
    for name in ("nearby", "nearby_helper"):
        monkeypatch.delitem(sys.modules, name, raising=False)
    import nearby

    yield nearby
    for name in ("nearby", "nearby_helper"):
        sys.modules.pop(name, None)


def steps(mouse, **options):
    return set(labmouse.race(mouse, MAZES, **options).table["exploration_steps"])


@pytest.mark.parametrize("jobs", [1, 2])
def test_each_contest_begins_with_the_state_of_the_caller(nearby, jobs):
    assert steps(nearby.Counter, jobs=jobs) == {6}
    nearby.wanted = 60
    assert steps(nearby.Counter, jobs=jobs) == {61}
    nearby.Counter.extra = nearby.nearby_helper.notes = 0
    assert nearby.contests == 0 and nearby.Counter.made == []


def test_a_class_of_a_test_and_one_in_a_function_see_their_globals(monkeypatch):
    bonus = 3

    class Waiter:
        def __init__(self):
            self.left = steps_wanted + bonus

        def decide(self, seen):
            self.left -= 1
            return "forfeit" if self.left < 0 else (0, 0)

    assert steps(Waiter) == {9}
    monkeypatch.setitem(globals(), "steps_wanted", 10)
    bonus = 7
    assert steps(Waiter) == {18}


def test_a_module_whose_parts_cannot_leave_this_process(nearby):
    import threading

    nearby.nearby_helper.lock = threading.Lock()
    assert steps(nearby.Counter) == {6}


def test_a_mouse_that_cannot_leave_this_process_is_named():
    import threading

    lock = threading.Lock()

    class Locked:
        def decide(self, seen):
            with lock:
                return "forfeit"

    with pytest.raises(labmouse.Error, match="^[^\n]*'locked'[^\n]*lock[^\n]*$"):
        labmouse.race({"locked": Locked}, MAZES)


class Dicer:
    """Random in all ways that a process has."""

    def decide(self, seen):
        words = list({"north", "east", "south", "west", "up", "down"})
        turn = (-90, 0, 90)[(random.randrange(3) + len(words[0])) % 3]
        return turn, int(numpy.random.randint(1, 4))


DICE = """
import random, sys
sys.path.insert(0, {folder!r})
import numpy, labmouse
from semantics_test import Dicer
random.seed({seed}), numpy.random.seed({seed})
if __name__ == "__main__":
    print(labmouse.race(Dicer, ["contest-01", "contest-02"], jobs={jobs}, runs=3).to_csv(), end="")
"""


def test_random_numbers_and_the_order_of_sets_follow_the_seed_of_the_contest():
    from pathlib import Path

    folder = str(Path(__file__).parent)
    printed = []
    for seed in (1, 2):
        code = DICE.format(folder=folder, seed=seed, jobs=seed)
        ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
        printed.append(pandas.read_csv(io.StringIO(ran.stdout)).drop(columns="microseconds_per_decision"))
    assert len(printed[0]) == 6 and printed[0].equals(printed[1])


def test_the_dice_of_the_caller_stay_as_they_are():
    random.seed(1), numpy.random.seed(1)
    first = random.random(), numpy.random.rand()
    random.seed(1), numpy.random.seed(1)
    labmouse.run(Dicer, "contest-01", debug=True)
    labmouse.race(Dicer, "contest-01")
    assert (random.random(), numpy.random.rand()) == first


def test_one_contest_is_that_of_a_race():
    table = labmouse.race(Dicer, MAZES[:2], runs=2).table
    for row in table.itertuples():
        record = labmouse.run(Dicer, row.maze, seed=row.seed)
        assert record.figures["exploration_steps"] == row.exploration_steps
        assert len(record.steps) > 10
    assert len({labmouse.run(Dicer, "contest-01", seed=seed).steps.tobytes() for seed in (1, 2, 3)}) == 3
