"""The Gymnasium environment of one contest."""

from typing import Any, Dict, Optional, Tuple

import gymnasium
import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from .._arguments import whole
from .batch import Batch
from .mazes import Mazes
from .spaces import ACTIONS


class ContestEnv(gymnasium.Env[NDArray[Any], np.int64]):
    """The capstone contest: explore a maze, reset, run to the goal. The return is minus the score.

    Actions: Discrete(22), see labmouse.learn.action_of. Rewards: -1 for a step of the speed run, -1/30 for a
    step of the search run; the return of a failed contest is -100. A contest that uses up its steps has
    failed: it terminates, and is never truncated.

    Args:
        mazes: a MazeSet or its name, a maze, a list of mazes, or paths of files and folders.
        observation: 'sighting', an array of int16 with labmouse.learn.COLUMNS; 'belief', an array of uint8,
            0 or 1, of the shape (height, width, 16) with labmouse.learn.PLANES; 'bits', the same as one
            uint16 per cell.
        order: 'drawn': reset(seed=...) seeds a random choice of mazes; 'in turn': one after the other.
        budget: number of steps of a contest, over both runs.

    Every info has 'action_mask' (int8, 1 where an action is valid), 'return' (so far), 'state' (0 running,
    1 finished, 2 out of steps, 3 never reset, 4 speed run unfinished) and 'maze' (its number).
    """

    metadata: Dict[str, Any] = {"render_modes": []}

    def __init__(
        self, mazes: Mazes = "train", observation: str = "sighting", order: str = "drawn", budget: int = 1000
    ) -> None:
        self._batch = Batch(1, mazes, observation, order, budget)
        self.observation_space: spaces.Space[NDArray[Any]] = self._batch.space
        self.action_space: spaces.Space[np.int64] = spaces.Discrete(ACTIONS)
        self._actions = np.zeros(1, np.int64)
        self._seeded = False
        self._running = False

    def reset(
        self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
    ) -> Tuple[NDArray[Any], Dict[str, Any]]:
        """Begins a contest: with a seed, the first one of that seed; otherwise the next one."""
        super().reset(seed=seed)
        if seed is None and not self._seeded:
            seed = int(self.np_random.integers(2**63))
        self._batch.seed(0, seed)
        self._seeded = self._running = True
        self._batch.native.start()
        return self._batch.observations[0].copy(), self._info()

    def step(self, action: Any) -> Tuple[NDArray[Any], float, bool, bool, Dict[str, Any]]:
        """Makes one step. Raises labmouse.Error if there is no such action, and ResetNeeded after the contest's end."""
        if not self._running:
            raise gymnasium.error.ResetNeeded("the contest has ended; reset() begins the next one")
        self._actions[0] = whole("an action", action, 0, ACTIONS - 1)
        self._batch.native.step(self._actions)
        self._running = not self._batch.ended[0]
        reward, ended = float(self._batch.rewards[0]), bool(self._batch.ended[0])
        return self._batch.observations[0].copy(), reward, ended, False, self._info()

    def _info(self) -> Dict[str, Any]:
        infos = self._batch.infos()
        mask = infos.pop("action_mask")[0].copy()
        return {"action_mask": mask, **{name: values[0].item() for name, values in infos.items()}}
