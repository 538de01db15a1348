"""Runs one contest and keeps its record."""

import os
from typing import TYPE_CHECKING, Any

from . import _native
from ._arguments import LARGEST_SEED, whole
from ._arguments import path as _path
from ._mice import AnyMouse, given, kept_chance
from ._progress import result_of
from ._workers import for_mice
from ._worlds import AnyMaze, Setting, maze_of, world_with

if TYPE_CHECKING:
    import numpy
    import numpy.typing

#: The numpy dtype of a step, see Record.steps. The compiled part packs steps in this layout.
STEP = [
    ("step", "<i4"),
    ("run", "u1"),
    ("x", "i1"),
    ("y", "i1"),
    ("heading", "u1"),
    ("left", "i1"),
    ("ahead", "i1"),
    ("right", "i1"),
    ("kind", "u1"),
    ("rotation", "<i4"),
    ("movement", "<i4"),
    ("blocked", "?"),
]


class Replay:
    """An HTML page that plays one contest; a single file."""

    def __init__(self, html: str, height: int) -> None:
        self.html = html
        self.height = height

    def save(self, path: "str | os.PathLike[str]") -> None:
        """Writes the page to a file that any browser opens, without a server. Raises Error if it cannot be written."""
        _native.write_file(_path("path", path), self.html)

    def _repr_html_(self) -> str:
        import html

        page = html.escape(self.html, quote=True)
        return f'<iframe srcdoc="{page}" style="width: 100%; height: {self.height}px; border: 0"></iframe>'


class Record:
    """The record of a contest; `run` returns it. A notebook shows its picture."""

    def __init__(self, held: _native.HeldContest) -> None:
        self._held = held

    @property
    def complete(self) -> bool:
        """Whether the contest ended by itself: False if Ctrl-C stopped it."""
        return self._held.complete

    @property
    def mouse(self) -> str:
        """The name of the mouse."""
        return self._held.mouse

    @property
    def maze(self) -> _native.Maze:
        """The maze."""
        return self._held.maze

    @property
    def seed(self) -> int:
        """The seed of the contest."""
        return self._held.seed

    @property
    def world(self) -> str:
        """The name of the world."""
        return self._held.world

    @property
    def outcome(self) -> str:
        """How it ended: 'finished', 'out of steps', 'forfeit: ended early' and so on."""
        return self._held.outcome

    @property
    def score(self) -> "float | None":
        """The score in the world's unit (steps, seconds or points); lower is better. None if it did not finish."""
        return self._held.score

    @property
    def bound(self) -> "float | None":
        """The best possible score in the maze, in the same unit; None if no mouse can finish there."""
        return self._held.bound

    @property
    def last_words(self) -> str:
        """The last message of the mouse, or ''. For a mouse in Python that raised, it has the traceback."""
        return self._held.last_words

    @property
    def figures(self) -> "dict[str, Any]":
        """The fields of the contest in `labmouse race --format json`, by name."""
        return self._held.figures()

    @property
    def steps(self) -> "numpy.typing.NDArray[numpy.void]":
        """The steps of a contest in the world of steps: a read-only structured array with one element per step.

        step: number of the step, from 1. run: 0 search run, 1 speed run. x, y, heading: the pose before the step;
        headings are 0 north, 1 east, 2 south, 3 west. left, ahead, right: open cells in the reading. kind: 0 step,
        1 reset, 2 forfeit. rotation (degrees clockwise) and movement (cells): as the mouse asked for them. blocked:
        whether a wall ended the movement early. Raises Error in other worlds.
        """
        import numpy

        packed = self._held.steps()
        if packed is None:
            raise _native.Error(f"a contest in the world {self.world} has no steps; see Record.text")
        return numpy.frombuffer(packed, dtype=numpy.dtype(STEP))

    @property
    def svg(self) -> str:
        """The picture of the contest as SVG."""
        return self._held.svg

    @property
    def text(self) -> str:
        """The content of the record file: JSON Lines, see docs/reference/records.md."""
        return self._held.record

    def save(self, path: "str | os.PathLike[str]") -> None:
        """Writes the record to a file, which `labmouse replay` reads. Raises Error if it cannot be written."""
        _native.write_file(_path("path", path), self.text)

    def replay(self, height: int = 720) -> Replay:
        """An HTML page that plays this contest; a notebook shows it `height` pixels high.

        Raises Error if the package was built without the page.
        """
        return Replay(self._held.report(), height)

    def __repr__(self) -> str:
        score = "" if self.score is None else f", score {self.score:.3f}"
        return f"<labmouse.Record of {self.mouse} in {self.maze.name}: {self.outcome}{score}>"

    def _repr_svg_(self) -> str:
        return self.svg


def run(
    mouse: AnyMouse,
    maze: AnyMaze,
    *,
    world: "str | None" = None,
    robot: "str | os.PathLike[str] | None" = None,
    rules: "str | os.PathLike[str] | None" = None,
    budget: "int | None" = None,
    seed: int = 1,
    debug: bool = False,
    progress: "bool | None" = False,
    **settings: Setting,
) -> Record:
    """Runs one contest of one mouse in one maze, with the same numbers as `labmouse run`.

    The arguments are those of `race`; `seed` is the seed of the contest itself.
    debug: runs a mouse in Python in this process. Then a debugger can stop in it, its prints are shown, and its changes
        to variables stay. The order of sets of str is that of this process; all else is as in a race.

    Raises Error for a wrong argument. Ctrl-C raises Interrupted, whose `partial` is the Record so far.
    """
    chosen = world_with(world, {"robot": robot, "rules": rules, "budget": budget, **settings})
    who, where, seed = given(mouse), maze_of(maze), whole("seed", seed, 0, LARGEST_SEED)
    workers = None if debug else for_mice(who.own, 1)
    with kept_chance():
        return result_of(
            lambda: _native.RunningContest(who.native(workers), where, chosen, seed), Record, progress, workers
        )
