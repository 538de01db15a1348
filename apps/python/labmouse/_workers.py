"""Mice in Python on several processors: processes that hold contests, where the interpreter runs one thread at a time."""

import os
import pickle
import queue
import subprocess
import sys
import threading
import time
from typing import Any, Callable, Union

from ._native import death
from ._worker import PROGRAM

#: What labmouse._native.play gives.
Played = tuple[bytes, str, bool, float]
#: What that takes behind the maker of the mouse.
_Contest = tuple[Any, ...]

#: What is raised where a process has ended, or where its pipes are closed.
_GONE = (EOFError, OSError, ValueError, pickle.UnpicklingError)
#: What was played of a contest that was interrupted.
_INTERRUPTED: Played = b"", "", True, 0.0
#: Contests of a short race are over before a process has started: so long they are held here.
_SECONDS_ALONE = 0.5


def needed() -> bool:
    """Whether this interpreter runs one thread at a time."""
    enabled = getattr(sys, "_is_gil_enabled", None)
    return enabled is None or bool(enabled())


class _Worker:
    """A process that holds contests, one after the other."""

    def __init__(self, mice: bytes) -> None:
        # A session of its own: Ctrl-C is for the process that races.
        self.process = subprocess.Popen([sys.executable, "-c", PROGRAM], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, start_new_session=os.name == "posix")
        self.mice = mice
        self.has_mice = False

    def send(self, thing: object) -> None:
        assert self.process.stdin is not None
        pickle.dump(thing, self.process.stdin)

    def is_ready(self) -> bool:
        """Whether it has the mice; waits for it once. Some can be made where they were written alone."""
        if not self.has_mice:
            assert self.process.stdin is not None and self.process.stdout is not None
            try:
                self.send(sys.path)
                self.process.stdin.write(self.mice)
                self.process.stdin.flush()
                self.has_mice = bool(pickle.load(self.process.stdout))
            except _GONE:
                self.process.wait()
        return self.has_mice

    def play(self, mouse: int, contest: _Contest) -> Played:
        assert self.process.stdin is not None and self.process.stdout is not None
        self.send((mouse, contest))
        self.process.stdin.flush()
        played: Played = pickle.load(self.process.stdout)
        return played


class Workers:
    """The processes of one race, started when it takes long. Threads call it, one process each."""

    def __init__(self, makers: "list[object]", most: int) -> None:
        self.makers = makers
        self.most = most
        self.begin = time.monotonic()
        self.mice: Union[bytes, None] = None
        self.workers: list[_Worker] = []
        self.closed = False
        #: Of the list of workers and of `closed`; nobody who has it waits for anything.
        self.lock = threading.Lock()
        #: Processes are started one after the other.
        self.starting = threading.Lock()
        #: Processes with nothing to do; None wakes a thread that waits for one.
        self.free: queue.SimpleQueue[Union[_Worker, None]] = queue.SimpleQueue()

    def elsewhere(self, mouse: int) -> Callable[..., Union[Played, None]]:
        """What the compiled part asks before each contest of the mouse of that number."""
        return lambda *contest: self._play(mouse, contest)

    def close(self) -> None:
        """Ends the processes, whatever they do."""
        with self.lock:
            self.closed = True
            workers = list(self.workers)
            for worker in workers:
                worker.process.kill()
        self.free.put(None)
        for worker in workers:
            worker.process.wait()
            for pipe in (worker.process.stdin, worker.process.stdout):
                if pipe is not None:
                    try:
                        pipe.close()
                    except BrokenPipeError:
                        pass

    def _play(self, mouse: int, contest: _Contest) -> Union[Played, None]:
        if time.monotonic() - self.begin < _SECONDS_ALONE:
            return None
        worker = self._take()
        if worker is not None and not worker.is_ready():
            self.mice = b""
            worker = None
        if worker is None:
            self.free.put(None)  # for the next that waits
            return _INTERRUPTED if self.closed else None
        try:
            played = worker.play(mouse, contest)
        except _GONE:
            if self.closed:
                return _INTERRUPTED
            code = worker.process.wait()
            with self.lock:
                self.workers.remove(worker)
            self.free.put(None)
            return death(f"its process ended with exit code {code}")
        self.free.put(worker)
        return played

    def _take(self) -> Union[_Worker, None]:
        """A process that has nothing to do; None where there can be none."""
        while True:
            with self.starting:
                if self.mice is None and not self.closed:
                    self.mice = _pickled(self.makers)
                if self.closed or not self.mice:
                    return None
                if self.free.empty() and len(self.workers) < self.most:
                    return self._started(self.mice)
            worker = self.free.get()
            if worker is not None:
                return worker

    def _started(self, mice: bytes) -> _Worker:
        worker = _Worker(mice)
        with self.lock:
            self.workers.append(worker)
            if self.closed:
                worker.process.kill()
        return worker


def _pickled(makers: "list[object]") -> bytes:
    """The mice for other processes, also those of a notebook; nothing where they cannot leave this one."""
    import cloudpickle  # type: ignore[import-untyped,unused-ignore]

    try:
        return bytes(cloudpickle.dumps(makers))
    except Exception:  # what a user's object raises can be anything
        return b""


def _processors() -> int:
    affinity = getattr(os, "sched_getaffinity", None)
    return len(affinity(0)) if affinity is not None else os.cpu_count() or 1


def for_mice(mice: "list[tuple[str, Any, bool]]", jobs: int) -> Union[Workers, None]:
    """Processes for these mice; None where they are all to be raced in this one."""
    if not mice or jobs == 1 or not needed():
        return None
    return Workers([maker for _, maker, _ in mice], jobs or _processors())
