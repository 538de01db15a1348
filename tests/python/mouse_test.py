"""Mice written in Python, in this process and in worker processes."""

import json
import sys
import textwrap

import labmouse
import numpy
import pytest

#: A mouse that moves at random by the seed of its briefing, and resets at random.
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
#: The same mouse as a program with the line protocol.
PROGRAM = SOURCE + textwrap.dedent('''
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
def test_its_walk_is_that_of_the_same_mouse_as_a_guest(programs, tmp_path, maze):
    program = tmp_path / "program.py"
    program.write_text(PROGRAM)
    here = labmouse.run(Wanderer, maze, seed=3)
    guest = labmouse.run(f'program:"{sys.executable}" "{program}"', maze, seed=3)
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
    assert record.outcome == "forfeit: ended early"
    first, *rest = record.last_words.splitlines()
    assert "ValueError: lost my way" in first
    assert any("in decide" in line for line in rest)
    race = labmouse.race([Clumsy, "flood"], "contest-01")
    assert race.complete and race.standings["finished"].tolist() == [1, 0]


def test_what_raises_before_its_first_word_did_not_start():
    class Stillborn:
        def __init__(self):
            raise RuntimeError("no")

    assert labmouse.run(Stillborn, "contest-01").outcome == "forfeit: not started"


@pytest.mark.parametrize("answer, outcome", [
    (None, "forfeit: invalid answer"), (3, "forfeit: invalid answer"), ((90,), "forfeit: invalid answer"), ((0, 0, 0), "forfeit: invalid answer"),
    (("90", 1), "forfeit: invalid answer"), ((0, 10**7), "forfeit: invalid answer"), ((0, 2.5), "forfeit: invalid answer"), ("restet", "forfeit: invalid answer"),
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

    labmouse.run(Listener, "contest-01", seed=11, budget=77, debug=True)
    (briefing,) = told
    maze = labmouse.Maze("contest-01")
    assert (briefing.width, briefing.height) == (maze.width, maze.height)
    assert (briefing.start, briefing.heading, briefing.goals) == (maze.start, maze.heading, maze.goals)
    assert (briefing.stride, briefing.budget, briefing.seed) == (3, 77, 11)
    assert (briefing.world, briefing.time_limit, briefing.sight) == ("steps", None, 64)


def test_it_is_told_what_a_mouse_in_seconds_is_told(tmp_path):
    told = []

    class Listener:
        def __init__(self, briefing):
            told.append(briefing)

        def decide(self, seen):
            told.append(seen)
            return "forfeit"

    corridor = labmouse.Maze.parse("o---o---o---o---o---o\n| S               G |\no---o---o---o---o---o\n").with_start((0, 0), "east")
    labmouse.run(Listener, corridor, world="seconds", robot="classic", rules="all-japan", seed=5, debug=True)
    briefing, seen = told
    assert (briefing.world, briefing.budget, briefing.time_limit, briefing.seed) == ("seconds", None, 300.0, 5)
    assert (briefing.start, briefing.heading, briefing.goals) == ((0, 0), "east", [(4, 0)])
    assert briefing.sight == 1 and seen.ahead == 1
    assert "5x1 from (0, 0) east" in repr(briefing)
    labmouse.run(Listener, corridor, world="physical", debug=True)
    assert (told[2].world, told[2].time_limit) == ("seconds", 300.0)


@pytest.mark.parametrize("options, columns", [
    ({}, ["outcome", "score", "search_steps"]),
    ({"budget": 50}, ["outcome", "score", "search_steps"]),
    ({"world": "seconds"}, ["outcome", "score_us", "search_us", "decisions"]),
    ({"world": "seconds", "robot": "half", "rules": "thirtieth"}, ["outcome", "score_us", "search_us", "decisions"]),
    ({"world": "physical", "runs": 1}, ["outcome", "score_us", "search_us", "position_lost", "wrong_walls"]),
])
def test_it_races_as_well_in_several_processes(options, columns):
    mazes = [labmouse.generate("wilson", seed=seed) for seed in range(5)]
    alone = labmouse.race([Wanderer, Feeler, "flood"], mazes, jobs=1, **options)
    together = labmouse.race([Wanderer, Feeler, "flood"], mazes, jobs=2, **options)
    for column in ["mouse", "maze", "seed", *columns]:
        assert alone.table[column].equals(together.table[column])


class Feeler:
    """Follows the wall on its right, resets in the goal, and gives up when asked again (in seconds, after its run)."""

    def __init__(self, told):
        self.told, (self.x, self.y) = told, told.start
        self.heading = ["north", "east", "south", "west"].index(told.heading)
        self.has_reset = False

    def decide(self, seen):
        if self.has_reset:
            return "forfeit"
        if (self.x, self.y) in self.told.goals:
            self.has_reset = True
            return "reset"
        turn = 90 if seen.right else 0 if seen.ahead else -90 if seen.left else 180
        self.heading = (self.heading + turn // 90) % 4
        self.x += (0, 1, 0, -1)[self.heading]
        self.y += (1, 0, -1, 0)[self.heading]
        return turn, 1


def test_in_seconds_it_searches_and_is_driven():
    record = labmouse.run(Feeler, labmouse.generate("wilson", seed=3), world="seconds")
    assert record.outcome == "finished" and record.score >= record.bound and record.last_words == ""
    moves = [line for line in map(json.loads, record.text.splitlines()) if "move" in line]
    assert moves and record.figures["starts"] == 2


@pytest.mark.parametrize("answer, outcome", [
    ("forfeit", "forfeit: gave up"), ("reset", "forfeit: lost"), ((180, 0), "out of time"), ((0, 64), "forfeit: lost"),
    ((0, -1), "forfeit: lost"), ((45, 1), "forfeit: lost"), (None, "forfeit: invalid answer"),
])
def test_every_answer_in_seconds_is_a_move_or_a_forfeit(answer, outcome):
    assert labmouse.run(answering(answer), "contest-01", world="seconds").outcome == outcome


def test_what_it_raises_in_seconds_is_its_forfeit_with_the_traceback():
    class Clumsy:
        def decide(self, seen):
            raise ValueError("lost my way")

    class Stillborn:
        def __init__(self):
            raise RuntimeError("no")

    record = labmouse.run(Clumsy, "contest-01", world="seconds")
    assert record.outcome == "forfeit: ended early"
    assert "ValueError: lost my way" in record.last_words.splitlines()[0] and "in decide" in record.last_words
    assert labmouse.run(Stillborn, "contest-01", world="seconds").outcome == "forfeit: not started"
    race = labmouse.race([Clumsy, "flood"], "contest-01", world="seconds")
    assert race.complete and race.standings["finished"].tolist() == [1, 0]


def test_a_class_is_no_program_for_mms():
    with pytest.raises(labmouse.Error):
        labmouse.race(Feeler, "contest-01", world="mms")


def test_mice_that_exist_here_alone_race_here(monkeypatch, tmp_path):
    """The file of the mouse's module is deleted, so that other processes cannot import it."""
    (tmp_path / "gone.py").write_text(SOURCE)
    monkeypatch.syspath_prepend(tmp_path)
    import gone

    (tmp_path / "gone.py").unlink()
    mazes = labmouse.mazes()[:6]
    race = labmouse.race({"gone": gone.Wanderer, "flood": "flood"}, mazes, jobs=2)
    alone = labmouse.race({"gone": gone.Wanderer, "flood": "flood"}, mazes, jobs=1)
    assert race.table["outcome"].equals(alone.table["outcome"])


def test_other_processes_import_from_where_this_one_does(monkeypatch, tmp_path):
    import os

    (tmp_path / "nearby.py").write_text(textwrap.dedent("""
        import os

        class Nearby:
            def decide(self, seen):
                return "forfeit" if os.environ["HERE"] == str(os.getpid()) else (0, 0)
    """))
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setenv("HERE", str(os.getpid()))
    import nearby

    table = labmouse.race([nearby.Nearby], "contest-01", jobs=2).table
    assert table["outcome"].tolist() == ["out of steps"]


def test_the_folder_that_a_race_is_held_in_does_not_matter(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    assert labmouse.race([Feeler, "flood"], "contest-01", jobs=2).complete


def test_a_process_that_dies_is_a_forfeit():
    import os

    class Deadly:
        def decide(self, seen):
            os._exit(3)

    race = labmouse.race([Deadly, "flood"], ["contest-01", "contest-05"], jobs=2)
    assert race.complete
    assert race.table[race.table["mouse"] == "Deadly"]["outcome"].tolist() == ["forfeit: ended early"] * 2
    assert labmouse.run(Deadly, "contest-01").last_words == "its process ended with exit code 3"


def test_its_record_is_the_same_in_this_process_and_in_another():
    here, there = (labmouse.run(Wanderer, "contest-05", seed=7, debug=debug) for debug in (True, False))
    assert len(there.steps) > 100 and here.text == there.text


@pytest.mark.parametrize("debug", [True, False])
def test_what_it_did_before_it_died_is_in_its_record(debug):
    class Tired:
        left = 5

        def decide(self, seen):
            self.left -= 1
            return (0, 0) if self.left else 1 / 0

    record = labmouse.run(Tired, "contest-01", debug=debug)
    assert record.outcome == "forfeit: ended early" and len(record.steps) == 5 and "ZeroDivisionError" in record.last_words


@pytest.mark.parametrize("jobs", [1, 2])
def test_the_time_of_its_decisions_is_its_own(jobs):
    class Thoughtful:
        def decide(self, seen):
            return 0, min(range(20000))  # takes more than 20 microseconds on any machine

    assert labmouse.race(Thoughtful, "contest-01", budget=20, jobs=jobs).table["microseconds_per_decision"][0] > 20


def test_the_time_of_its_decisions_is_not_that_of_the_way_to_its_process():
    table = labmouse.race(answering((0, 0)), budget=100).table
    assert table["microseconds_per_decision"].min() < 5  # a round trip between processes takes at least twice as long


def test_an_object_is_refused_for_its_class():
    with pytest.raises(labmouse.Error):
        labmouse.race([answering((0, 0))()], "contest-01")


def test_where_one_contest_is_stopped_another_goes_on():
    import threading

    from labmouse import _native
    from labmouse._mice import given

    class Waiting:
        def decide(self, seen):
            begun[self].set()
            while not goes_on.is_set():
                pass
            return "forfeit"

    class Other(Waiting):
        pass

    begun, goes_on = {}, threading.Event()

    def started(kind):
        def made():
            mouse = kind()
            begun[mouse] = begun[kind] = threading.Event()
            return mouse

        begun[kind] = threading.Event()
        running = _native.RunningContest(given({"it": made}).native(None), labmouse.Maze("contest-01"), ("", {}), 1)
        while not begun[kind].wait(0.01):
            pass
        return running

    one, other = started(Waiting), started(Other)
    one.stop()
    while not one.wait(0.05):
        one.stop()
    goes_on.set()
    assert not one.result().complete
    assert other.result().outcome == "forfeit: gave up"
