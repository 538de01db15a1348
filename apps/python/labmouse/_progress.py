"""Long work: a bar on standard error or in a notebook, and Ctrl-C."""

import sys
from collections.abc import Callable
from typing import Any, Protocol, TypeVar

from ._workers import Workers


#: Python hears of Ctrl-C between waits for compiled work.
_SECONDS_A_WAIT = 0.01


class Running(Protocol):
    """Work in a thread of its own."""

    @property
    def remarks(self) -> "list[str]": ...
    @property
    def done(self) -> int: ...
    @property
    def all(self) -> int: ...
    def wait(self, seconds: float) -> bool: ...
    def stop(self) -> None: ...


class WithResult(Running, Protocol):
    """Such work that holds contests."""

    def result(self) -> Any: ...


Result = TypeVar("Result")


def _in_notebook() -> bool:
    shell = sys.modules.get("IPython")
    running = shell.get_ipython() if shell is not None else None
    return running is not None and "ZMQ" in type(running).__name__


class _Bar:
    """Shows how much of the work is done, where somebody looks."""

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
    """Ctrl-C while contests were held. What is done by then is in `partial`: a Race, a Study or a Record that is not complete."""

    def __init__(self, partial: Any) -> None:
        super().__init__(f"{partial!r} is in the attribute `partial`")
        self.partial = partial


def finish(running: Running, progress: "bool | None", workers: "Workers | None" = None) -> bool:
    """Waits for the end of the work, with a bar; whether Ctrl-C stopped it and its workers: then what is done counts."""
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
    """What is made of the result of the work that `start` begins. Ends the workers. Ctrl-C raises Interrupted with what is done."""
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
