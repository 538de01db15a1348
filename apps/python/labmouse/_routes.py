"""The best possible score in a maze (its bound), and the fastest route of a robot in seconds."""

import json
import os
from typing import Any

from . import _native
from ._arguments import path
from ._worlds import AnyMaze, Setting, maze_of, world_with


def bound(
    maze: AnyMaze,
    *,
    world: "str | None" = None,
    robot: "str | os.PathLike[str] | None" = None,
    rules: "str | os.PathLike[str] | None" = None,
    budget: "int | None" = None,
    **settings: Setting,
) -> "float | None":
    """The best possible score in a maze, that of a mouse that knows the maze. None if no goal can be reached.

    Its unit is that of the world: steps, seconds or points. The settings are those of `race`. Raises Error if the world refuses the maze or a setting is wrong.
    """
    chosen = world_with(world, {"robot": robot, "rules": rules, "budget": budget, **settings})
    return _native.bound(maze_of(maze), chosen)


class Route:
    """The fastest route of a robot through a maze, over curves and diagonals; `route` finds it."""

    def __init__(self, found: "tuple[str, str, str]") -> None:
        self._json, self._table, self.svg = found
        #: The route of this maze, as in the output of `labmouse route --format json`.
        self.data: dict[str, Any] = json.loads(self._json)["mazes"][0]

    @property
    def seconds(self) -> float:
        """Time in s from rest at the start to the goal."""
        return float(self.data["time_us"]) / 1e6

    def __str__(self) -> str:
        return self._table

    def __repr__(self) -> str:
        return f"<labmouse.Route of {self.seconds:.3f} s>"

    def _repr_svg_(self) -> str:
        return self.svg


def route(maze: AnyMaze, robot: "str | os.PathLike[str]" = "classic") -> Route:
    """The fastest route in seconds, as `labmouse route` finds it.

    robot: a built-in one, or a file whose name has a slash or ends in .toml. Raises Error if there is no route or no
        such robot.
    """
    return Route(_native.route(maze_of(maze), path("robot", robot)))
