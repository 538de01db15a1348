"""Races: many mice on many mazes."""

import csv
import io
import os
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _native
from ._arguments import LARGEST_SEED, runs_given, whole
from ._arguments import path as _path
from ._mice import Mice, given
from ._progress import result_of
from ._workers import for_mice
from ._worlds import Mazes, Setting, mazes_of, world_with

if TYPE_CHECKING:
    import pandas


class FinishRate(NamedTuple):
    """By how much `mouse` finishes more contests than `against`, as a share of all: above 0, `mouse` is better."""

    mean: float
    low: float
    """The 95 % interval of the mean, over the mazes."""
    high: float
    verdict: str
    """As in a Comparison."""


class Comparison(NamedTuple):
    """Two mice on the same mazes: the paired differences of their mean scores, `mouse` minus `against`.

    Failed contests count the failure score of the world or, where it has none, the score at the time limit. Nothing is
    corrected for the number of comparisons: of many pairs of equal mice, one in twenty differs by chance.
    """

    mouse: str
    against: str
    mazes: int
    """Mazes that both have run."""
    mean: float
    """In the world's unit, steps, seconds or points; below 0, `mouse` is better."""
    low: float
    """The 95 % interval of the mean, over the mazes."""
    high: float
    better: int
    """Mazes in which `mouse` scores lower."""
    equal: int
    worse: int
    sign_test: float
    """Two-sided p-value of the exact sign test."""
    p: float
    """Two-sided p-value of the sign-flip test of the mean."""
    verdict: str
    """'better' or 'worse' of `mouse` if p is below 0.05 and the interval excludes 0; otherwise 'no difference shown', or
    'too few mazes' for fewer than eight."""
    finish_rate: "FinishRate | None"
    """None where failed contests have a score."""


class Race:
    """A race that was held; `race` makes it. Shown in a notebook as its leaderboard."""

    def __init__(self, held: _native.HeldRace, from_store: "int | None" = None) -> None:
        self._held = held
        self._from_store = held.from_store if from_store is None else from_store

    @property
    def complete(self) -> bool:
        """Whether all contests were held: False where Ctrl-C stopped the race before."""
        return self._held.complete

    @property
    def from_store(self) -> int:
        """Contests that were not held, because the store had them."""
        return self._from_store

    @property
    def world(self) -> str:
        """The name of the world."""
        return self._held.world

    @property
    def mice(self) -> "list[str]":
        """The names of the mice, in their order."""
        return self._held.mice

    @property
    def table(self) -> "pandas.DataFrame":
        """One line a contest, with the columns of `labmouse race --format csv`: docs/reference/results.md has their units, and of seconds
        docs/reference/worlds-and-rules.md. Of a race that was stopped early, there is a column `stopped`, which is True."""
        import pandas

        table = pandas.DataFrame(self._held.contest_columns())
        return table if self.complete else table.assign(stopped=True)

    @property
    def standings(self) -> "pandas.DataFrame":
        """One line a mouse, best first, with the fields of a mouse in `labmouse race --format json`."""
        import pandas

        return pandas.DataFrame(self._held.standing_columns())

    @property
    def mazes(self) -> "pandas.DataFrame":
        """One line a maze, with its bound: the best possible score there. Microseconds where a column ends in `_us`; otherwise
        steps or points, as the world has it."""
        import pandas

        return pandas.DataFrame(self._held.maze_columns())

    def compare(self, mouse: str, against: str) -> Comparison:
        """The paired difference of two mice of the race, maze by maze. Raises Error where one is not in it."""
        fields = self._held.compare(mouse, against)
        rate = fields.pop("finish_rate")
        return Comparison(**fields, finish_rate=None if rate is None else FinishRate(*rate))

    def to_csv(self, path: "str | os.PathLike[str] | None" = None) -> "str | None":
        """What `labmouse race --format csv` prints: written to a file, or returned where no path is given.

        Of a race that was stopped early, there is a column `stopped`, as in the table. Raises Error where the file cannot be
        written.
        """
        text = self._held.csv()
        return _saved(text if self.complete else _marked(text), path)

    def to_json(self, path: "str | os.PathLike[str] | None" = None) -> "str | None":
        """What `labmouse race --format json` prints: written to a file, or returned where no path is given.

        Raises Error where the file cannot be written.
        """
        return _saved(self._held.json(), path)

    def __str__(self) -> str:
        return self._held.leaderboard()

    def __repr__(self) -> str:
        state = "" if self.complete else ", stopped before its end"
        return f"<labmouse.Race of {len(self.mice)} mice on {len(self._held.mazes)} mazes{state}>"

    def _repr_html_(self) -> str:
        from html import escape

        first, second, *mice = self._held.cells()
        headings = "".join(f"<th>{escape(upper)}<br/>{escape(lower)}</th>" for upper, lower in zip(first, second))
        lines = "".join(f"<tr><th>{escape(mouse)}</th>{''.join(f'<td>{escape(cell)}</td>' for cell in cells)}</tr>"
                        for mouse, *cells in mice)
        return (f"<p>{escape(self._held.heading())}</p><table><thead><tr>{headings}</tr></thead><tbody>{lines}</tbody></table>"
                f'<div style="white-space: pre-wrap">{escape(self._held.notes())}</div>')


def _marked(text: str) -> str:
    """Lines of CSV with a column that says that they are not all."""
    marked = io.StringIO()
    lines = csv.reader(io.StringIO(text, newline=""))
    csv.writer(marked, lineterminator="\n").writerows([*line, "true" if number else "stopped"] for number, line in enumerate(lines))
    return marked.getvalue()


def _saved(text: str, path: "str | os.PathLike[str] | None") -> "str | None":
    if path is None:
        return text
    _native.write_file(_path("path", path), text)
    return None


def race(
    mice: "Mice | None" = None,
    mazes: "Mazes | None" = None,
    *,
    world: "str | None" = None,
    robot: "str | os.PathLike[str] | None" = None,
    rules: "str | os.PathLike[str] | None" = None,
    budget: "int | None" = None,
    runs: "int | None" = None,
    seed: int = 1,
    jobs: int = 0,
    out: "str | os.PathLike[str] | None" = None,
    overwrite: bool = False,
    progress: "bool | None" = None,
    store: "str | os.PathLike[str] | None" = None,
    label: "str | None" = None,
    **settings: Setting,
) -> Race:
    """Races mice on mazes, with the numbers of `labmouse race`.

    mice: SPECs, classes with `decide(self, seen)`, or a dictionary of both by names; None for all built-in ones.
    mazes: mazes, files, folders or patterns; None for all built-in mazes.
    world: 'steps', 'seconds', 'physical', 'failures' or 'mms'; None for the one that suits the mice. `robot` and `rules` are
        settings of those in seconds (a built-in name or a file), `budget` (steps of a contest) of 'steps';
        other settings have the names of the command line's options.
    runs: contests in each maze of a stochastic mouse, and of each mouse in 'physical' and 'failures'; None for
        20, and 3 in 'physical'. seed: for all random choices.
    jobs: threads, and processes of mice in Python; 0 for as many as there are processors. Results do not depend on it: each
        contest of a mouse in Python begins with the state of your variables at the call, and leaves them alone.
    out: a folder for the records, a picture for each mouse and maze, and the results, as `--out` leaves it; what an
        earlier race left there is replaced with `overwrite`, and an error without.
    progress: whether to show a bar; None for where standard error is a terminal, and in notebooks.
    store: a file that keeps all contests; those that are there are not run again. Others may use it at the same time.
    label: in the store, stands for the files of external mice, and for what mice in Python read from elsewhere: give another one when
        that changes.

    Raises Error. Ctrl-C stops the race and raises Interrupted, a KeyboardInterrupt that has what is done as `partial`.
    """
    chosen = world_with(world, {"robot": robot, "rules": rules, "budget": budget, **settings})
    who = given(mice)
    runs, seed, jobs = runs_given(runs), whole("seed", seed, 0, LARGEST_SEED), whole("jobs", jobs, 0, 1024)
    folder, kept = _path("out", out or ""), _path("store", "" if store is None else store)
    workers = for_mice(who.own, jobs)
    return result_of(
        lambda: _native.RunningRace(who.native(workers, label, store is not None), mazes_of(mazes), chosen, runs, seed, jobs,
                                    folder, overwrite, (kept, None, "keep")),
        Race, progress, workers)
