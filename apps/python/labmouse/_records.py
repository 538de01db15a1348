"""One contest, step by step."""

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

#: The fields of a step as numpy has them: see Record.steps.
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
    """The page with one contest in it, which its player shows: one HTML file."""

    def __init__(self, html: str, height: int) -> None:
        self.html = html
        self.height = height

    def save(self, path: "str | os.PathLike[str]") -> None:
        """Writes the page to a file that any browser opens, without a server. Raises Error where it cannot be written."""
        _native.write_file(_path("path", path), self.html)

    def _repr_html_(self) -> str:
        import html

        page = html.escape(self.html, quote=True)
        return f'<iframe srcdoc="{page}" style="width: 100%; height: {self.height}px; border: 0"></iframe>'


class Record:
    """A contest that was held; `run` makes it. Shown in a notebook as its picture."""

    def __init__(self, held: _native.HeldContest) -> None:
        self._held = held

    @property
    def complete(self) -> bool:
        """Whether the contest came to its end: False where Ctrl-C stopped it."""
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
        """How it ended: 'finished', 'out of steps', 'forfeit: died' and so on."""
        return self._held.outcome

    @property
    def score(self) -> "float | None":
        """Steps, seconds or points, as the world has it; lower is better. None where the contest was not finished."""
        return self._held.score

    @property
    def bound(self) -> "float | None":
        """The best possible score in the maze, in the same unit; None where no mouse can score."""
        return self._held.bound

    @property
    def last_words(self) -> str:
        """What the mouse had to say at its end: of a mouse in Python, the traceback of what it raised."""
        return self._held.last_words

    @property
    def figures(self) -> "dict[str, Any]":
        """All figures of the contest, as `labmouse race --format json` has them."""
        return self._held.figures()

    @property
    def steps(self) -> "numpy.typing.NDArray[numpy.void]":
        """One element a step, a structured array that cannot be written to; of the world of steps alone.

        step: count of the clock from 1. run: 0 search, 1 speed run. x, y, heading: the pose before the step,
        headings being 0 north, 1 east, 2 south, 3 west. left, ahead, right: open cells that the mouse saw.
        kind: 0 step, 1 reset, 2 forfeit. rotation: degrees clockwise, and movement: cells, as the mouse asked for
        them. blocked: whether a wall ended the movement early. Raises Error in other worlds.
        """
        import numpy

        packed = self._held.steps()
        if packed is None:
            raise _native.Error(f"a contest in the world {self.world} has no steps; see Record.text")
        return numpy.frombuffer(packed, dtype=numpy.dtype(STEP))

    @property
    def svg(self) -> str:
        """The picture of the contest."""
        return self._held.svg

    @property
    def text(self) -> str:
        """The record as a file has it: JSON Lines, docs/reference/records.md."""
        return self._held.record

    def save(self, path: "str | os.PathLike[str]") -> None:
        """Writes the record to a file, which `labmouse replay` reads. Raises Error where it cannot be written."""
        _native.write_file(_path("path", path), self.text)

    def replay(self, height: int = 720) -> Replay:
        """The page with this contest, `height` pixels high. Raises Error where the package has no page."""
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
    """Holds one contest of one mouse in one maze, with the numbers of `labmouse run`.

    The arguments are those of `race`; `seed` is the contest's own.
    debug: runs the contest of a mouse in Python in this process, where a debugger finds it, its prints are seen, and what it
        leaves in variables stays. Then sets of texts have the order that they have here; all else is as in a race.

    Raises Error. Ctrl-C raises Interrupted, which has the record so far as `partial`.
    """
    chosen = world_with(world, {"robot": robot, "rules": rules, "budget": budget, **settings})
    who, where, seed = given(mouse), maze_of(maze), whole("seed", seed, 0, LARGEST_SEED)
    workers = None if debug else for_mice(who.own, 1)
    with kept_chance():
        return result_of(
            lambda: _native.RunningContest(who.native(workers), where, chosen, seed), Record, progress, workers
        )
