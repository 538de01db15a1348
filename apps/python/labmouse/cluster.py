"""Races, studies, sweeps, comparisons and seasons of a league on a Dask cluster: docs/how-to/clusters-and-stores.md.

Needs Dask: run `pip install -v '.[cluster]'` in the source folder of labmouse.
"""

import asyncio
import collections
import concurrent.futures
import contextlib
import dataclasses
import itertools
import math
import os
import queue
import tempfile
import time
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

from . import _native
from ._arguments import LARGEST_SEED, path, runs_given, shown, whole
from ._comparisons import Verdicts, compared, generator_of, test_of
from ._mice import AnyMouse, Given, Mice, _python, given
from ._native import Error, Maze
from ._progress import Interrupted, finish
from ._races import Race
from ._seasons import Season
from ._studies import Study
from ._workers import Workers, processors, snapshot
from ._worlds import Mazes, Setting, mazes_of, world_with

if TYPE_CHECKING:
    from distributed import Client

__all__ = ["Season", "compare", "league", "race", "study", "sweep"]

#: The name of a mouse, that of a maze, and the number of the run.
_Contest = tuple[str, str, int]
_Running = Union[_native.RunningRace, _native.RunningStudy, _native.RunningComparison, _native.RunningSeason]

#: Contests of similar duration: (name of the mouse, number of cells of the maze).
_Kind = tuple[str, int]
#: For each kind: the number of contests, and their total time in s.
_Spent = dict[_Kind, tuple[int, float]]

#: Duration of a task: long compared with the scheduler's overhead, but short, since a worker that dies loses its task.
_SECONDS_A_TASK = 1.0
#: Duration of the last tasks. They are shorter, so that all workers end at about the same time.
_SECONDS_A_LAST_TASK = 0.1
#: A task has at most this many contests of a kind while none of them was measured; later, at most this many times the
#: number of contests that were measured.
_FIRST = 4
#: Time in s that the client waits for a finished task, before it checks the cluster and submits tasks again.
_SECONDS_A_WAIT = 0.1
#: Interval at which the scheduler is asked for its workers, and timeout of an answer or of a result (a small file).
_SECONDS_BETWEEN_QUESTIONS = 1.0
_SECONDS_FOR_AN_ANSWER = 10.0


#: The one kind of all contests of a study, whose time includes the training of mice, of a comparison and of a season.
_ANY: _Kind = ("", 0)

#: What a task of a worker returns: the content of a store, other files by their names, and times.
_Held = tuple[bytes, dict[str, str], _Spent]

#: (path, contests to run if it does not have them or None for all, use). The use is "keep", "read" (runs none) or "send" (a
#: temporary file, whose content goes to the client).
_Store = tuple[str, Union[list[_Contest], None], str]


@dataclasses.dataclass(frozen=True)
class _Work:
    """A race, a study, a comparison or a season in a form that can be sent to workers, each of which runs a part of it."""

    specs: "list[tuple[str, str]]"
    own: "list[tuple[str, bytes, bool, str]]"
    """Mice in Python: (name, pickled maker, whether it is stochastic, identity in stores)."""
    label: str
    world: "tuple[str, dict[str, str]]"
    seed: int

    #: Whether each contest needs all mazes: for folds, or to draw from.
    of_all_mazes = True
    #: Whether contests may be missing that nobody knew of at the beginning.
    goes_on = False

    def expected(self) -> int:
        """The number of contests that it has at least, where it is known before."""
        return 0

    def batch(self, contest: _Contest) -> int:
        """Contests of different batches cannot be run by one task."""
        return 0

    def start(self, mice: Any, mazes: "list[Maze]", store: _Store, jobs: int) -> _Running:
        raise NotImplementedError

    def keep(self, files: "dict[str, str]") -> None:
        """Keeps the files that came from a worker with its contests."""

    def spent(self, running: Any, contests: int, seconds: float) -> _Spent:
        """The times of the contests that a task has run in so many seconds, its overhead included."""
        return {_ANY: (contests, seconds)}

    def begin(self, mazes: "list[Maze]", store: _Store, jobs: int = 0) -> "_Part":
        """Starts the contests that the store names."""
        workers = Workers([data for _, data, _, _ in self.own], jobs or processors()) if self.own else None
        own = [(name, None, uses_chance, workers.elsewhere(number), identity)
               for number, (name, _, uses_chance, identity) in enumerate(self.own) if workers is not None]
        return _Part(self.start((self.specs, own, _python(), self.label), mazes, store, jobs), workers)

    def missing(self, mazes: "list[Maze]", store: str) -> "tuple[list[_Contest], int, dict[str, str]]":
        """The contests that the store does not have, the number of those that it has, and the settings of the world."""
        with self.begin(mazes, (store, [], "keep")) as running:
            while not running.wait(0.1):
                pass
            held = running.result()
            return running.missing(), held.from_store, running.settings


@dataclasses.dataclass(frozen=True)
class _Race(_Work):
    runs: "int | None"

    of_all_mazes = False

    def start(self, mice: Any, mazes: "list[Maze]", store: _Store, jobs: int) -> _Running:
        return _native.RunningRace(mice, mazes, self.world, self.runs, self.seed, jobs, "", False, store)

    def spent(self, running: Any, contests: int, seconds: float) -> _Spent:
        # Without the overhead, which does not grow with the number of contests.
        spent: _Spent = running.spent()
        return spent


@dataclasses.dataclass(frozen=True)
class _Study(_Work):
    runs: "int | None"
    folds: int
    learning: bool

    def start(self, mice: Any, mazes: "list[Maze]", store: _Store, jobs: int) -> _Running:
        return _native.RunningStudy(mice, mazes, self.world, (self.folds, self.learning, self.runs, self.seed, jobs), store)


@dataclasses.dataclass(frozen=True)
class _Comparison(_Work):
    first_is_own: bool
    generator: "tuple[str, int, int, int]"
    test: "tuple[float, float, float, bool, int]"

    goes_on = True

    def expected(self) -> int:
        # Unless it is decided before.
        return 2 * self.test[4]

    def batch(self, contest: _Contest) -> int:
        return _native.batch_of(contest[1])

    def start(self, mice: Any, mazes: "list[Maze]", store: _Store, jobs: int) -> _Running:
        _, picked, use = store
        batch = self.batch(picked[0]) if use == "send" and picked else None
        return _native.RunningComparison(mice, self.first_is_own, mazes, self.generator, self.world, (*self.test, self.seed, jobs), store, batch)


#: The folder of the records that a worker sends, beside its store.
_RECORDS = "records"


@dataclasses.dataclass(frozen=True)
class _Season(_Work):
    folder: str
    secret: str = dataclasses.field(repr=False)
    """Dask logs the arguments of a task that fails."""
    sandbox: bool

    def start(self, mice: Any, mazes: "list[Maze]", store: _Store, jobs: int) -> _Running:
        path, _, use = store
        records = os.path.join(os.path.dirname(path), _RECORDS) if use == "send" else ""
        return _native.RunningSeason(self.folder, self.secret, _python(), self.sandbox, jobs, records, store)

    def spent(self, running: Any, contests: int, seconds: float) -> _Spent:
        return {_ANY: (contests, running.spent)}

    def keep(self, files: "dict[str, str]") -> None:
        for name, text in files.items():
            _native.write_file(os.path.join(self.folder, _RECORDS, name), text)


class _Part:
    """Running contests and their worker processes for mice in Python, which the context ends."""

    def __init__(self, running: _Running, workers: "Workers | None") -> None:
        self.running = running
        self.workers = workers

    def __enter__(self) -> _Running:
        return self.running

    def __exit__(self, *error: object) -> None:
        if self.workers is not None:
            self.workers.close()


def _hold(work: _Work, mazes: "list[Maze]", picked: "list[_Contest]") -> _Held:
    """The task of a Dask worker: runs contests. Returns the content of a store with them, their other files, and their times."""
    begin = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        store = os.path.join(folder, "part.db")
        part = work.begin(mazes, (store, picked, "send"), 1)
        with part as running:
            while not running.wait(1.0):
                pass
            running.result()
        spent = work.spent(running, len(picked), time.perf_counter() - begin)
        del running, part  # closes the store
        files = {file.name: file.read_text(encoding="utf-8") for file in Path(folder, _RECORDS).glob("*")}
        return Path(store).read_bytes(), files, spent


class _Spread:
    """Distributes contests to workers and merges their results into the store. Only this client writes to the store."""

    def __init__(self, client: "Client", work: _Work, mazes: "list[Maze]", store: str, patience: float) -> None:
        self.client: Any = client
        self.patience = patience
        self.mazes = mazes
        self.store = store
        self.by_name = {maze.name: maze for maze in mazes}
        self.cells = {maze.name: maze.width * maze.height for maze in mazes}
        self.waiting: collections.deque[_Contest] = collections.deque()
        missing, self.from_store, settings = work.missing(mazes, store)
        # A worker gets some of the mazes only, so it cannot know the defaults that depend on all of them.
        self.work = dataclasses.replace(work, world=(work.world[0], settings))
        self.done = self.from_store
        self.all = work.expected()
        self.came: set[_Contest] = set()
        self.stopped = False
        self._take(missing)
        self.remarks: list[str] = []
        self.futures: dict[Any, list[_Contest]] = {}
        self.finished: queue.SimpleQueue[Any] = queue.SimpleQueue()
        self.spent: _Spent = {}
        self.checked = False
        self.threads = 0
        self.asked = -math.inf
        self.had_workers = time.monotonic()

    def wait(self, seconds: float) -> bool:
        """Submits tasks and merges finished ones; may wait for one. Returns whether all contests are in the store."""
        if not self.futures and not self.waiting:
            if self.work.goes_on and not self.stopped:
                missing = self.work.missing(self.mazes, self.store)[0]
                if not self.came.isdisjoint(missing):
                    raise _other_contests(self.store)
                self._take(missing)
            if not self.waiting:
                return True
        self._count_threads()
        if self.client.status == "running":
            self._submit()
        ended = []
        try:
            ended.append(self.finished.get(timeout=max(seconds, _SECONDS_A_WAIT)))
            while True:
                ended.append(self.finished.get_nowait())
        except queue.Empty:
            pass
        self._merge([part for future in ended for part in self._part(future)])
        return False

    def _take(self, missing: "list[_Contest]") -> None:
        # Sorted by maze: each task computes the bounds of its mazes again.
        self.waiting.extend(sorted(missing, key=lambda contest: (contest[1], contest[0], contest[2])))
        self.all = max(self.all, self.done + len(missing))

    def stop(self) -> None:
        """Cancels all tasks that are not done."""
        from distributed.client import ClosedClientError

        self.stopped = True
        self.waiting.clear()
        with contextlib.suppress(ClosedClientError, RuntimeError):  # the client, or its thread, has ended
            self.client.cancel(list(self.futures))
        self.futures.clear()

    def _count_threads(self) -> None:
        """Counts the workers' threads. Raises Error if the scheduler is gone or has had no workers for too long."""
        again = "what was done is kept: start again to go on"
        if self.client.status in ("closed", "closing"):
            raise Error(f"{self.store}: the scheduler is gone; {again}")
        now = time.monotonic()
        if now - self.asked < _SECONDS_BETWEEN_QUESTIONS:
            return
        self.asked = now
        self.threads = 0
        # A connection that breaks now may be back at the next call.
        with contextlib.suppress(OSError, asyncio.TimeoutError):
            if self.client.status == "running":
                self.threads = sum(self.client.nthreads(callback_timeout=_SECONDS_FOR_AN_ANSWER).values())
        if self.threads > 0:
            self.had_workers = now
        elif now - self.had_workers > self.patience:
            raise Error(f"{self.store}: the cluster has had no workers for {self.patience:g} s; {again}")

    def _submit(self) -> None:
        threads = max(1, self.threads)
        while self.waiting and len(self.futures) < 2 * threads + 2:
            enough, seconds = len(self.waiting) / (2 * threads), 0.0
            picked: list[_Contest] = []
            while self.waiting and seconds < (_SECONDS_A_TASK if len(picked) < enough else _SECONDS_A_LAST_TASK):
                if picked and self.work.batch(self.waiting[0]) != self.work.batch(picked[0]):
                    break
                picked.append(self.waiting.popleft())
                seconds += self._seconds_of(picked[-1])
            self._send(picked)

    def _seconds_of(self, contest: _Contest) -> float:
        """Expected time of a contest in s. Kinds with few measurements get a high value, so that tasks stay small."""
        mouse, maze, _ = contest
        kind = _ANY if self.work.of_all_mazes else (mouse, self.cells[maze])
        number, seconds = self.spent.get(kind, (1.0, 0.0))
        return max(seconds / number, _SECONDS_A_TASK / (_FIRST * number))

    def _send(self, picked: "list[_Contest]") -> None:
        future = self.client.submit(_hold, self.work, self._mazes_of(picked), picked, pure=False)
        self._await(future, picked)

    def _mazes_of(self, picked: "list[_Contest]") -> "list[Maze]":
        """The mazes that these contests need."""
        return self.mazes if self.work.of_all_mazes else [self.by_name[name] for name in sorted({maze for _, maze, _ in picked})]

    def _await(self, future: Any, picked: "list[_Contest]") -> None:
        self.futures[future] = picked
        future.add_done_callback(self.finished.put)

    def _part(self, future: Any) -> "list[tuple[list[_Contest], bytes]]":
        """The contests of a finished task with their store; empty if the contests are run again."""
        from distributed import KilledWorker

        picked = self.futures.pop(future, None)
        if picked is None:
            return []
        try:
            data, files, spent = future.result(timeout=_SECONDS_FOR_AN_ANSWER)
        except (OSError, asyncio.TimeoutError, asyncio.CancelledError, concurrent.futures.CancelledError) as error:
            if future.status == "error":  # the task itself raised it
                raise
            if isinstance(error, asyncio.TimeoutError):
                # The worker died with the result and Dask runs the task again, or the network is slow.
                self._await(future, picked)
            else:  # the scheduler was restarted
                self.waiting.extendleft(reversed(picked))
            return []
        except KilledWorker:
            if len(picked) == 1:
                mouse, maze, run = picked[0]
                raise Error(f"mouse '{mouse}' in maze '{maze}', run {run}: all workers that held this contest died") from None
            half = len(picked) // 2
            self._send(picked[:half])
            self._send(picked[half:])
            return []
        for kind, (number, seconds) in spent.items():
            before = self.spent.get(kind, (0, 0.0))
            self.spent[kind] = (before[0] + number, before[1] + seconds)
        # Before the store has the contests: a contest that it has counts as done.
        self.work.keep(files)
        return [(picked, data)]

    def _merge(self, parts: "list[tuple[list[_Contest], bytes]]") -> None:
        if not parts:
            return
        with tempfile.TemporaryDirectory() as folder:
            paths = []
            for number, (_, data) in enumerate(parts):
                paths.append(os.path.join(folder, f"part-{number}.db"))
                Path(paths[-1]).write_bytes(data)
            _native.merge_stores(paths, self.store)
        self.done += sum(len(picked) for picked, _ in parts)
        self.came.update(contest for picked, _ in parts for contest in picked)
        if not self.checked:
            self.checked = True
            self._check([contest for picked, _ in parts for contest in picked])

    def _check(self, came: "list[_Contest]") -> None:
        """Raises Error if the workers ran other contests than this machine would: their mice have other identities."""
        if not set(came).isdisjoint(self.work.missing(self._mazes_of(came), self.store)[0]):
            raise _other_contests(self.store)


def _other_contests(store: str) -> Error:
    return Error(f"{store}: lacks contests that the workers have run: their mice were other ones than were asked for, or a machine was "
                 "too busy to judge them; give all machines the same labmouse, the same Python and the same files of external mice, "
                 "and start again")


def _parts(client: "Client", who: Given, label: "str | None", chosen: "tuple[str, dict[str, str]]", seed: int) -> "dict[str, Any]":
    """The fields that all kinds of work have."""
    if not hasattr(client, "submit"):
        raise Error(f"client is a distributed.Client, not {shown(client)}")
    seed = whole("seed", seed, 0, LARGEST_SEED)
    specs, native, _, known = who.native(None, label, True)
    own = [(name, data, uses_chance, identity)
           for (name, _, uses_chance, _, identity), data in zip(native, snapshot(who.own))]
    return {"specs": specs, "own": own, "label": known, "world": chosen, "seed": seed}


def _all_of(mazes: "Mazes | None") -> "list[Maze]":
    return mazes_of(mazes) or _native.find_mazes([])


def _spread(client: "Client", work: _Work, mazes: "list[Maze]", store: "str | os.PathLike[str]", progress: "bool | None",
            patience: float) -> "tuple[Any, int, bool]":
    """Runs the work. Returns its result, the number of contests that the store had, and whether Ctrl-C stopped it."""
    kept = path("store", store)
    spread = _Spread(client, work, mazes, kept, patience)
    try:
        stopped = finish(spread, progress)
    finally:
        spread.stop()
    # The store has all contests now or, after Ctrl-C, those that are done.
    with work.begin(mazes, (kept, None, "read")) as running:
        finish(running, False)
        held = running.result()
    if not stopped and not held.complete:
        raise _other_contests(kept)
    return held, spread.from_store, stopped


def race(
    client: "Client",
    mice: "Mice | None" = None,
    mazes: "Mazes | None" = None,
    *,
    store: "str | os.PathLike[str]",
    world: "str | None" = None,
    robot: "str | os.PathLike[str] | None" = None,
    rules: "str | os.PathLike[str] | None" = None,
    budget: "int | None" = None,
    runs: "int | None" = None,
    seed: int = 1,
    progress: "bool | None" = None,
    label: "str | None" = None,
    patience: float = 300.0,
    **settings: Setting,
) -> Race:
    """Races mice on mazes on the workers of a `distributed.Client`, with the same numbers as `labmouse.race`.

    store: file on this machine that keeps all contests; a contest that it has is not run again. So a race that was
        killed continues when it is started again.
    patience: seconds to wait while the cluster has no workers, before it raises Error.

    The other arguments are those of `labmouse.race`. All machines need the same labmouse, and the files of external mice,
    robots and rules under the same paths. Raises Error. Ctrl-C raises Interrupted, whose `partial` is the Race so far.
    """
    chosen = world_with(world, {"robot": robot, "rules": rules, "budget": budget, **settings})
    work = _Race(**_parts(client, given(mice), label, chosen, seed), runs=runs_given(runs))
    held, from_store, stopped = _spread(client, work, _all_of(mazes), store, progress, patience)
    race = Race(held, from_store)
    if stopped:
        raise Interrupted(race)
    return race


def study(
    client: "Client",
    mice: Mice,
    mazes: "Mazes | None" = None,
    *,
    store: "str | os.PathLike[str]",
    folds: int = 5,
    learning: bool = True,
    world: "str | None" = None,
    robot: "str | os.PathLike[str] | None" = None,
    rules: "str | os.PathLike[str] | None" = None,
    budget: "int | None" = None,
    runs: "int | None" = None,
    seed: int = 1,
    progress: "bool | None" = None,
    label: "str | None" = None,
    patience: float = 300.0,
    **settings: Setting,
) -> Study:
    """Compares mice on the workers of a `distributed.Client`, with the same numbers as `labmouse.study`.

    Mice that learn are trained on this machine and again in each task. `store` and `patience` are as in `race`, all
    other arguments as in `labmouse.study`. Raises Error. Ctrl-C raises Interrupted; its `partial` is the Study so far.
    """
    chosen = world_with(world, {"robot": robot, "rules": rules, "budget": budget, **settings})
    work = _Study(**_parts(client, given(mice), label, chosen, seed), runs=runs_given(runs), folds=whole("folds", folds, 2, 1_000_000),
                  learning=learning)
    held, from_store, stopped = _spread(client, work, _all_of(mazes), store, progress, patience)
    study = Study(held, from_store)
    if stopped:
        raise Interrupted(study)
    return study


def compare(
    client: "Client",
    first: AnyMouse,
    candidates: Mice,
    mazes: "Mazes | None" = None,
    *,
    store: "str | os.PathLike[str]",
    better_by: float = 0.02,
    alpha: float = 0.05,
    beta: float = 0.05,
    test: str = "bets",
    most: int = 5000,
    generator: str = "contest",
    size: "int | tuple[int, int]" = 16,
    loops: float = 0.0,
    world: "str | None" = None,
    robot: "str | os.PathLike[str] | None" = None,
    rules: "str | os.PathLike[str] | None" = None,
    budget: "int | None" = None,
    seed: int = 1,
    progress: "bool | None" = None,
    label: "str | None" = None,
    patience: float = 300.0,
    **settings: Setting,
) -> Verdicts:
    """Races mice against a first one until it is decided which is better, on the workers of a `distributed.Client`, with the
    same numbers as `labmouse.compare`.

    The workers run up to twice as many contests as the verdict needs, because they go on while it is not known. `store` and
    `patience` are as in `race`, all other arguments as in `labmouse.compare`. The result's `from_store` counts only the
    contests that the store had before the first one that it lacked. Raises Error. Ctrl-C raises Interrupted; its `partial`
    is the Verdicts so far.
    """
    chosen = world_with(world, {"robot": robot, "rules": rules, "budget": budget, **settings})
    who, first_is_own = compared(first, candidates)
    work = _Comparison(**_parts(client, who, label, chosen, seed), first_is_own=first_is_own,
                       generator=generator_of(generator, size, loops), test=test_of(better_by, alpha, beta, test, most))
    held, from_store, stopped = _spread(client, work, [] if mazes is None else _all_of(mazes), store, progress, patience)
    verdicts = Verdicts(held, from_store)
    if stopped:
        raise Interrupted(verdicts)
    return verdicts


def league(
    client: "Client",
    folder: "str | os.PathLike[str]",
    *,
    seed_file: "str | os.PathLike[str] | None" = None,
    sandbox: bool = True,
    progress: "bool | None" = None,
    patience: float = 300.0,
) -> Season:
    """Runs the contests of a season on the workers of a `distributed.Client`, with the same results as `labmouse league run`.

    folder: the folder of the season, which `labmouse league init` made and which all machines need under the same path. The
        results and records are kept there on this machine, so a season that was killed continues when it is started
        again, here or by `labmouse league run`; `labmouse league publish` writes its pages.
    seed_file: the file with the secret seed, on this machine; default: that in the folder. Workers get the seed.
    sandbox: False runs programs without a sandbox, and the results say so.

    `patience` is as in `race`. Raises Error. Ctrl-C raises Interrupted, whose `partial` is an incomplete Season.
    """
    place = os.path.abspath(path("folder", folder))
    secret = _native.season_seed(place, "" if seed_file is None else path("seed_file", seed_file))
    work = _Season(**_parts(client, Given([], []), None, ("", {}), 1), folder=place, secret=secret, sandbox=bool(sandbox))
    held, from_store, stopped = _spread(client, work, [], os.path.join(place, "results.db"), progress, patience)
    season = Season(held, from_store)
    if stopped:
        raise Interrupted(season)
    return season


def sweep(
    client: "Client",
    mouse: str,
    vary: "Mapping[str, Iterable[object]]",
    mazes: "Mazes | None" = None,
    *,
    store: "str | os.PathLike[str]",
    **options: Any,
) -> Race:
    """Races a mouse with all combinations of values of its parameters: `sweep(client, 'flood', {'stride': [1, 2]}, ...)`.

    mouse: the SPEC of one mouse. vary: a list of values for each parameter, by its name. The other arguments are those
    of `race`. Raises Error.
    """
    for name, values in vary.items():
        if isinstance(values, str) or not isinstance(values, Iterable):
            raise Error(f"vary: the values of '{name}' are a list, as in {{'{name}': [1, 2]}}, not {shown(values)}")
    grid = itertools.product(*([f"{name}={_value(value)}" for value in values] for name, values in vary.items()))
    return race(client, [":".join([mouse, *settings]) for settings in grid], mazes, store=store, **options)


def _value(value: object) -> str:
    text = str(value).lower() if isinstance(value, bool) else str(value)
    if not text or set(text) & set(":,"):
        raise Error(f"vary: {shown(value)} cannot be the value of a parameter: ':' and ',' end one in a SPEC")
    return text
