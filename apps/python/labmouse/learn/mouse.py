"""A trained policy as a mouse for labmouse.race. It gets only readings, and computes its observations itself."""

import json
import os
from importlib import resources
from typing import Any, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from .._native import Error
from .policy import WEIGHTS, Floats, Policy
from .spaces import RESET, action_of

_DX, _DY = (0, 1, 0, -1), (1, 0, -1, 0)
_HEADINGS = ("north", "east", "south", "west")


class Belief:
    """The observations 'bits' and 'sighting' of the environment, computed from readings and the mouse's own actions.

    Args:
        briefing: an object with width, height, start, heading, goals and budget.
    """

    def __init__(self, briefing: Any) -> None:
        width, height, goals = briefing.width, briefing.height, briefing.goals
        self.bits = np.zeros((1, height, width), np.uint16)
        self.rows = np.zeros((1, 16), np.int16)
        grid = self.bits[0]
        grid[-1, :] |= 1 << 4
        grid[:, -1] |= 1 << 5
        grid[0, :] |= 1 << 6
        grid[:, 0] |= 1 << 7
        for x, y in goals:
            grid[y, x] |= 1 << 13
        self.start = (*briefing.start, _HEADINGS.index(briefing.heading))
        self.x, self.y, self.heading = self.start
        self.goals = {tuple(goal) for goal in goals}
        self.budget = self.left = briefing.budget
        self.speed_run = self.goal_entered = False
        columns, lines = [x for x, _ in goals], [y for _, y in goals]
        self.rows[0, 10:] = width, height, min(columns), min(lines), max(columns), max(lines)
        grid[self.y, self.x] |= 1 << 8

    def see(self, left: int, ahead: int, right: int) -> None:
        """Adds a reading to the bits, and writes it with the pose to the row."""
        grid = self.bits[0]
        for turn, cells in ((-1, left), (0, ahead), (1, right)):
            side = (self.heading + turn) % 4
            x, y = self.x, self.y
            for _ in range(cells):
                grid[y, x] |= 1 << side
                x, y = x + _DX[side], y + _DY[side]
                grid[y, x] |= 1 << (side + 2) % 4
            grid[y, x] |= 16 << side
            x, y = x + _DX[side], y + _DY[side]
            if 0 <= x < grid.shape[1] and 0 <= y < grid.shape[0]:
                grid[y, x] |= 16 << (side + 2) % 4
        row = (left, ahead, right, self.x, self.y, self.heading, self.speed_run, self.goal_entered, self.left)
        self.rows[0, :9] = row

    def act(self, number: int) -> None:
        """Applies an action. Its way must be known to be free of walls."""
        self.left -= 1
        if number == RESET:
            if self.goal_entered and not self.speed_run:
                self.speed_run = True
                self.x, self.y, self.heading = self.start
            return
        rotation, movement = action_of(number) or (0, 0)
        self.heading = (self.heading + rotation // 90) % 4
        for _ in range(abs(movement)):
            way = self.heading if movement > 0 else (self.heading + 2) % 4
            self.x, self.y = self.x + _DX[way], self.y + _DY[way]
            self.bits[0, self.y, self.x] |= 1 << 8
        if (self.x, self.y) in self.goals and not self.speed_run:
            self.goal_entered = True


class LearnedMouse:
    """A mouse for labmouse.race. It explores by a policy; its speed run is a shortest route through known passages."""

    def __init__(self, weights: Floats, briefing: Any) -> None:
        self._belief = Belief(briefing)
        self._policy = Policy(weights, 1, (briefing.width, briefing.height))
        self._which = np.zeros(1, np.int64)
        self._before: "NDArray[np.int16] | None" = None

    def decide(self, seen: Any) -> Union[Tuple[int, int], Any]:
        """Returns the next action for a labmouse.Sighting."""
        belief = self._belief
        belief.see(seen.left, seen.ahead, seen.right)
        if self._before is None:
            self._policy.begin(belief.rows)
        else:
            self._policy.moved(self._before, belief.rows, self._which)
        self._before = belief.rows.copy()
        number = int(self._policy.decide(belief.bits, belief.rows, self._which)[0])
        belief.act(number)
        return action_of(number) or "reset"


class Learned:
    """A mouse for labmouse.race: makes a LearnedMouse for each contest.

    Args:
        weights: labmouse.learn.policy.WEIGHTS numbers.
        name: the name of the mouse in results.
    """

    def __init__(self, weights: Any, name: str = "learned") -> None:
        self.weights = np.asarray(weights, np.float64)
        if self.weights.shape != (WEIGHTS,):
            raise Error(f"a policy has {WEIGHTS} weights, not {self.weights.size}")
        self.__name__ = name

    def __call__(self, briefing: Any) -> LearnedMouse:
        if briefing.world != "steps":
            raise Error(f"{self.__name__} has learned to move in steps, and races in the world steps alone")
        return LearnedMouse(self.weights, briefing)

    @classmethod
    def load(cls, path: "Union[str, os.PathLike[str], None]" = None, name: str = "learned") -> "Learned":
        """Loads a mouse from a file of labmouse.learn.train; without a path, the trained mouse of the package.

        Raises labmouse.Error if the file cannot be read or is no such file.
        """
        if path is None:
            text = resources.files(__package__).joinpath("mouse.json").read_text(encoding="utf-8")
        else:
            try:
                with open(path, encoding="utf-8", errors="replace") as file:
                    text = file.read()
            except OSError as error:
                raise Error(f"{os.fspath(path)}: error: {error.strerror}") from None
        try:
            weights = json.loads(text)["weights"]
        except (ValueError, KeyError, TypeError):
            raise Error(f"{os.fspath(path or 'mouse.json')}: error: is no mouse that labmouse.learn.train wrote") from None
        return cls(weights, name)

    def shuffled(self, seed: int = 1) -> "Learned":
        """A mouse with the same weights in random order, as a baseline. The last one, the patience of Policy, stays."""
        k = (WEIGHTS - 1) // 2
        rng, weights = np.random.default_rng(seed), self.weights.copy()
        weights[: 2 * k] = rng.permutation(weights[: 2 * k])
        return Learned(weights, f"{self.__name__} shuffled")
