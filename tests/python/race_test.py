"""Races: the numbers of the command, in every world; and what stops them."""

import io
import json
import subprocess
import sys

import labmouse
import pandas
import pytest

WORLDS = {
    "strides": (["ariadne,flood,random"], ["--world", "strides", "--runs", "3"], {"runs": 3}),
    "seconds": (["certify,ariadne"], ["--world", "seconds", "--robot", "half"], {"robot": "half"}),
}
MAZES = ["contest-01", "contest-05"]


def without_times(table):
    """All but the columns that differ from race to race."""
    return table[[name for name in table.columns if "microseconds" not in name]]


@pytest.mark.parametrize("world", WORLDS)
def test_a_race_gives_the_numbers_of_the_command(command, world):
    mice, words, options = WORLDS[world]
    printed = command("race", "--mice", *mice, "--mazes", *MAZES, *words, "--format", "csv")
    race = labmouse.race(mice, MAZES, world=world, **options)
    expected = without_times(pandas.read_csv(io.StringIO(printed)))
    pandas.testing.assert_frame_equal(without_times(race.table), expected, check_dtype=False, rtol=0, atol=0)
    pandas.testing.assert_frame_equal(without_times(pandas.read_csv(io.StringIO(race.to_csv()))), expected)


def test_a_race_in_mms_gives_the_numbers_of_the_command(command, tmp_path):
    mouse = tmp_path / "mouse.sh"
    mouse.write_text("while :; do echo moveForward; read -r answer; [ \"$answer\" = ack ] || echo turnRight; done\n")
    spec = f"mms:sh {mouse}"
    words = ["--world", "mms", "--line-limit", "200"]
    printed = command("race", "--mice", spec, "--mazes", *MAZES, *words, "--format", "csv")
    race = labmouse.race(spec, MAZES, world="mms", line_limit=200)
    # The last column is the time by the clock.
    lines = [[line.rsplit(",", 1)[0] for line in text.splitlines()] for text in (race.to_csv(), printed)]
    assert lines[0] == lines[1]
    assert len(race.table) == len(MAZES)


def test_standings_and_comparison_are_those_of_the_command(command):
    words = ["race", "--mazes", *MAZES, "--format", "json", "--mice"]
    both = json.loads(command(*words, "flood,certify"))
    race = labmouse.race("flood,certify", MAZES)
    assert race.standings["name"].tolist() == [mouse["name"] for mouse in both["mice"]]
    assert race.standings["mean_score"].tolist() == [mouse["mean_score"] for mouse in both["mice"]]
    assert race.mazes["bound"].tolist() == [maze["bound"] for maze in both["mazes"]]
    studied = json.loads(command("study", "--mazes", *MAZES, "--folds", "2", "--format", "json", "--mice", "flood,certify"))
    (expected,) = studied["comparisons"]
    found = race.compare("certify", "flood")
    assert (found.mean, found.better, found.equal, found.worse) == tuple(
        expected[key] for key in ("mean_difference", "wins", "ties", "losses"))


@pytest.mark.parametrize("mice, options, words", [
    ("flod", {}, []),
    ("flood", {"robot": "half"}, ["--robot", "half"]),
    ("flood:stride=9", {}, []),
    ("certify", {"world": "seconds", "robot": "no-such"}, ["--world", "seconds", "--robot", "no-such"]),
])
def test_errors_are_those_of_the_command(command, mice, options, words):
    printed = command("race", "--mice", mice, "--mazes", "contest-01", *words).removeprefix("error: ").strip()
    with pytest.raises(labmouse.Error) as error:
        labmouse.race(mice, "contest-01", **options)
    assert str(error.value) == printed


@pytest.mark.parametrize("bad", [
    lambda: labmouse.race(3), lambda: labmouse.race([object()]), lambda: labmouse.race("flood", world="nowhere"),
    lambda: labmouse.race("flood", runs=0), lambda: labmouse.race("flood", jobs=-1), lambda: labmouse.race("flood", budget=0),
    lambda: labmouse.race("flood", mazes=[]), lambda: labmouse.race("flood", unheard_of=1),
    lambda: labmouse.race("flood", [labmouse.generate(seed=1).named("a"), labmouse.generate(seed=2).named("a")]),
    lambda: labmouse.run("flood,certify", "contest-01"),
])
def test_what_makes_no_race_is_refused(bad):
    with pytest.raises(labmouse.Error):
        bad()


def test_results_do_not_depend_on_threads():
    tables = [without_times(labmouse.race("random,flood", MAZES, runs=4, jobs=jobs).table) for jobs in (1, 2)]
    pandas.testing.assert_frame_equal(*tables)


STOPPED = """
import os, signal, sys, threading, time
import labmouse
class Endless:
    def decide(self, seen):
        return 0, sum(range(300)) * 0  # slow enough to be interrupted
def interrupt():
    while time.monotonic() < begin + 1.0: time.sleep(0.01)
    sent.append(time.monotonic())
    os.kill(os.getpid(), signal.SIGINT)
sent, begin = [], time.monotonic()
threading.Thread(target=interrupt).start()
race = labmouse.race({mice}, labmouse.mazes(), runs=5000, budget=100000, jobs={jobs}, progress=False)
print(race.complete, time.monotonic() - sent[0])
"""


@pytest.mark.parametrize("mice, jobs", [("'random'", 0), ("[Endless]", 1), ("[Endless]", 2)])
def test_ctrl_c_gives_what_is_done_at_once(mice, jobs):
    ran = subprocess.run([sys.executable, "-c", STOPPED.format(mice=mice, jobs=jobs)], capture_output=True, text=True, timeout=60, check=False)
    complete, seconds = ran.stdout.split()
    assert complete == "False", ran.stderr
    assert float(seconds) < 5  # 0.2 s on an idle machine: bench/python.py measures it


def test_importing_is_light():
    ran = subprocess.run([sys.executable, "-c", "import sys, labmouse; print([name for name in ('numpy', 'pandas') if name in sys.modules])"],
                         capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == "[]"
