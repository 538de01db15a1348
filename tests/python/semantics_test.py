"""Contests of a mouse in Python start from the same state, for any number of processes and after any other contests."""

import io
import os
import random
import subprocess
import sys
import textwrap
from pathlib import Path

import labmouse
import numpy
import pandas
import pytest
import rich_mouse
from rich_mouse import Dicer

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
    return set(labmouse.race(mouse, MAZES, **options).table["search_steps"])


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
    nearby.nearby_helper.going = (number for number in range(3))
    assert steps(nearby.Counter) == {6}


def test_a_mouse_that_cannot_leave_this_process_is_named():
    going = (number for number in range(3))

    class Goer:
        def decide(self, seen):
            return 0, next(going)

    with pytest.raises(labmouse.Error, match="^[^\n]*'goer'[^\n]*generator[^\n]*$"):
        labmouse.race({"goer": Goer}, MAZES)


def test_a_mouse_of_all_kinds_of_things():
    table = labmouse.race({"rich": rich_mouse.Rich, "made": lambda told: rich_mouse.Rich(told)}, MAZES, budget=40, runs=1).table
    assert table["outcome"].tolist() == ["out of steps"] * 8
    assert rich_mouse.Rich.made == 0 and next(rich_mouse.counter) == 0


def test_its_digest_is_the_same_in_every_process():
    code = """if True:
        import sys
        sys.path.insert(0, sys.argv[1])
        import rich_mouse
        from labmouse._identity import Walk
        print(Walk().go(rich_mouse).digest.hexdigest())
    """
    words = [sys.executable, "-c", code, str(Path(__file__).parent)]
    printed = [subprocess.run(words, capture_output=True, text=True, check=True, env={**os.environ, "PYTHONHASHSEED": seed}).stdout
               for seed in ("1", "2")]
    assert printed[0] == printed[1] and len(printed[0]) == 65


DICE = """
import random, sys
sys.path.insert(0, {folder!r})
import numpy, labmouse
from rich_mouse import Dicer
random.seed({seed}), numpy.random.seed({seed})
if __name__ == "__main__":
    print(labmouse.race(Dicer, ["contest-01", "contest-02"], jobs={jobs}, runs=3).to_csv(), end="")
"""


def test_random_numbers_and_the_order_of_sets_follow_the_seed_of_the_contest():
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
        assert record.figures["search_steps"] == row.search_steps
        assert len(record.steps) > 10
    assert len({labmouse.run(Dicer, "contest-01", seed=seed).steps.tobytes() for seed in (1, 2, 3)}) == 3
