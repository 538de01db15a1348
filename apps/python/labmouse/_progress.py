"""Waits for long work, with a progress bar on standard error or in a notebook, and handles Ctrl-C."""

import sys
from collections.abc import Callable
from typing import Any, Protocol, TypeVar

from ._workers import Workers


#: Length of one wait for compiled work, in s. Python handles Ctrl-C only between waits.
_SECONDS_A_WAIT = 0.01


class Running(Protocol):
    """Work that runs in a thread of the compiled part, counted in contests."""

    @property
    def remarks(self) -> "list[str]": ...
    @property
    def done(self) -> int: ...
    @property
    def all(self) -> int: ...
    def wait(self, seconds: float) -> bool: ...
    def stop(self) -> None: ...


class WithResult(Running, Protocol):
    """Such work with a result."""

    def result(self) -> Any: ...


Result = TypeVar("Result")


def _in_notebook() -> bool:
    shell = sys.modules.get("IPython")
    running = shell.get_ipython() if shell is not None else None
    return running is not None and "ZMQ" in type(running).__name__


class _Bar:
    """A progress bar, in a notebook or on a terminal."""

    def __init__(self, progress: "bool | None") -> None:
        self.notebook = _in_notebook()
        self.shown = progress if progress is not None else self.notebook or sys.stderr.isatty()
        self.percent = -1
        self.handle: Any = None

    def show(self, running: Running) -> None:
        if not self.shown or running.all == 0 or running.done * 100 // running.all == self.percent:
            return
        self.percent = running.done * 100 // running.all
        line = f"[{'#' * (self.percent * 40 // 100):<40}] {self.percent:>3} %"
        if not self.notebook:
            print(f"\r{line}", end="", file=sys.stderr, flush=True)
            return
        from IPython.display import display  # type: ignore[import-not-found,unused-ignore]

        if self.handle is None:
            self.handle = display({"text/plain": line}, raw=True, display_id=True)
        else:
            self.handle.update({"text/plain": line}, raw=True)

    def clear(self) -> None:
        if self.percent < 0:
            return
        if not self.notebook:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)
        elif self.handle is not None:
            self.handle.update({"text/plain": ""}, raw=True)


class Interrupted(KeyboardInterrupt):
    """Raised by Ctrl-C while contests run. `partial` has what was done: an incomplete Race, Study or Record."""

    def __init__(self, partial: Any) -> None:
        super().__init__(f"{partial!r} is in the attribute `partial`")
        self.partial = partial


def finish(running: Running, progress: "bool | None", workers: "Workers | None" = None) -> bool:
    """Waits for the end of the work with a progress bar. Returns whether Ctrl-C stopped it and its workers."""
    for remark in running.remarks:
        print(remark, file=sys.stderr)
    bar = _Bar(progress)
    try:
        while not running.wait(_SECONDS_A_WAIT):
            bar.show(running)
        return False
    except KeyboardInterrupt:
        running.stop()
        if workers is not None:
            workers.close()
        while not running.wait(_SECONDS_A_WAIT):
            pass
        return True
    finally:
        bar.clear()


def result_of(
    start: "Callable[[], WithResult]", make: "Callable[[Any], Result]", progress: "bool | None", workers: "Workers | None"
) -> Result:
    """Starts work, waits for it, and returns make(its result). Closes the workers. Ctrl-C raises Interrupted."""
    try:
        running = start()
        stopped = finish(running, progress, workers)
        result = make(running.result())
    finally:
        if workers is not None:
            workers.close()
    if stopped:
        raise Interrupted(result)
    return result
