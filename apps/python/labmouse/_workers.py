"""Processes that run contests of mice in Python.

Each contest starts with the mouse, its globals and the user's modules as they were when the race began. So results do
not depend on earlier contests, on the process, or on the number of processes.
"""

import atexit
import os
import pickle
import subprocess
import sys
import threading
from functools import partial
from typing import Any, Callable, Union

from ._native import Briefing, Error
from ._worker import PROGRAM

#: Kind, rotation, movement and reason.
Decision = tuple[int, int, int, int]

#: The exceptions of a pipe whose process has ended or that is closed.
_GONE = (EOFError, OSError, ValueError, pickle.UnpicklingError)
#: Number of values of PYTHONHASHSEED, which decides the order of sets of str. The contest's seed chooses one. A process
#: has one value for its life, so each value needs its own processes.
HASH_ORDERS = 2


class _Worker:
    """A process that runs contests, one after the other."""

    def __init__(self, order: int) -> None:
        self.order = order
        self.surroundings = _surroundings()
        self.parent = os.getpid()
        # A session of its own, so that Ctrl-C reaches only the process that runs the race.
        self.process = subprocess.Popen([sys.executable, "-c", PROGRAM], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        start_new_session=os.name == "posix",
                                        env={**os.environ, "PYTHONHASHSEED": str(order)})

    def begin(self) -> None:
        """Sends sys.path. Call it once, before anything else is sent."""
        self.send(sys.path)

    def send(self, thing: object, at_once: bool = False) -> None:
        assert self.process.stdin is not None
        pickle.dump(thing, self.process.stdin)
        if at_once:
            self.process.stdin.flush()

    def ask(self, question: object) -> Any:
        assert self.process.stdout is not None
        self.send(question, True)
        return pickle.load(self.process.stdout)

    def end(self) -> None:
        self.process.kill()
        self.process.wait()
        for pipe in (self.process.stdin, self.process.stdout):
            if pipe is not None:
                try:
                    pipe.close()
                except BrokenPipeError:
                    pass


def _surroundings() -> object:
    """The surroundings a process inherits. It can serve a later race only if they are the same then."""
    try:
        folder = os.getcwd()
    except OSError:
        folder = ""
    return os.getpid(), list(sys.path), dict(os.environ), folder


class _Idle:
    """Idle processes, kept for the next race because starting one takes longer than most contests."""

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.workers: list[_Worker] = []

    def take(self, order: int) -> "_Worker | None":
        around = _surroundings()
        with self.lock:
            self.workers = [worker for worker in self.workers if worker.process.poll() is None]
            for worker in self.workers:
                if worker.order == order and worker.surroundings == around:
                    self.workers.remove(worker)
                    return worker
        return None

    def put(self, workers: "list[_Worker]", most: int) -> None:
        with self.lock:
            kept = self.workers + workers
            ended, self.workers = kept[: max(0, len(kept) - most)], kept[max(0, len(kept) - most) :]
        for worker in ended:
            worker.end()

    def end(self) -> None:
        with self.lock:
            workers, self.workers = self.workers, []
        for worker in workers:
            if worker.parent == os.getpid():
                worker.end()


_idle = _Idle()
atexit.register(_idle.end)


class Contest:
    """A contest of a mouse that decides in another process, one decision at a time."""

    def __init__(self, workers: "Workers", mouse: int, briefing: Briefing) -> None:
        self.workers = workers
        self.worker = workers.take(briefing.seed)
        #: Whether its process has died; then the last words have its exit code.
        self.died = False
        #: Last message of the mouse, and the time of all decisions in microseconds; known once the contest has ended.
        self.last_words = ""
        self.microseconds: "float | None" = None
        self.started: bool = self._asked(("begin", mouse, briefing), True)

    def decide(self, left: int, ahead: int, right: int) -> "Decision | None":
        """Returns the mouse's decision for a reading; None once its process has died or the race is stopped."""
        decision: "Decision | None" = self._asked(("decide", (left, ahead, right)), None)
        return decision

    def show(self, *seen: Any) -> None:
        """Calls Strategy.show with x, y, heading and the reading."""
        self._tell(("show", seen))

    def carried(self, microseconds: int) -> None:
        """Calls Strategy.carried."""
        self._tell(("carried", (microseconds,)))

    def end(self) -> None:
        """Ends the contest and gives the process back. Further calls do nothing."""
        ended = self._asked(("end", ()), None)
        if ended is not None and self.worker is not None:
            self.last_words, self.microseconds = ended
            self.workers.give_back(self.worker)
            self.worker = None

    def _asked(self, question: object, otherwise: Any) -> Any:
        if self.worker is None:
            return otherwise
        try:
            return self.worker.ask(question)
        except _GONE:
            self._gone(self.worker)
            return otherwise

    def _tell(self, what: object) -> None:
        if self.worker is None:
            return
        try:
            self.worker.send(what)
        except _GONE:
            self._gone(self.worker)

    def _gone(self, worker: _Worker) -> None:
        self.worker = None
        words = self.workers.died(worker)
        if words is not None:
            self.died, self.last_words = True, words


class Workers:
    """The worker processes of one race. Thread-safe; each thread uses one process at a time."""

    def __init__(self, mice: "list[bytes]", most: int) -> None:
        self.mice = mice
        self.most = most
        self.closed = False
        #: Protects the lists and `closed`. Never held during a blocking call.
        self.lock = threading.Lock()
        self.busy: list[_Worker] = []
        self.free: list[_Worker] = []

    def elsewhere(self, mouse: int) -> "Callable[[Briefing], Contest]":
        """The callable that the compiled part calls for each contest of the mouse with this index."""
        return partial(Contest, self, mouse)

    def close(self) -> None:
        """Kills the busy processes, and keeps the free ones for the next race."""
        with self.lock:
            self.closed = True
            busy, free = list(self.busy), self.free
            self.free = []
            for worker in busy:
                worker.process.kill()
        _idle.put(free, self.most * HASH_ORDERS)

    def take(self, seed: int) -> "_Worker | None":
        """A free process that has received the mice; None once the race is stopped."""
        order = seed % HASH_ORDERS
        with self.lock:
            if self.closed:
                return None
            worker = next((worker for worker in self.free if worker.order == order), None)
            if worker is not None:
                self.free.remove(worker)
                self.busy.append(worker)
                return worker
        worker = _idle.take(order)
        is_new = worker is None
        worker = worker or _Worker(order)
        with self.lock:
            self.busy.append(worker)
            if self.closed:
                worker.process.kill()
        try:
            if is_new:
                worker.begin()
            worker.send(("mice", self.mice))
        except _GONE:  # the next request reports it
            pass
        return worker

    def give_back(self, worker: _Worker) -> None:
        """Marks a process as free after its contest; ends it if the race is stopped."""
        with self.lock:
            self.busy.remove(worker)
            if not self.closed:
                self.free.append(worker)
                return
        worker.end()

    def died(self, worker: _Worker) -> "str | None":
        """Removes a dead process. Returns why it died, or None if the race was stopped."""
        with self.lock:
            self.busy.remove(worker)
            closed = self.closed
        worker.end() if closed else worker.process.wait()
        return None if closed else f"its process ended with exit code {worker.process.returncode}"


def processors() -> int:
    """The number of processors that this process may use."""
    affinity = getattr(os, "sched_getaffinity", None)
    return len(affinity(0)) if affinity is not None else os.cpu_count() or 1


def snapshot(mice: "list[tuple[str, Any, bool]]") -> "list[bytes]":
    """Pickles the makers of mice with their present state. Raises Error if one cannot be pickled."""
    from ._by_value import dumps

    found = []
    for name, maker, _ in mice:
        try:
            found.append(dumps(maker))
        except Exception as error:  # what a user's object raises can be anything
            raise Error(f"mouse '{name}' cannot be sent to another process ({' '.join(str(error).split())}); "
                        "make what it holds in its __init__, once a contest") from None
    return found


def for_mice(mice: "list[tuple[str, Any, bool]]", jobs: int) -> Union[Workers, None]:
    """The worker processes for a race of these mice with `jobs` threads (0: one per processor); None without mice."""
    return Workers(snapshot(mice), jobs or processors()) if mice else None
