"""Mice in Python in the worlds in seconds: they get readings, and a call when they are put back to the start."""

from pathlib import Path

import labmouse
import pytest

MAZE = labmouse.generate("wilson", seed=1)
log = []


class Feeler:
    """Follows the wall on its right, and begins again when it is put back to the start."""

    def __init__(self, told):
        self.told = told
        self.begin()

    def begin(self):
        (self.x, self.y), self.has_reset = self.told.start, False
        self.heading = ["north", "east", "south", "west"].index(self.told.heading)

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

    def carried(self, seconds):
        self.begin()


class Diarist(Feeler):
    def decide(self, seen):
        log.append(("seen", seen))
        return super().decide(seen)

    def carried(self, seconds):
        log.append(("carried", seconds))
        super().carried(seconds)

    def show(self, x, y, heading, seen):
        log.append(("shown", (x, y, heading, seen)))


def diary(world, seed, **options):
    log.clear()
    record = labmouse.run(Diarist, MAZE, world=world, seed=seed, debug=True, **options)
    return record, list(log)


@pytest.mark.parametrize("world", ["physical", "failures"])
def test_what_it_sees_depends_on_what_happens(world):
    seen, all_carried = [], []
    for seed in range(3):
        _, happened = diary(world, seed, variation=1.5)
        seen.append([what for kind, what in happened if kind == "seen"])
        carried = [seconds for kind, seconds in happened if kind == "carried"]
        assert carried == sorted(carried) and all(seconds > 0 for seconds in carried)
        all_carried += carried
    assert all_carried
    assert seen[0] != seen[1] != seen[2] != seen[0]


@pytest.mark.parametrize("world", ["seconds", "physical", "failures"])
def test_it_is_shown_what_there_is_on_the_way_on_which_it_is_driven(world):
    record, happened = diary(world, 2)
    shown = [what for kind, what in happened if kind == "shown"]
    assert record.score is not None and shown
    assert all((x, y) != MAZE.start or heading for x, y, heading, _ in shown)
    assert {type(seen) for _, _, _, seen in shown} == {labmouse.Sighting}


@pytest.mark.parametrize("world", ["seconds", "physical", "failures"])
def test_another_process_and_this_one_come_to_the_same(world):
    for seed in (1, 2):
        here, there = (labmouse.run(Feeler, MAZE, world=world, seed=seed, debug=debug) for debug in (True, False))
        assert here.text == there.text and here.outcome == there.outcome


@pytest.mark.parametrize("debug", [True, False])
def test_what_it_raises_when_it_is_carried_ends_its_contest(debug):
    class Clumsy(Feeler):
        def carried(self, seconds):
            raise ValueError("put me down")

    # Whether it crashes is chance.
    records = (labmouse.run(Clumsy, MAZE, world="failures", variation=1.5, seed=seed, debug=debug) for seed in range(1, 31))
    assert next(one.outcome for one in records if "put me down" in (one.last_words or "")) == "forfeit: ended early"


def test_a_process_that_dies_on_its_way_is_a_forfeit():
    class Deadly(Feeler):
        def decide(self, seen):
            import os

            os._exit(3)

    record = labmouse.run(Deadly, MAZE, world="failures")
    assert (record.outcome, record.last_words) == ("forfeit: ended early", "its process ended with exit code 3")


class Teller:
    """Raises an error with the time limit of its briefing."""

    def __init__(self, told):
        self.told = told

    def decide(self, seen):
        raise ValueError(f"limit {self.told.time_limit:g}")


def test_rules_that_changed_are_told_as_they_are_now(tmp_path):
    rules = tmp_path / "mine.toml"
    for limit in (200, 100):
        rules.write_text(f'source = "a test"\ntime_limit = {limit}\nruns = 5\nclock = "gate to gate"\n')
        for world in ("seconds", "physical"):
            race = labmouse.race([Teller, "certify"], MAZE, world=world, rules=rules, runs=1)
            record = labmouse.run(Teller, MAZE, world=world, rules=rules)
            assert race.complete and f"limit {limit}" in record.last_words


def test_a_robot_that_changed_drives_as_it_does_now(tmp_path):
    """A mouse in Python is driven with the present content of the robot file, in this process and in another."""
    text = (Path(__file__).resolve().parents[2] / "robots" / "classic.toml").read_text()
    robot, times = tmp_path / "mine.toml", []
    for speed in (500, 250):
        robot.write_text(text.replace("speed = 500  ", f"speed = {speed}  "))
        here, there = (labmouse.run(Feeler, MAZE, world="seconds", robot=robot, debug=debug) for debug in (True, False))
        assert here.text == there.text
        times.append(there.figures["search_us"])
    assert times[1] > 1.2 * times[0]
