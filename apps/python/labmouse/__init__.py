"""A laboratory for mice that explore mazes they have never seen: https://en.wikipedia.org/wiki/Micromouse.

The package runs the same library as the command `labmouse`, and gives the same numbers.
"""

import os
from typing import List, Union

from ._native import Error, Maze, __version__, find_mazes, generate

__all__ = ["Error", "Maze", "__version__", "generate", "mazes"]


def mazes(*paths: Union[str, "os.PathLike[str]"]) -> List[Maze]:
    """The mazes of files, folders and patterns, sorted by name; without a path, all built-in mazes.

    Raises Error where a path that is named directly is no maze.
    """
    return find_mazes(list(paths))
