"""Races on a real cluster of processes: the same results as without, and nothing lost when parts of it are killed."""

import os
import random
import signal
import socket
import sqlite3
import subprocess
import sys
import threading
import time
from pathlib import Path

import labmouse
import pytest

distributed = pytest.importorskip("distributed")
cluster = pytest.importorskip("labmouse.cluster")
KILLS = 200 if "LABMOUSE_PROOF" in os.environ else 10
MICE = ["flood", "random", "certify"]
MAZES = ["contest-01", "contest-02", "contest-05"]


class Turner:
    """Goes ahead where it can."""

    uses_chance = True

    def decide(self, seen):
        return (0, 1) if seen.ahead else (90, 0)


@pytest.fixture(scope="module")
def client():
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as local:
        with distributed.Client(local) as client:
            yield client


def results(race):
    return race.table.drop(columns="microseconds_per_decision")


def kept(store):
    """Contests of a store, as another program sees them; each can be there once only."""
    reading = sqlite3.connect(store, timeout=60)
    try:
        return reading.execute("SELECT count(*) FROM contests").fetchone()[0]
    finally:
        reading.close()


def test_a_race_is_that_of_one_machine(client, tmp_path):
    for mice in (MICE, {"turner": Turner, "other": "flood:stride=1"}):
        alone = labmouse.race(mice, runs=3)
        spread = cluster.race(client, mice, runs=3, store=tmp_path / "a.db", label="v1")
        again = cluster.race(client, mice, runs=3, store=tmp_path / "a.db", label="v1")
        assert results(spread).equals(results(alone)) and results(again).equals(results(alone))
        assert spread.complete and again.from_store == len(alone.table)
    more = cluster.race(client, [*MICE, "manhattan"], runs=3, store=tmp_path / "a.db")
    assert more.from_store == len(more.table) - len(more.mazes)
    assert labmouse.race(MICE, runs=3, store=tmp_path / "a.db").from_store == len(more.table) - len(more.mazes)


def test_a_study_and_a_sweep_are_those_of_one_machine(client, tmp_path):
    mazes = labmouse.mazes()[:6]
    alone = labmouse.study("flood,random,ariadne", mazes, folds=2, runs=3)
    spread = cluster.study(client, "flood,random,ariadne", mazes, folds=2, runs=3, store=tmp_path / "a.db")
    assert spread.complete and spread.table.equals(alone.table) and spread.comparisons.equals(alone.comparisons)
    assert cluster.study(client, "flood,random", mazes, folds=2, runs=3, store=tmp_path / "a.db").from_store == 24
    swept = cluster.sweep(client, "flood", {"stride": [1, 2]}, mazes, store=tmp_path / "a.db")
    assert results(swept).equals(results(labmouse.race(["flood:stride=1", "flood:stride=2"], mazes)))


def test_what_is_wrong_is_said_before_anything_is_sent(client, tmp_path):
    with pytest.raises(labmouse.Error, match="flod"):
        cluster.race(client, "flod", store=tmp_path / "a.db")
    (tmp_path / "text.db").write_text("no store" * 1000)
    with pytest.raises(labmouse.Error, match="text.db"):
        cluster.race(client, "flood", store=tmp_path / "text.db")


class Deadly:
    """Takes its process with it."""

    def decide(self, seen):
        os._exit(1)


def test_a_mouse_that_kills_workers_is_named(client, tmp_path):
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as local:
        with distributed.Client(local) as other, distributed.Client(local) as _:
            other.run_on_scheduler(lambda dask_scheduler: setattr(dask_scheduler, "allowed_failures", 0))
            with pytest.raises(labmouse.Error, match="deadly"):
                cluster.race(other, {"deadly": Deadly}, "contest-01", store=tmp_path / "a.db", label="v1")


def test_no_contest_is_lost_with_a_worker(client, tmp_path):
    order = dict(mazes=MAZES, runs=1000, seed=1)
    alone = results(labmouse.race(["random"], **order))
    moments = random.Random(20260101)
    for kill in range(KILLS):
        store = tmp_path / f"{kill}.db"
        held = []
        racing = threading.Thread(target=lambda: held.append(cluster.race(client, ["random"], store=store, **order)))
        racing.start()
        racing.join(moments.uniform(0, 0.6))
        pids = list(client.run(os.getpid).values())
        os.kill(moments.choice(pids), signal.SIGKILL)
        racing.join()
        assert held and results(held[0]).equals(alone) and kept(store) == len(alone), kill
        client.wait_for_workers(2)


CLIENT = """
import sys, distributed
from labmouse import cluster
if __name__ == "__main__":
    with distributed.Client(sys.argv[1]) as client:
        cluster.race(client, ["random"], ["contest-01", "contest-02", "contest-05"], runs=1000, seed=int(sys.argv[3]), store=sys.argv[2])
"""


def test_a_client_that_was_killed_goes_on(client, tmp_path):
    (tmp_path / "client.py").write_text(CLIENT)
    store = tmp_path / "a.db"
    moments = random.Random(20260102)
    words = [sys.executable, str(tmp_path / "client.py"), client.scheduler.address, str(store)]
    before = 0
    for kill in range(KILLS):
        racing = subprocess.Popen([*words, str(kill)])
        try:
            racing.wait(moments.uniform(0.8, 3))
        except subprocess.TimeoutExpired:
            racing.kill()
            racing.wait()
        now = kept(store) if store.exists() else 0
        assert now >= before
        before = now
    order = dict(mazes=MAZES, runs=1000, seed=KILLS - 1)
    spread = cluster.race(client, ["random"], store=store, **order)
    assert results(spread).equals(results(labmouse.race(["random"], **order)))
    assert kept(store) >= len(spread.table)


def test_a_scheduler_may_be_restarted(client, tmp_path):
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    address = f"tcp://127.0.0.1:{port}"
    scheduler = [sys.executable, "-m", "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", str(port), "--no-dashboard"]
    worker = [sys.executable, "-m", "distributed.cli.dask_worker", address, "--nthreads", "1", "--no-nanny", "--no-dashboard",
              "--local-directory", str(tmp_path)]
    running = [subprocess.Popen(scheduler), subprocess.Popen(worker)]
    try:
        with distributed.Client(address, timeout=60) as other:
            other.wait_for_workers(1)
            order = dict(mazes=MAZES, runs=2000)
            held = []
            store = tmp_path / "a.db"
            racing = threading.Thread(target=lambda: held.append(cluster.race(other, ["random"], store=store, **order)))
            racing.start()
            while racing.is_alive() and not (store.exists() and kept(store)):
                time.sleep(0.01)
            for process in running:
                process.kill()
                process.wait()
            running = [subprocess.Popen(scheduler), subprocess.Popen(worker)]
            racing.join()
            assert held and results(held[0]).equals(results(labmouse.race(["random"], **order)))
    finally:
        for process in running:
            process.kill()
            process.wait()


def test_the_script_of_the_page_holds_all_parts(tmp_path, command, monkeypatch):
    page = (Path(__file__).resolve().parents[2] / "docs" / "cluster.md").read_text(encoding="utf-8")
    (tmp_path / "race.sh").write_text(page.split("```sh\n")[1].split("```")[0])
    monkeypatch.chdir(tmp_path)
    for part in range(1, 65):
        subprocess.run(["sh", "race.sh"], check=True, env={**os.environ, "SLURM_ARRAY_TASK_ID": str(part)})
    command("store", "merge", *sorted(str(file) for file in tmp_path.glob("part-*.db")), "-o", "all.db")
    race = labmouse.race("flood,random", ["contest-01", "contest-02"], runs=100, store="all.db")
    assert race.from_store == len(race.table) == 202
    assert results(race).equals(results(labmouse.race("flood,random", ["contest-01", "contest-02"], runs=100)))
