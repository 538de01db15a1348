"""Races have the same numbers as the command, in every world, and can be stopped."""

import io
import json
import subprocess
import sys
from xml.etree import ElementTree

import labmouse
import pandas
import pytest

WORLDS = {
    "steps": (["ariadne,flood,random"], ["--world", "steps", "--runs", "3"], {"runs": 3}),
    "seconds": (["certify,ariadne"], ["--world", "seconds", "--robot", "half"], {"robot": "half"}),
    # The default number of runs.
    "physical": (["certify,flood"], ["--world", "physical", "--variation", "1.5"], {"variation": 1.5}),
}
MAZES = ["contest-01", "contest-05"]


def without_times(table):
    """The table without columns of measured times, which differ from race to race."""
    return table[[name for name in table.columns if "microseconds" not in name]]


@pytest.mark.parametrize("world", WORLDS)
def test_a_race_gives_the_numbers_of_the_command(command, world):
    mice, words, options = WORLDS[world]
    printed = command("race", "--mice", *mice, "--mazes", *MAZES, *words, "--format", "csv")
    race = labmouse.race(mice, MAZES, world=world, **options)
    expected = without_times(pandas.read_csv(io.StringIO(printed)))
    pandas.testing.assert_frame_equal(without_times(race.table), expected, check_dtype=False, rtol=0, atol=0)
    pandas.testing.assert_frame_equal(without_times(pandas.read_csv(io.StringIO(race.to_csv()))), expected)


def test_a_mouse_that_throws_dice_has_as_many_contests_as_in_the_command(command):
    printed = command("race", "--mice", "random,flood", "--mazes", "contest-01", "--format", "csv")
    assert len(labmouse.race("random,flood", "contest-01").table) == len(printed.splitlines()) - 1 > 10


def test_a_race_in_mms_gives_the_numbers_of_the_command(programs, command, tmp_path):
    mouse = tmp_path / "mouse.sh"
    mouse.write_text("while :; do echo moveForward; read -r answer; [ \"$answer\" = ack ] || echo turnRight; done\n")
    spec = f'mms:sh "{mouse}"'
    words = ["--world", "mms", "--line-limit", "200"]
    printed = command("race", "--mice", spec, "--mazes", *MAZES, *words, "--format", "csv")
    race = labmouse.race(spec, MAZES, world="mms", line_limit=200)
    # The last column is a measured wall-clock time.
    lines = [[line.rsplit(",", 1)[0] for line in text.splitlines()] for text in (race.to_csv(), printed)]
    assert lines[0] == lines[1]
    assert len(race.table) == len(MAZES)


def test_all_figures_of_the_table_are_numbers():
    table = labmouse.race("flood,random", MAZES, runs=2).table
    words = ["mouse", "maze", "outcome"]
    assert [name for name in table.columns if not pandas.api.types.is_numeric_dtype(table[name])] == words


def test_standings_and_comparison_are_those_of_the_command(command):
    words = ["race", "--mazes", *MAZES, "--format", "json", "--mice"]
    both = json.loads(command(*words, "flood,certify"))
    race = labmouse.race("flood,certify", MAZES)
    assert race.standings["name"].tolist() == [mouse["name"] for mouse in both["groups"][0]["mice"]]
    assert race.standings["mean_score"].tolist() == [mouse["mean_score"] for mouse in both["groups"][0]["mice"]]
    assert race.mazes["bound"].tolist() == [maze["bound"] for maze in both["groups"][0]["mazes"]]
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


def test_a_setting_that_is_true_is_a_flag_of_the_command(programs, tmp_path):
    mouse = tmp_path / "mouse.sh"
    mouse.write_text("echo nonsense; echo moveForward; read -r answer\n")
    strict = [labmouse.race(f'mms:sh "{mouse}"', "contest-01", world="mms", strict=value).table["outcome"][0] for value in (True, False)]
    assert "invalid" in strict[0] and "invalid" not in strict[1]


def test_mazes_and_paths_race_together(tmp_path):
    made = labmouse.generate("wilson", seed=1)
    labmouse.generate("wilson", seed=2).save(tmp_path / "two.txt")
    race = labmouse.race("flood", [made, "contest-01", tmp_path])
    assert sorted(race.table["maze"]) == sorted([made.name, "contest-01", str(tmp_path / "two.txt")])


def test_a_mouse_that_throws_dice_has_several_contests():
    class Chancy:
        uses_chance = True

        def decide(self, seen):
            return "forfeit"

    class Certain(Chancy):
        uses_chance = False

    table = labmouse.race([Chancy, Certain], MAZES, runs=3).table
    assert table["mouse"].value_counts().to_dict() == {"Chancy": 6, "Certain": 2}
    assert table[table["mouse"] == "Chancy"]["seed"].nunique() == 6


def test_a_dictionary_names_its_mice():
    assert labmouse.race({"mine": "flood", "other": "certify"}, MAZES).mice == ["mine", "other"]


def test_what_is_saved_is_what_is_given(tmp_path):
    race = labmouse.race("flood", MAZES)
    assert race.to_csv(tmp_path / "race.csv") is None and race.to_json(tmp_path / "race.json") is None
    assert (tmp_path / "race.csv").read_text() == race.to_csv()
    assert (tmp_path / "race.json").read_text() == race.to_json()
    with pytest.raises(labmouse.Error):
        race.to_csv(tmp_path)


def test_a_notebook_shows_the_leaderboard():
    class Idle:
        def decide(self, seen):
            return "forfeit"

    race = labmouse.race({"<b>mine": Idle, "flood": "flood"}, MAZES)
    shown = ElementTree.fromstring(f"<div>{race._repr_html_()}</div>")
    first, *rows = [["".join(cell.itertext()) for cell in row] for row in shown.iter("tr")]
    assert [row[0] for row in rows] == ["flood", "<b>mine"]
    assert {len(row) for row in rows} == {len(first)}
    assert [row[1:] for row in rows] == [line.split()[-len(row) + 1:] for row in rows for line in str(race).splitlines()
                                         if line.startswith(row[0])]
    for part in str(race).split("\n\n")[0], *str(race).splitlines()[-3:]:  # the lines above and below the table
        assert part in "".join(shown.itertext())


def test_a_verdict_is_that_of_the_command():
    few = labmouse.race("flood,random", MAZES, runs=2).compare("random", "flood")
    assert few.mazes < 8 and few.verdict == "too few mazes" and few.finish_rate is None
    many = labmouse.race("oracle,flood").compare("oracle", "flood")
    assert many.mazes >= 8 and many.verdict == "better" and many.p < 0.05 and many.high < 0


def test_where_failures_have_no_score_they_count_the_limit():
    found = labmouse.race("flood,certify", world="failures", variation="bad-day", runs=1).compare("flood", "certify")
    assert found.low <= found.mean <= found.high
    rate = found.finish_rate
    assert rate.low <= rate.mean <= rate.high and rate.verdict in ("better", "worse", "no difference shown")


@pytest.mark.parametrize("progress", [True, False, None])
def test_a_bar_is_shown_where_it_is_asked_for(progress, capfd):
    labmouse.race("random", runs=30, progress=progress)
    assert ("%" in capfd.readouterr().err) == (progress is True)


def test_a_race_leaves_the_folder_of_the_command(command, tmp_path):
    here, there = tmp_path / "here", tmp_path / "there"
    race = labmouse.race("flood,random", MAZES, runs=2, out=here)
    command("race", "--mice", "flood,random", "--mazes", *MAZES, "--runs", "2", "--out", str(there))
    files = sorted(path.relative_to(here) for path in here.rglob("*") if path.is_file())
    assert files == sorted(path.relative_to(there) for path in there.rglob("*") if path.is_file())
    for file in files:
        if file.suffix in (".jsonl", ".svg"):
            assert (here / file).read_bytes() == (there / file).read_bytes()
    assert json.loads(next(here.glob("*.json")).read_text()) == json.loads(race.to_json())
    with pytest.raises(labmouse.Error):
        labmouse.race("flood", MAZES, out=here)
    labmouse.race("flood", MAZES, out=here, overwrite=True)
    assert not (here / "random").exists()


def test_a_folder_that_cannot_be_made_is_an_error(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(labmouse.Error):
        labmouse.race("flood", MAZES, out=tmp_path / "file" / "folder")


def test_results_do_not_depend_on_threads():
    tables = [without_times(labmouse.race("random,flood", MAZES, runs=4, jobs=jobs).table) for jobs in (1, 2)]
    pandas.testing.assert_frame_equal(*tables)


STOPPED = """
import math, os, signal, sys, threading, time
import labmouse
class Slow:
    def decide(self, seen):
        return 0, sum(range(300)) * 0  # slow enough to be interrupted
class Asleep:
    def decide(self, seen):
        time.sleep(1000)
class Lost:  # never answers, and hears of nothing that it is told once
    def decide(self, seen):
        while True:
            try:
                len("")  # where a loop begins its block, Python 3.11 does not catch what comes from outside
                while True: len("")
            except BaseException:
                if self.told: raise
                self.told = True
    told = False
class Unborn(Lost):
    def __init__(self):
        super().decide(None)
class Stubborn:  # whatever it is told
    def decide(self, seen):
        while True:
            try:
                time.sleep(0.001)
            except BaseException:
                pass
def interrupt():
    while time.monotonic() < begin[0] + {wait}: time.sleep(0.01)
    sent.append(time.monotonic())
    os.kill(os.getpid(), signal.SIGINT)
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell has it ignored in what runs in its background
guest = 'program:"' + sys.executable + '" -c "import time; time.sleep(1000)"'
sent, begin = [], [{begin}]
def finish(*given, finish=labmouse._progress.finish):  # called once the contests run, which takes long on a busy machine
    begin[0] = time.monotonic()
    return finish(*given)
labmouse._progress.finish = finish
threading.Thread(target=interrupt).start()
rounds = 0
try:
    while True:  # Ctrl-C ends a loop of them
        rounds += 1
        {held}
except KeyboardInterrupt as stopped:
    print(stopped.partial.complete, rounds, time.monotonic() - sent[0])
"""
RACE = "labmouse.race([{}], labmouse.mazes(), runs=5000, budget=100000, jobs={}, progress=False)"


@pytest.mark.parametrize("held", [
    RACE.format("'random'", 0), RACE.format("Slow", 1), RACE.format("Slow", 2), RACE.format("Lost", 1), RACE.format("Unborn", 1),
    RACE.format("Lost, 'random'", 2), RACE.format("Asleep, 'flood'", 2), RACE.format("Stubborn", 2),
    RACE.format("guest", 2), RACE.format("guest, Asleep", 2),
    "labmouse.race([Lost], world='physical', progress=False)",
    "labmouse.run(Lost, 'contest-01')", "labmouse.run(Asleep, 'contest-01', world='seconds')",
    "labmouse.run(Lost, 'contest-01', debug=True)", "labmouse.run(Asleep, 'contest-01', debug=True)",
    "labmouse.run(Unborn, 'contest-01', world='seconds', debug=True)", "labmouse.run(Stubborn, 'contest-01', world='seconds', debug=True)",
    "labmouse.run(Asleep, 'contest-01', world='failures', debug=True)", "labmouse.run(guest, 'contest-01')",
    "labmouse.study([Lost, 'flood'], labmouse.mazes()[:4], folds=2, progress=False)",
])
def test_ctrl_c_is_raised_at_once_with_what_is_done(request, held):
    wait = 1.0
    if "guest" in held:
        request.getfixturevalue("programs")
        wait = 3.0  # before the race, a busy machine takes long to try an external mouse
    begin = "time.monotonic()" if "labmouse.run(" in held else "math.inf"
    ran = subprocess.run([sys.executable, "-c", STOPPED.format(held=held, wait=wait, begin=begin)], capture_output=True, text=True, timeout=60, check=False)
    assert ran.returncode == 0, ran.stderr
    complete, rounds, seconds = ran.stdout.split()
    assert (complete, rounds) == ("False", "1"), ran.stderr
    assert float(seconds) < 5  # 0.2 s on an idle machine: bench/python.py measures it


PARTIAL = """
import csv, io, json, os, signal, threading, time
import labmouse
signal.signal(signal.SIGINT, signal.default_int_handler)
class Late:
    def __init__(self, told):
        self.told = told
    def decide(self, seen):
        if self.told.goals == late:
            os.kill(os.getppid(), signal.SIGINT)
            time.sleep(1000)
        return "forfeit"
late = labmouse.Maze("contest-05").with_goals([(1, 2)]).goals
mazes = [labmouse.Maze("contest-01"), labmouse.Maze("contest-05").with_goals([(1, 2)])]
try:
    labmouse.race({'a, "b"': Late}, mazes, jobs=1)
except labmouse.Interrupted as stopped:
    race, said = stopped.partial, str(stopped)
header, *lines = csv.reader(io.StringIO(race.to_csv()))
print(json.dumps([said, race.complete, race.table["stopped"].tolist(), len(lines), lines[0][0], header[-1], lines[0][-1],
                  json.loads(race.to_json())["stopped"]]))
"""


def test_a_part_of_a_race_is_marked_as_that():
    ran = subprocess.run([sys.executable, "-c", PARTIAL], capture_output=True, text=True, timeout=60, check=False)
    assert ran.returncode == 0, ran.stderr
    said, *marks = json.loads(ran.stdout)
    assert "partial" in said and marks == [False, [True], 1, 'a, "b"', "stopped", "true", True]
    assert "stopped" not in labmouse.race("flood", MAZES).to_csv()


def test_importing_is_light():
    ran = subprocess.run([sys.executable, "-c", "import sys, labmouse; print([name for name in ('numpy', 'pandas') if name in sys.modules])"],
                         capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == "[]"


class Straight:
    def decide(self, seen: labmouse.Sighting) -> labmouse.Action:
        return (0, 3) if seen.ahead else (90, 0)


def test_a_store_remembers(tmp_path):
    store = tmp_path / "results.db"
    mice = {"flood": "flood", "straight": Straight}
    first = labmouse.race(mice, MAZES, store=store)
    second = labmouse.race(mice, MAZES, store=store)
    assert first.from_store == 0
    assert second.from_store == len(second.table) == 2 * len(second.mazes)
    assert second.to_json() == first.to_json()
    assert labmouse.race("certify", MAZES, store=store).from_store == 0
    labelled = labmouse.race({"straight": Straight}, MAZES, store=store, label="v1")
    assert labelled.from_store == 0
    studied = labmouse.study(["flood", "certify"], MAZES, folds=2, store=store)
    assert studied.from_store > 0


def test_a_bad_store_is_an_error(tmp_path):
    (tmp_path / "text.db").write_text("no store" * 1000)
    for path in (tmp_path / "text.db", tmp_path, tmp_path / "missing" / "results.db"):
        with pytest.raises(labmouse.Error, match="error"):
            labmouse.race("flood", MAZES, store=path)


@pytest.mark.parametrize("name", ["flood,a", "flood:stride=1", "a=b", "program:x", "mice-file:mice.toml", "flood", " ", "größte Maus", "'"])
def test_a_name_is_a_name_and_no_part_of_a_spec(name):
    race = labmouse.race({name: "certify"}, MAZES)
    assert race.mice == [name] and race.standings["name"].tolist() == [name]
    assert race.table["score"].tolist() == labmouse.race("certify", MAZES).table["score"].tolist()
    own = labmouse.race({name: Straight, "other": "flood"}, MAZES)
    assert sorted(own.mice) == sorted([name, "other"])
    assert name in labmouse.run({name: Straight}, MAZES[0]).mouse


@pytest.mark.parametrize("mice", [{"a": "flood,certify"}, {"": "flood"}, {"": Straight}, {"a\nb": "flood"}, {"a\nb": Straight},
                                  {"a": "mice-file:none.toml"}])
def test_a_name_for_no_mouse_or_for_two_is_refused(mice):
    with pytest.raises(labmouse.Error, match="^[^\n]*$"):
        labmouse.race(mice, MAZES)
