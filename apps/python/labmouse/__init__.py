"""A laboratory for micromice, which explore mazes that they have never seen.

The package runs the same library as the command `labmouse` and gives the same numbers: docs/reference/python.md.
"""

import os
from typing import Union

from ._mice import Action, Mouse, Sighting
from ._comparisons import Verdicts, compare
from ._native import Briefing, Error, Maze, RealRobot, find_mazes, generate, version
from ._progress import Interrupted
from ._races import Comparison, FinishRate, Race, race
from ._records import Record, Replay, run
from ._routes import Route, bound, route
from ._studies import Study, study
from ._worlds import mazes_of

__version__ = version()

__all__ = [
    "Action",
    "Briefing",
    "Comparison",
    "FinishRate",
    "Error",
    "Interrupted",
    "Maze",
    "Mouse",
    "Race",
    "RealRobot",
    "Record",
    "Replay",
    "Route",
    "Sighting",
    "Study",
    "Verdicts",
    "bound",
    "compare",
    "generate",
    "mazes",
    "race",
    "route",
    "run",
    "study",
]


def mazes(*paths: Union[str, "os.PathLike[str]"]) -> "list[Maze]":
    """The mazes of files, folders and patterns, sorted by name; without a path, all built-in mazes.

    Raises Error if a file that is named directly is not a maze.
    """
    return mazes_of(paths) if paths else find_mazes([])
