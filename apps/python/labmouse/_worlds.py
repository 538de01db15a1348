"""Converts the arguments for worlds and mazes to the types of the compiled part."""

import os
from collections.abc import Iterable
from typing import Union

from ._arguments import path, shown
from ._native import Error, Maze, find_mazes

AnyMaze = Union[Maze, str, "os.PathLike[str]"]
#: Mazes of a race: one, several, files, folders and patterns.
Mazes = Union[AnyMaze, Iterable[AnyMaze]]
Setting = Union[str, int, bool, float, "os.PathLike[str]", None]


def world_with(world: "str | None", settings: "dict[str, Setting]") -> "tuple[str, dict[str, str]]":
    """The name of a world and its settings as text, without those that are None. Raises Error."""
    if not isinstance(world or "", str):
        raise Error(f"world is the name of a world, not {shown(world)}")
    return world or "", {name.replace("_", "-"): _text(value) for name, value in settings.items() if value is not None}


def _text(value: Setting) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    return os.fspath(value) if isinstance(value, os.PathLike) else str(value)


def mazes_of(mazes: "Mazes | None") -> "list[Maze]":
    """The mazes as a list; empty if `mazes` is None, which means all built-in ones. Raises Error if none is found."""
    if mazes is None:
        return []
    several = list(mazes) if isinstance(mazes, Iterable) and not isinstance(mazes, (str, os.PathLike)) else [mazes]
    for each in several:
        if not isinstance(each, (Maze, str, os.PathLike)):
            raise Error(f"{shown(each)} is no maze; give a Maze, a file, a folder, a pattern or the name of a built-in maze")
    found = [each for each in several if isinstance(each, Maze)]
    paths = [each for each in several if not isinstance(each, Maze)]
    if paths:
        found += find_mazes(paths)
    if not found:
        raise Error("no mazes found; name a maze file, or omit the mazes to use the built-in ones")
    return found


def maze_of(maze: AnyMaze) -> Maze:
    """The maze, read from its file if a path is given. Raises Error."""
    return maze if isinstance(maze, Maze) else Maze(path("a maze", maze))
