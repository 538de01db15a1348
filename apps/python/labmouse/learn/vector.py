"""The Gymnasium vector environment of many contests."""

from typing import Any, Dict, List, Optional, Tuple, Union

import numpy as np
from gymnasium import spaces
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray

from .._arguments import shown as words_of
from .._native import Error
from .batch import Batch
from .mazes import Mazes
from .spaces import ACTIONS


class ContestVectorEnv(VectorEnv[NDArray[Any], NDArray[np.int64], NDArray[Any]]):
    """`num_envs` contests of labmouse.learn.ContestEnv, stepped together in compiled code.

    Contests restart by Gymnasium's AutoresetMode.NEXT_STEP: the step after the last one of a contest ignores
    its action, begins the next contest and has reward 0. After reset(seed=s), environment i plays the same
    contests as a ContestEnv after reset(seed=s + i). With order='in turn', environment i plays the mazes i,
    i + num_envs, ... of the set.

    Without `copy`, reset and step always return the same read-only arrays, which the next step changes in
    place. Actions of int64 are read without a copy.

    The other arguments and the infos are those of ContestEnv; an info is an array over the environments.
    """

    metadata: Dict[str, Any] = {"render_modes": [], "autoreset_mode": AutoresetMode.NEXT_STEP}

    def __init__(
        self,
        num_envs: int = 1,
        mazes: Mazes = "train",
        observation: str = "sighting",
        order: str = "drawn",
        budget: int = 1000,
        copy: bool = False,
    ) -> None:
        self.num_envs = num_envs
        self._batch = Batch(num_envs, mazes, observation, order, budget)
        self._copy = copy
        self.single_observation_space = self._batch.space
        self.single_action_space = spaces.Discrete(ACTIONS)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._truncations = np.zeros(num_envs, np.bool_)
        self._truncations.flags.writeable = False
        self._seeded = False

    def reset(
        self, *, seed: Union[int, List[Optional[int]], None] = None, options: Optional[Dict[str, Any]] = None
    ) -> Tuple[NDArray[Any], Dict[str, Any]]:
        """Begins new contests in all environments, or in those where options['reset_mask'] is True."""
        which = (options or {}).get("reset_mask")
        if which is not None:
            which = self._batch.take("options['reset_mask']", which, np.uint8)
        super().reset(seed=seed if isinstance(seed, int) else None)
        if seed is None and not self._seeded:
            seed = int(self.np_random.integers(2**62))
        seeds = [seed + i for i in range(self.num_envs)] if isinstance(seed, int) else seed or [None] * self.num_envs
        if len(seeds) != self.num_envs:
            raise Error(f"{len(seeds)} seeds for {self.num_envs} environments")
        for contest, own in enumerate(seeds):
            if which is None or which[contest]:
                self._batch.seed(contest, own)
        if isinstance(seed, int):
            self._batch.native.seed_choices(seed)
        self._seeded = True
        self._batch.native.start(which)
        return self._given(self._batch.observations), self._infos()

    def step(
        self, actions: NDArray[np.int64]
    ) -> Tuple[NDArray[Any], NDArray[Any], NDArray[Any], NDArray[Any], Dict[str, Any]]:
        """Makes one step in every environment. If an action is out of range, raises labmouse.Error and does nothing."""
        batch = self._batch
        batch.native.step(batch.take("actions", actions))
        given = self._given
        return given(batch.observations), given(batch.rewards), given(batch.ended), given(self._truncations), self._infos()

    def draw_valid_actions(self, into: Optional[NDArray[np.int64]] = None) -> NDArray[np.int64]:
        """Draws a valid action per environment, uniformly, into `into` if given. reset(seed=int) seeds the draws."""
        actions = np.empty(self.num_envs, np.int64) if into is None else into
        if self._batch.take("actions", actions) is not actions:
            raise Error(f"actions are written to an array of int64 in one piece, not to {words_of(actions)}")
        self._batch.native.draw_valid_choices(actions)
        return actions

    @property
    def sightings(self) -> NDArray[np.int16]:
        """The observation 'sighting' of all environments, shape (num_envs, 16), for every choice of `observation`."""
        return self._batch.rows

    @property
    def nbytes_per_env(self) -> int:
        """Memory per environment in bytes: state, observation and all other arrays, but not the mazes of a list."""
        batch = self._batch
        arrays = (batch.rewards, batch.returns, batch.ended, batch.masks, batch.states, batch.numbers, batch.observations)
        bytes_of_rows = 0 if batch.rows.dtype == batch.observations.dtype else batch.rows.nbytes
        return batch.native.bytes_a_contest + (sum(array.nbytes for array in arrays) + bytes_of_rows) // self.num_envs

    def _given(self, array: NDArray[Any]) -> NDArray[Any]:
        return array.copy() if self._copy else array

    def _infos(self) -> Dict[str, Any]:
        return {name: self._given(values) for name, values in self._batch.infos().items()}
