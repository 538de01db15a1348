"""Races on a real cluster of processes give the same results as without, and lose nothing when parts of it are killed.

No test kills by a timer: the moment is a decision of a mouse, a line of the client or a call, by a fixed seed.
"""

import collections
import contextlib
import json
import os
import random
import select
import signal
import sqlite3
import subprocess
import sys
import tempfile
from pathlib import Path

import labmouse
import labmouse._workers
import pandas
import pytest

distributed = pytest.importorskip("distributed")
cluster = pytest.importorskip("labmouse.cluster")
KILLS = 200 if "LABMOUSE_PROOF" in os.environ else 5
MICE = ["flood", "random", "certify"]
MAZES = ["contest-01", "contest-02", "contest-05"]
SECONDS = 60

SCHEDULER = """
import asyncio, sys, distributed
async def main():
    async with distributed.Scheduler(host="127.0.0.1", port=int(sys.argv[1]), dashboard_address="127.0.0.1:0") as scheduler:
        print(scheduler.address, flush=True)
        await scheduler.finished()
asyncio.run(main())
"""
WORKER = """
import asyncio, sys, distributed, labmouse.cluster
async def main():
    async with distributed.Worker(sys.argv[1], nthreads=1, local_directory=sys.argv[2], dashboard=False) as worker:
        print(worker.address, flush=True)
        await worker.finished()
asyncio.run(main())
"""


class Processes:
    """A scheduler and workers, each a process that can be killed and started again."""

    def __init__(self, folder):
        self.folder = str(folder)
        self.environment = {**os.environ, "DASK_LOGGING__DISTRIBUTED": "warning"}
        self.all = []
        self.address = self.start(SCHEDULER, "0")

    def start(self, program, *words):
        """Starts a process and waits until it is ready. Returns the first line that it prints."""
        process = subprocess.Popen([sys.executable, "-B", "-c", program, *words], stdout=subprocess.PIPE, text=True,
                                   env=self.environment)
        self.all.append(process)
        ready, _, _ = select.select([process.stdout], [], [], SECONDS)
        assert ready, f"a process said nothing for {SECONDS} s"
        return process.stdout.readline().strip()

    def work(self, workers=1):
        for _ in range(workers):
            assert self.start(WORKER, self.address, self.folder)

    def restart_scheduler(self):
        """Restarts the scheduler at the same address. This kills its workers, too."""
        self.kill()
        assert self.start(SCHEDULER, self.address.rpartition(":")[2]) == self.address

    def reap(self, pid):
        """Waits for the end of a process that something else has killed."""
        [process] = [process for process in self.all if process.pid == pid]
        process.wait(SECONDS)
        process.stdout.close()
        self.all.remove(process)

    def kill(self):
        for process in self.all:
            process.kill()
        for process in list(self.all):
            self.reap(process.pid)


@contextlib.contextmanager
def processes(folder, workers):
    started = Processes(folder)
    try:
        started.work(workers)
        with distributed.Client(started.address, timeout=SECONDS) as client:
            if workers:
                client.wait_for_workers(workers, timeout=SECONDS)
            yield started, client
    finally:
        started.kill()


@pytest.fixture(scope="module")
def client(tmp_path_factory):
    with processes(tmp_path_factory.mktemp("workers"), 2) as (_, client):
        yield client


@pytest.fixture
def other(tmp_path):
    """A cluster that the test may kill, and its client."""
    with processes(tmp_path, 1) as both:
        yield both


def before_call(patch, number, event, owner, name, after=False):
    """Patches owner.name so that its call with this number (from 1) also calls `event`, before or after it."""
    real, calls = getattr(owner, name), []

    def call(*words, **named):
        calls.append(name)
        if len(calls) == number and not after:
            event()
        answer = real(*words, **named)
        if len(calls) == number and after:
            event()
        return answer

    patch.setattr(owner, name, call)
    return calls


def results(race):
    return race.table.drop(columns="microseconds_per_decision")


def kept(store):
    """The number of contests in a store, read by a connection of its own. The store cannot have one twice."""
    with contextlib.closing(sqlite3.connect(store, timeout=60)) as reading:
        return reading.execute("SELECT count(*) FROM contests").fetchone()[0]


class Turner:
    """Goes ahead if it can, and otherwise turns right."""

    uses_chance = True

    def decide(self, seen):
        return (0, 1) if seen.ahead else (90, 0)


class Quitter(Turner):
    """Gives up after 30 decisions."""

    left = 30

    def decide(self, seen):
        self.left -= 1
        return "forfeit" if self.left < 0 else super().decide(seen)


def test_a_race_is_that_of_one_machine(client, tmp_path):
    for mice in (MICE, {"quitter": Quitter, "other": "flood:stride=1"}):
        alone = labmouse.race(mice, runs=3)
        spread = cluster.race(client, mice, runs=3, store=tmp_path / "a.db", label="v1")
        again = cluster.race(client, mice, runs=3, store=tmp_path / "a.db", label="v1")
        assert results(spread).equals(results(alone)) and results(again).equals(results(alone))
        assert spread.complete and again.from_store == len(alone.table)
    more = cluster.race(client, [*MICE, "manhattan"], runs=3, store=tmp_path / "a.db")
    assert more.from_store == len(more.table) - len(more.mazes)
    assert labmouse.race(MICE, runs=3, store=tmp_path / "a.db").from_store == len(more.table) - len(more.mazes)


def with_steps(number):
    class Mouse:
        def __init__(self):
            self.left = number

        def decide(self, seen):
            self.left -= 1
            return "forfeit" if self.left < 0 else (0, 0)

    return Mouse


def test_another_try_is_another_mouse(client, tmp_path):
    for number in (1, 2, 1):
        race = cluster.race(client, {"mouse": with_steps(number)}, MAZES, store=tmp_path / "a.db")
        assert set(race.table["search_steps"]) == {number + 1}
    assert race.from_store == len(MAZES)


def test_the_physical_world_is_that_of_one_machine(client, tmp_path):
    options = dict(world="physical", noise=2)
    mice = {"flood": "flood", "certify": "certify", "quitter": Quitter}
    alone = labmouse.race(mice, MAZES[:2], **options)
    spread = cluster.race(client, mice, MAZES[:2], store=tmp_path / "a.db", **options)
    assert spread.complete and len(spread.table) == 18 and spread.table.equals(alone.table)
    assert labmouse.race(mice, MAZES[:2], store=tmp_path / "a.db", **options).from_store == 18


def test_a_race_in_mazes_of_both_sizes_has_one_set_of_rules(client, tmp_path):
    mazes = ["contest-01", "contest-half-01"]
    spread = cluster.race(client, "flood", mazes, world="seconds", store=tmp_path / "a.db")
    assert spread.complete and spread.table.equals(labmouse.race("flood", mazes, world="seconds").table)
    alone = cluster.race(client, "flood", mazes[1:], world="seconds", store=tmp_path / "a.db")
    assert (spread.from_store, alone.from_store) == (0, 0)  # by other rules


def test_a_study_and_a_sweep_are_those_of_one_machine(client, tmp_path):
    mazes = labmouse.mazes()[:6]
    alone = labmouse.study("flood,random,ariadne", mazes, folds=2, runs=3)
    spread = cluster.study(client, "flood,random,ariadne", mazes, folds=2, runs=3, store=tmp_path / "a.db")
    assert spread.complete and spread.table.equals(alone.table) and spread.comparisons.equals(alone.comparisons)
    assert cluster.study(client, "flood,random", mazes, folds=2, runs=3, store=tmp_path / "a.db").from_store == 24
    swept = cluster.sweep(client, "flood", {"stride": [1, 2]}, mazes, store=tmp_path / "a.db")
    assert results(swept).equals(results(labmouse.race(["flood:stride=1", "flood:stride=2"], mazes)))


def test_a_comparison_is_that_of_one_machine(client, tmp_path):
    order = {"generator": "prim", "size": 8, "loops": 0.1, "seed": 5, "most": 150}
    for number, (first, candidates) in enumerate([("certify", "frontier,random,ariadne"), ("flood", {"own": Quitter})]):
        store = tmp_path / f"{number}.db"
        alone = labmouse.compare(first, candidates, **order)
        spread = cluster.compare(client, first, candidates, store=store, **order)
        assert spread.complete and spread.data == alone.data and spread.from_store == 0
        again = labmouse.compare(first, candidates, store=store, **order)
        assert again.data == alone.data and again.from_store >= 2 * max(one["pairs"] for one in again.data["candidates"])
        assert number or {one["verdict"] for one in again.data["candidates"]} == {"worse", "undecided"}  # soon, and in no batch
    listed = labmouse.compare("certify", "flood", MAZES)
    spread = cluster.compare(client, "certify", "flood", MAZES, store=tmp_path / "listed.db")
    assert listed.data["exact"] and spread.data == listed.data
    drawn = labmouse.compare("certify", "random", MAZES, seed=2)
    assert cluster.compare(client, "certify", "random", MAZES, seed=2, store=tmp_path / "drawn.db").data == drawn.data
    with pytest.raises(labmouse.Error, match="better_by"):
        cluster.compare(client, "certify", "flood", better_by=7, store=tmp_path / "a.db")


def test_a_comparison_ends_at_ctrl_c(client, tmp_path, monkeypatch):
    before_call(monkeypatch, 1, lambda: os.kill(os.getpid(), signal.SIGINT), cluster._native, "merge_stores", after=True)
    with pytest.raises(labmouse.Interrupted) as stopped:
        cluster.compare(client, "flood", "certify", generator="prim", size=8, better_by=0.0001, most=100_000,
                        store=tmp_path / "a.db", progress=False)
    assert not stopped.value.partial.complete


def test_a_comparison_refuses_workers_with_other_mice(client, tmp_path, monkeypatch):
    monkeypatch.setattr(cluster._Spread, "_merge", lambda self, parts: self.came.update(one for picked, _ in parts for one in picked))
    with pytest.raises(labmouse.Error, match="a.db"):
        cluster.compare(client, "flood", "certify", generator="prim", size=8, store=tmp_path / "a.db", progress=False)


ROBOT = """
class Robot(object):
    def __init__(self, dim):
        self.moves = 0
    def next_move(self, sensors):
        self.moves += 1
        return (0, 1) if sensors[1] else (90, 1) if sensors[2] else (-90, 1)
"""


@pytest.fixture
def season(tmp_path, command, programs):
    """Makes a season with an entry of each kind in a new folder, the same each time."""
    (tmp_path / "seed.txt").write_text("wet chalk and 41 lemons\n")
    for name, mouse in (("mine", 'mouse = "flood:stride=1"'), ("robot", 'capstone = "robot.py"')):
        (tmp_path / name).mkdir()
        (tmp_path / name / "robot.py").write_text(ROBOT)
        (tmp_path / name / "entry.toml").write_text(f'authors = ["Ada"]\nlicence = "MIT"\n[[mouse]]\nname = "{name}"\n{mouse}\n')

    def make(name):
        folder = tmp_path / name
        command("league", "init", str(folder), "--practice", "parallel-8,spiral-9", "--examination", "6", "--kind", "prim", "--side", "8",
                "--seed-file", str(tmp_path / "seed.txt"))
        for entry in ("mine", "robot"):
            command("league", "add", str(folder), str(tmp_path / entry), "--no-check", "--sandbox", "off")
        return folder

    return make


@pytest.fixture
def site_of(tmp_path, command):
    """Publishes a season; the contents of its files by their names."""
    page = tmp_path / "page.html"
    page.write_text("<!doctype html><html><head><title>labmouse</title></head><body><!-- labmouse:report --></body></html>\n")

    def publish(folder):
        site = tmp_path / f"{folder.name}-site"
        command("league", "publish", str(folder), "-o", str(site), "--page", str(page), "--sandbox", "off", "--reveal")
        return {file.name: file.read_bytes() for file in site.iterdir()}

    return publish


def test_a_season_is_that_of_one_machine(client, season, site_of):
    alone, spread = season("alone"), season("spread")
    expected = site_of(alone)
    held = cluster.league(client, spread, sandbox=False)
    assert held.complete and held.from_store == 0
    # The seed is not revealed here, so there are no single contests of the examination.
    revealed = json.loads(expected["results.json"])["mice"]
    assert held.data["mice"] == [{key: mouse[key] for key in mouse if key != "examination"} for mouse in revealed]
    assert list(held.table["rank"]) == [mouse["rank"] for mouse in held.data["mice"]]
    assert all(mouse["name"] in str(held) for mouse in held.data["mice"])
    records = {file.name: file.stat().st_mtime_ns for file in (spread / "records").iterdir()}
    contests = kept(spread / "results.db")
    assert len(records) == contests == 8 * len(held.data["mice"])
    assert site_of(spread) == expected
    # Publishing ran none of them again.
    assert {file.name: file.stat().st_mtime_ns for file in (spread / "records").iterdir()} == records
    assert cluster.league(client, spread, sandbox=False).from_store == contests


@pytest.mark.parametrize("after", [False, True])
def test_a_season_goes_on_anywhere_after_ctrl_c(client, season, site_of, monkeypatch, after):
    alone, spread = season("alone"), season("spread")
    with monkeypatch.context() as patch:
        before_call(patch, 1, lambda: os.kill(os.getpid(), signal.SIGINT), cluster._native, "merge_stores", after=after)
        with pytest.raises(labmouse.Interrupted) as stopped:
            cluster.league(client, spread, sandbox=False, progress=False)
    assert not stopped.value.partial.complete and stopped.value.partial.data == {}
    assert site_of(spread) == site_of(alone)


def test_a_season_with_another_seed_is_refused(client, season, tmp_path):
    folder = season("spring")
    (tmp_path / "other.txt").write_text("dry chalk and 42 lemons\n")
    for named, says in ((dict(seed_file=tmp_path / "other.txt"), "other.txt"), (dict(seed_file=tmp_path / "none.txt"), "none.txt")):
        with pytest.raises(labmouse.Error, match=says):
            cluster.league(client, folder, sandbox=False, **named)
    with pytest.raises(labmouse.Error, match="season.toml"):
        cluster.league(client, tmp_path / "nowhere", sandbox=False)
    assert "wet chalk" not in repr(cluster._Season([], [], "", ("", {}), 1, str(folder), "wet chalk and 41 lemons", False))


def test_a_sweep_races_all_combinations_of_two_parameters(client, tmp_path):
    mazes, values = MAZES[:2], [(bias, join) for bias in (1, 2.5) for join in (True, False)]
    swept = cluster.sweep(client, "two-way", {"bias": [1, 2.5], "join_legs": (True, False)}, mazes, store=tmp_path / "a.db")
    mice = [f"two-way:bias={bias}:join_legs={'yes' if join else 'no'}" for bias, join in values]
    alone = labmouse.race(mice, mazes)
    columns = ["maze", "score", "outcome"]
    assert len(swept.mice) == 4 and len(swept.table) == 8
    assert [swept.table[swept.table["mouse"] == mouse][columns].values.tolist() for mouse in swept.mice] == [
        alone.table[alone.table["mouse"] == mouse][columns].values.tolist() for mouse in alone.mice]
    assert swept.table["score"].nunique() > 2
    with pytest.raises(labmouse.Error, match="^[^\n]*bias[^\n]*$"):
        cluster.sweep(client, "two-way", {"bias": 3}, mazes, store=tmp_path / "a.db")


def test_what_the_store_has_is_preferred(client, tmp_path):
    store = tmp_path / "a.db"
    cluster.race(client, "flood", MAZES[:2], store=store)
    with contextlib.closing(sqlite3.connect(store, timeout=60)) as changing, changing:
        changing.execute("UPDATE contests SET outcome = 'as it was kept'")
    again = cluster.race(client, "flood,certify", MAZES, store=store)
    kept_before = again.table[again.table["outcome"] == "as it was kept"]
    assert again.from_store == len(kept_before) == 2 and len(again.table) == 6
    assert set(kept_before["mouse"]) == {"flood"}


@contextlib.contextmanager
def another_user():
    """A context without the right to write to our files, even if the tests run as root."""
    if os.geteuid() == 0:
        os.seteuid(65534)
    try:
        yield
    finally:
        if os.getuid() == 0:
            os.seteuid(0)


def test_a_store_that_cannot_be_written_is_refused_before_anything_is_sent(client, monkeypatch):
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        store = Path(folder, "a.db")
        cluster.race(client, "flood", "contest-01", store=store)
        store.chmod(0o444)
        os.chmod(folder, 0o555)
        sent = []
        monkeypatch.setattr(client, "submit", lambda *words, **named: sent.append(words))
        with another_user(), pytest.raises(labmouse.Error, match="^[^\n]*a.db: error: cannot be written[^\n]*$"):
            cluster.race(client, "flood,certify", "contest-01", store=store)
        assert sent == []
        os.chmod(folder, 0o755)
        assert kept(store) == 1


def test_what_is_wrong_is_said_before_anything_is_sent(client, tmp_path):
    with pytest.raises(labmouse.Error, match="flod"):
        cluster.race(client, "flod", store=tmp_path / "a.db")
    (tmp_path / "text.db").write_text("no store" * 1000)
    with pytest.raises(labmouse.Error, match="text.db"):
        cluster.race(client, "flood", store=tmp_path / "text.db")
    for options in ({"runs": 0}, {"seed": -1}, {"store": 3}):
        with pytest.raises(labmouse.Error, match=next(iter(options))):
            cluster.race(client, "flood", **{"store": tmp_path / "a.db", **options})
    with pytest.raises(labmouse.Error, match="client"):
        cluster.race(None, "flood", store=tmp_path / "a.db")
    assert not (tmp_path / "a.db").exists()


class Deadly:
    """Ends its own process."""

    def decide(self, seen):
        os._exit(1)


class Murderer:
    """Kills the worker, which is the parent of its process."""

    def decide(self, seen):
        os.kill(os.getppid(), signal.SIGKILL)
        return 0, 0


def test_a_mouse_whose_process_dies_has_the_result_of_one_machine(client, tmp_path):
    spread = cluster.race(client, {"deadly": Deadly}, "contest-01", store=tmp_path / "a.db", label="v1")
    assert results(spread).equals(results(labmouse.race({"deadly": Deadly}, "contest-01")))
    assert spread.table["outcome"].tolist() == ["forfeit: ended early"]


def test_a_mouse_that_kills_workers_is_named(other, tmp_path):
    started, client = other
    started.work()
    client.run_on_scheduler(lambda dask_scheduler: setattr(dask_scheduler, "allowed_failures", 0))
    with pytest.raises(labmouse.Error, match="murderer"):
        cluster.race(client, {"murderer": Murderer}, "contest-01", store=tmp_path / "a.db", label="v1")


class Victim(Turner):
    """Kills its worker at decision number `moment` in its process, once per folder."""

    def __init__(self, moment, folder):
        self.moment = moment
        self.folder = folder
        # The user's variables are reset before each contest; those of the module sys are not.
        self.decided = sys.__dict__.setdefault("decided_in_a_test", collections.Counter())

    def decide(self, seen):
        self.decided[self.folder] += 1
        killed = Path(self.folder, "killed")
        if self.decided[self.folder] == self.moment:
            # Both workers may come here at the same time; only one can make the link.
            with contextlib.suppress(FileExistsError):
                killed.symlink_to(str(os.getppid()))
                os.kill(os.getppid(), signal.SIGKILL)
        return super().decide(seen)


def victim(moment, folder):
    def made():
        return Victim(moment, folder)

    made.uses_chance = True
    return made


def test_no_contest_is_lost_with_a_worker(tmp_path):
    order = dict(mazes=["contest-01"], runs=12)
    alone = labmouse.race({"victim": Turner}, **order)
    moments = random.Random(20260101)
    with processes(tmp_path, 2) as (started, client):
        for kill in range(KILLS):
            folder = tmp_path / str(kill)
            folder.mkdir()
            # One of the two workers runs at least 6 of the 12 contests, with 1000 decisions each, in a process for each
            # hash order.
            moment = moments.randint(1, 6000 // labmouse._workers.HASH_ORDERS)
            mice = {"victim": victim(moment, str(folder))}
            spread = cluster.race(client, mice, store=folder / "a.db", label="v1", **order)
            pandas.testing.assert_frame_equal(results(spread), results(alone), obj=f"the race of moment {moment}")
            assert kept(folder / "a.db") == len(alone.table), moment
            started.reap(int(os.readlink(folder / "killed")))
            started.work()
            client.wait_for_workers(2, timeout=SECONDS)


def test_a_race_does_not_wait_for_ever_for_workers(tmp_path, monkeypatch):
    monkeypatch.setattr(cluster, "_SECONDS_FOR_AN_ANSWER", 0.5)
    order = dict(mazes=MAZES, runs=1000)
    with processes(tmp_path, 0) as (started, client):
        with pytest.raises(labmouse.Error, match="a.db.*workers"):
            cluster.race(client, "random", store=tmp_path / "a.db", patience=0.5, **order)
        started.work()
        with pytest.MonkeyPatch.context() as patch:
            worker = started.all[-1]
            before_call(patch, 1, lambda: (worker.kill(), started.reap(worker.pid)), cluster._native, "merge_stores", after=True)
            with pytest.raises(labmouse.Error, match="a.db.*workers"):
                cluster.race(client, "random", store=tmp_path / "a.db", patience=0.5, **order)
        done = kept(tmp_path / "a.db")
        assert done > 0
        started.work()
        spread = cluster.race(client, "random", store=tmp_path / "a.db", **order)
        assert spread.from_store == done and results(spread).equals(results(labmouse.race("random", **order)))


@pytest.mark.parametrize(("owner", "name"), [(cluster._native, "merge_stores"), (distributed.Client, "submit"),
                                             (distributed.Client, "nthreads"), (distributed.Future, "result")])
def test_a_scheduler_may_be_restarted(other, tmp_path, monkeypatch, owner, name):
    started, client = other
    order = dict(mazes=MAZES, runs=1000)

    def restart():
        started.restart_scheduler()
        started.work()

    calls = before_call(monkeypatch, 2, restart, owner, name)
    spread = cluster.race(client, "random", store=tmp_path / "a.db", **order)
    # The number of calls depends on the time that the race takes.
    assert len(calls) >= 2
    assert results(spread).equals(results(labmouse.race("random", **order)))
    assert kept(tmp_path / "a.db") == len(spread.table)


def test_a_race_ends_with_its_scheduler(tmp_path, monkeypatch):
    with processes(tmp_path, 1) as (started, _):
        with distributed.Client(started.address, timeout=1) as client:
            before_call(monkeypatch, 1, started.kill, cluster._native, "merge_stores", after=True)
            with pytest.raises(labmouse.Error, match="a.db.*scheduler"):
                cluster.race(client, "random", MAZES, runs=1000, store=tmp_path / "a.db")
    assert kept(tmp_path / "a.db") > 0


#: A race that prints how many contests each merge kept, and sends itself a signal at a given line or merge.
CLIENT = """
import os, signal, sys, distributed
from labmouse import cluster

signal.signal(signal.SIGINT, signal.default_int_handler)  # in the background a shell switches it off
address, store, seed, kind, moment, number = sys.argv[1:]
left = int(moment)
merge = cluster._native.merge_stores

def tell(paths, target):
    print(merge(paths, target), flush=True)
    if kind == "merge":
        count()

def count():
    global left
    left -= 1
    if left == 0:
        os.kill(os.getpid(), int(number))

def trace(frame, event, _):
    if frame.f_code.co_filename != cluster.__file__:
        return None
    if event == "line":
        count()
    return trace

cluster._native.merge_stores = tell
with distributed.Client(address) as client:
    if kind == "line":
        sys.settrace(trace)
    try:
        race = cluster.race(client, "random", ["contest-01", "contest-02", "contest-05"], runs=1000, seed=int(seed), store=store)
    except KeyboardInterrupt as stopped:
        race = stopped.partial
    sys.settrace(None)
    print(race.complete, len(race.table))
"""


def client_with(client, store, seed, kind, moment, number):
    words = [sys.executable, "-B", "-c", CLIENT, client.scheduler.address, str(store), str(seed), kind, str(moment), str(int(number))]
    return subprocess.run(words, stdout=subprocess.PIPE, text=True, timeout=4 * SECONDS, check=False)


def test_a_client_that_was_killed_goes_on(client, tmp_path):
    store = tmp_path / "a.db"
    moments = random.Random(20260102)
    before = killed = runs = 0
    while killed < KILLS:
        # Many early moments, in which the store is new.
        ran = client_with(client, store, runs // 4, "line", int(10 ** moments.uniform(0, 3.5)), signal.SIGKILL)
        runs += 1
        assert runs < 2 * KILLS
        now = kept(store) if store.exists() else 0
        # Lines of digits are counts of merges; a race that was not killed prints another line at its end.
        added = [int(line) for line in ran.stdout.splitlines() if line.isdigit()]
        assert now >= before + sum(added)
        before = now
        killed += ran.returncode == -signal.SIGKILL
    # The next merge removes the temporary files of a killed one.
    left = [path.name for path in tmp_path.iterdir() if "merging" in path.name]
    assert len(left) <= 4, left
    order = dict(mazes=MAZES, runs=1000, seed=0)
    spread = cluster.race(client, "random", store=store, **order)
    assert results(spread).equals(results(labmouse.race("random", **order)))


def test_ctrl_c_keeps_what_is_done(client, tmp_path):
    store = tmp_path / "a.db"
    ran = client_with(client, store, 1, "merge", 2, signal.SIGINT)
    added, complete = ran.stdout.splitlines()[:2], ran.stdout.splitlines()[-1]
    assert ran.returncode == 0 and complete == f"False {sum(map(int, added))}" and kept(store) == sum(map(int, added))
    spread = cluster.race(client, "random", MAZES, runs=1000, store=store)
    assert spread.complete and spread.from_store == sum(map(int, added))
