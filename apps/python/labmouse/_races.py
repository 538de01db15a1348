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
from ._results import Results
from ._workers import for_mice
from ._worlds import Mazes, Setting, mazes_of, world_with

if TYPE_CHECKING:
    import pandas


class FinishRate(NamedTuple):
    """Difference of two finish rates (shares of contests), `mouse` minus `against`. Above 0, `mouse` is better."""

    mean: float
    low: float
    """The 95 % interval of the mean, over the mazes."""
    high: float
    verdict: str
    """As in a Comparison."""


class Comparison(NamedTuple):
    """Paired differences of the mean scores of two mice on the same mazes, `mouse` minus `against`.

    A failed contest counts with the failure score of the world or, if it has none, with the score at the time limit.
    Nothing is corrected for multiple comparisons: of many pairs of equal mice, one in twenty differs by chance.
    """

    mouse: str
    against: str
    mazes: int
    """Mazes that both have run."""
    mean: float
    """Mean difference in the unit of the world: steps, seconds or points. Below 0, `mouse` is better."""
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
    """None in worlds in which failed contests have a score."""


class Race(Results[_native.HeldRace]):
    """The results of a race; `race` returns it. A notebook shows its leaderboard."""

    @property
    def world(self) -> str:
        """The name of the world."""
        return self._held.world

    @property
    def mice(self) -> "list[str]":
        """The names of the mice, in the order of the race."""
        return self._held.mice

    @property
    def table(self) -> "pandas.DataFrame":
        """One row per contest, with the columns of `labmouse race --format csv`.

        docs/reference/results.md describes the columns and their units; docs/reference/worlds-and-rules.md has those of
        the worlds in seconds. If the race was stopped early, there is also a column `stopped`, always True.
        """
        import pandas

        table = pandas.DataFrame(self._held.contest_columns())
        return table if self.complete else table.assign(stopped=True)

    @property
    def standings(self) -> "pandas.DataFrame":
        """One row per mouse, best first, with the fields of a mouse in `labmouse race --format json`."""
        import pandas

        return pandas.DataFrame(self._held.standing_columns())

    @property
    def mazes(self) -> "pandas.DataFrame":
        """One row per maze, with its bound, the best possible score there.

        Columns that end in `_us` are in microseconds, others in the world's unit (steps or points).
        """
        import pandas

        return pandas.DataFrame(self._held.maze_columns())

    def compare(self, mouse: str, against: str) -> Comparison:
        """Compares two mice of the race by name, paired by maze. Raises Error if one is not in the race."""
        fields = self._held.compare(mouse, against)
        rate = fields.pop("finish_rate")
        return Comparison(**fields, finish_rate=None if rate is None else FinishRate(*rate))

    def to_csv(self, path: "str | os.PathLike[str] | None" = None) -> "str | None":
        """Writes the output of `labmouse race --format csv` to a file; without a path, returns it.

        If the race was stopped early, there is also a column `stopped`. Raises Error if the file cannot be written.
        """
        text = self._held.csv()
        return _saved(text if self.complete else _marked(text), path)

    def to_json(self, path: "str | os.PathLike[str] | None" = None) -> "str | None":
        """Writes the output of `labmouse race --format json` to a file; without a path, returns it.

        Raises Error if the file cannot be written.
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
    """Adds a column `stopped` with the value true to CSV."""
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
    """Races mice on mazes, with the same numbers as `labmouse race`.

    mice: SPECs, classes with `decide(self, seen)`, or a dictionary from names to both; None for all built-in mice.
    mazes: mazes, files, folders or patterns; None for all built-in mazes.
    world: a name that `labmouse race --world` takes; None for the first one that takes the mice.
        `robot` and `rules` (a built-in name or a file) are settings of worlds in which robots drive, `budget` (steps per
        contest) is one where steps count. Other settings have the names of the command line's options. Without `rules`, a
        race in half-size mazes only (a side over 16) has 'all-japan-half', any other 'all-japan'.
    runs: contests per maze of a stochastic mouse, and of every mouse in a stochastic world; None for the world's own
        number, which `labmouse race --help` says.
    seed: for all random choices, 0 to 2**64 - 1.
    jobs: number of threads, and of processes for mice in Python; 0 for one per processor. Results do not depend on it:
        each contest of a mouse in Python starts with your variables as they were at the call, and does not change them.
    out: folder for records, a picture per mouse and maze, and the results, as `--out` writes them.
    overwrite: whether to replace the files of an earlier race in `out`; otherwise they are an error.
    progress: whether to show a progress bar; None to show it on a terminal and in notebooks.
    store: file that keeps all contests; a contest that it has is not run again. Several programs may use it at once.
    label: a version for the store. With a label, it does not compare the files of external mice, and accepts mice in
        Python that depend on things outside of their code. Give another label when these files or things change.

    Raises Error for a wrong argument. Ctrl-C stops the race and raises Interrupted, a KeyboardInterrupt whose `partial`
    is the Race so far.
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
