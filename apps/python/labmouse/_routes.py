"""What nobody can beat: the bound of a maze, and its fastest route in seconds."""

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
    """The best possible score in a maze: that of a mouse that knows it. None where no goal can be reached.

    In the unit of the world: steps ('steps'), seconds ('seconds', 'physical') or points ('mms'). The settings are those of `race`.
    """
    chosen = world_with(world, {"robot": robot, "rules": rules, "budget": budget, **settings})
    return _native.bound(maze_of(maze), chosen)


class Route:
    """The fastest route of a robot through a maze, over curves and diagonals; `route` finds it."""

    def __init__(self, found: "tuple[str, str, str]") -> None:
        self._json, self._table, self.svg = found
        #: All of it, as `labmouse route --format json` has it.
        self.data: dict[str, Any] = json.loads(self._json)["mazes"][0]

    @property
    def seconds(self) -> float:
        """From rest at the start to the goal."""
        return float(self.data["time_us"]) / 1e6

    def __str__(self) -> str:
        return self._table

    def __repr__(self) -> str:
        return f"<labmouse.Route of {self.seconds:.3f} s>"

    def _repr_svg_(self) -> str:
        return self.svg


def route(maze: AnyMaze, robot: "str | os.PathLike[str]" = "classic") -> Route:
    """The fastest route in seconds, as `labmouse route` finds it.

    robot: a built-in one, or a file whose name has a slash or ends in .toml. Raises Error where there is no route.
    """
    return Route(_native.route(maze_of(maze), path("robot", robot)))
