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
Played = tuple[bytes, str, bool]
#: What that takes behind the maker of the mouse.
_Contest = tuple[Any, ...]

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
        self.has_mice = False
        self.send(sys.path)
        assert self.process.stdin is not None
        self.process.stdin.write(mice)

    def send(self, thing: object) -> None:
        assert self.process.stdin is not None
        pickle.dump(thing, self.process.stdin)

    def is_ready(self) -> bool:
        """Whether it has the mice; waits for it once. Some can be made where they were written alone."""
        if not self.has_mice:
            assert self.process.stdin is not None and self.process.stdout is not None
            try:
                self.process.stdin.flush()
                self.has_mice = bool(pickle.load(self.process.stdout))
            except (EOFError, OSError, pickle.UnpicklingError):
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
        self.lock = threading.Lock()
        self.mice: Union[bytes, None] = None
        self.workers: list[_Worker] = []
        #: Processes with nothing to do; None wakes a thread that waits for one.
        self.free: queue.SimpleQueue[Union[_Worker, None]] = queue.SimpleQueue()
        self.closed = False

    def elsewhere(self, mouse: int) -> Callable[..., Union[Played, None]]:
        """What the compiled part asks before each contest of the mouse of that number."""
        return lambda *contest: self._play(mouse, contest)

    def close(self) -> None:
        """Ends the processes, whatever they do."""
        with self.lock:
            self.closed = True
            for worker in self.workers:
                worker.process.kill()
            self.free.put(None)
        for worker in self.workers:
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
        if worker is None:
            return None
        if not worker.is_ready():
            with self.lock:
                self.mice = b""
            self.free.put(None)
            return None
        try:
            played = worker.play(mouse, contest)
        except (EOFError, OSError, pickle.UnpicklingError):
            if self.closed:
                return b"", "", True  # no actions: it was interrupted
            code = worker.process.wait()
            with self.lock:
                self.workers.remove(worker)
            self.free.put(None)
            return _died(f"its process ended with exit code {code}")
        self.free.put(worker)
        return played

    def _take(self) -> Union[_Worker, None]:
        """A process that has nothing to do; None where there can be none."""
        while True:
            with self.lock:
                if self.mice is None:
                    self.mice = _pickled(self.makers)
                if self.closed or not self.mice:
                    self.free.put(None)  # for the next that waits
                    return None
                if self.free.empty() and len(self.workers) < self.most:
                    self.workers.append(_Worker(self.mice))
                    return self.workers[-1]
            worker = self.free.get()
            if worker is not None:
                return worker


def _pickled(makers: "list[object]") -> bytes:
    """The mice for other processes, also those of a notebook; nothing where they cannot leave this one."""
    import cloudpickle  # type: ignore[import-untyped,unused-ignore]

    try:
        return bytes(cloudpickle.dumps(makers))
    except Exception:  # what a user's object raises can be anything
        return b""


def _died(words: str) -> Played:
    return death(), words, True


def _processors() -> int:
    affinity = getattr(os, "sched_getaffinity", None)
    return len(affinity(0)) if affinity is not None else os.cpu_count() or 1


def for_mice(mice: "list[tuple[str, Any, bool]]", jobs: int) -> Union[Workers, None]:
    """Processes for these mice; None where they are all to be raced in this one."""
    if not mice or jobs == 1 or not needed():
        return None
    return Workers([maker for _, maker, _ in mice], jobs or _processors())
