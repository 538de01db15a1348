"""Mice that are written in Python."""

import sys
import textwrap

import labmouse
import numpy
import pytest

#: A mouse that explores at random, from the seed that it is told, and resets when it likes: walks of all kinds.
SOURCE = textwrap.dedent('''
    import random

    class Wanderer:
        def __init__(self, told):
            self.dice = random.Random(told.seed * 1000 + told.width)

        def decide(self, seen):
            if self.dice.random() < 0.01:
                return "reset"
            return self.dice.choice((-90, 0, 90)), self.dice.choice((-3, -2, -1, 0, 1, 2, 3)) + (seen.ahead > 5)
''')
#: The same mouse as a program.
GUEST = SOURCE + textwrap.dedent('''
    import types
    told = types.SimpleNamespace()
    while (line := input().split()) != ["begin"]:
        if line[0] == "size": told.width = int(line[1])
        if line[0] == "seed": told.seed = int(line[1])
    print("labmouse 1", flush=True)
    mouse = Wanderer(told)
    while True:
        try:
            left, ahead, right = map(int, input().split()[1:])
        except EOFError:
            break
        answer = mouse.decide(types.SimpleNamespace(left=left, ahead=ahead, right=right))
        print(answer if isinstance(answer, str) else "move %d %d" % answer, flush=True)
''')
names = {}
exec(SOURCE, names)
Wanderer = names["Wanderer"]


@pytest.mark.parametrize("maze", ["contest-01", "contest-05", "capstone-1"])
def test_its_walk_is_that_of_the_same_mouse_as_a_guest(tmp_path, maze):
    program = tmp_path / "guest.py"
    program.write_text(GUEST)
    here = labmouse.run(Wanderer, maze, seed=3)
    guest = labmouse.run(f"guest:{sys.executable} {program}", maze, seed=3)
    assert len(here.steps) > 100
    numpy.testing.assert_array_equal(here.steps, guest.steps)
    assert here.outcome == guest.outcome


def answering(answer):
    class Mouse:
        def decide(self, seen):
            return answer

    return Mouse


def test_what_it_raises_is_its_forfeit_with_the_traceback():
    class Clumsy:
        def decide(self, seen):
            raise ValueError("lost my way")

    record = labmouse.run(Clumsy, "contest-01")
    assert record.outcome == "forfeit: died"
    first, *rest = record.last_words.splitlines()
    assert "ValueError: lost my way" in first
    assert any("in decide" in line for line in rest)
    race = labmouse.race([Clumsy, "flood"], "contest-01")
    assert race.complete and race.standings["solved"].tolist() == [1, 0]


def test_what_raises_before_its_first_word_did_not_start():
    class Stillborn:
        def __init__(self):
            raise RuntimeError("no")

    assert labmouse.run(Stillborn, "contest-01").outcome == "forfeit: not started"


@pytest.mark.parametrize("answer, outcome", [
    (None, "forfeit: rubbish"), (3, "forfeit: rubbish"), ((90,), "forfeit: rubbish"), ((0, 0, 0), "forfeit: rubbish"),
    (("90", 1), "forfeit: rubbish"), ((0, 10**7), "forfeit: rubbish"), ((0, 2.5), "forfeit: rubbish"), ("restet", "forfeit: rubbish"),
    ("forfeit", "forfeit: gave up"), ("reset", "out of steps"), (("Reset", "Reset"), "out of steps"),
    ((0, 0), "out of steps"), ((numpy.int64(90), numpy.int8(1)), "out of steps"), ((45, 10**6), "out of steps"),
])
def test_every_answer_is_a_step_or_a_forfeit(answer, outcome):
    assert labmouse.run(answering(answer), "contest-01").outcome == outcome


def test_a_class_that_takes_no_briefing_and_a_function_are_mice():
    assert labmouse.run(lambda told: answering((0, told.width))(), "contest-01").outcome == "out of steps"
    assert labmouse.run({"still": answering((0, 0))}, "contest-01").mouse == "still"


def test_it_is_told_what_a_guest_is_told():
    told = []

    class Listener:
        def __init__(self, briefing):
            told.append(briefing)

        def decide(self, seen):
            return "forfeit"

    labmouse.run(Listener, "contest-01", seed=11, budget=77)
    (briefing,) = told
    maze = labmouse.Maze("contest-01")
    assert (briefing.width, briefing.height) == (maze.width, maze.height)
    assert (briefing.start, briefing.heading, briefing.goals) == (maze.start, maze.heading, maze.goals)
    assert (briefing.stride, briefing.budget, briefing.seed) == (3, 77, 11)


def test_it_races_as_well_in_other_processes(monkeypatch):
    import labmouse._workers

    alone = labmouse.race([Wanderer, "flood"], jobs=1)
    monkeypatch.setattr(labmouse._workers, "_SECONDS_ALONE", 0.0)
    together = labmouse.race([Wanderer, "flood"], jobs=2)
    for column in ("mouse", "maze", "seed", "outcome", "score", "exploration_steps"):
        assert alone.table[column].equals(together.table[column])


def test_a_process_that_dies_is_a_forfeit(monkeypatch):
    import os

    import labmouse._workers

    class Deadly:
        def decide(self, seen):
            os._exit(3)

    monkeypatch.setattr(labmouse._workers, "_SECONDS_ALONE", 0.0)
    race = labmouse.race([Deadly, "flood"], ["contest-01", "contest-05"], jobs=2)
    assert race.complete
    assert race.table[race.table["mouse"] == "Deadly"]["outcome"].tolist() == ["forfeit: died"] * 2


def test_an_object_is_refused_for_its_class():
    with pytest.raises(labmouse.Error):
        labmouse.race([answering((0, 0))()], "contest-01")
