"""The common part of the single and the vector environment: a compiled batch and the arrays that it writes to."""

from typing import Any, Dict, Optional

import numpy as np
from numpy.typing import NDArray

from .._arguments import shown as words_of
from .._arguments import whole
from .._native import ACTIONS, ROW_COLUMNS, ContestBatch, Error
from .mazes import Mazes, source_of
from .observations import OBSERVATIONS, memory_of, space_of


def shown(array: NDArray[Any]) -> NDArray[Any]:
    """A read-only view of an array."""
    view = array.view()
    view.flags.writeable = False
    return view


class Batch:
    """`count` contests; its arrays change in place with every step."""

    def __init__(self, count: int, mazes: Mazes, observation: str, order: str, budget: int) -> None:
        if order not in ("drawn", "in turn"):
            raise Error(f"unknown order {words_of(order)}; mazes come 'drawn' or 'in turn'")
        if observation not in OBSERVATIONS:
            raise Error(f"unknown observation {words_of(observation)}; the observations are {', '.join(OBSERVATIONS)}")
        count, budget = whole("num_envs", count, 1, 2**24), whole("budget", budget, 1, 32767)
        self.native = ContestBatch(count, source_of(mazes), in_turn=order == "in turn", budget=budget)
        self.space = space_of(observation, self.native.size, budget)
        memory = memory_of(count, self.space)
        rows = memory if observation == "sighting" else np.zeros((count, ROW_COLUMNS), np.int16)
        rewards, returns = np.zeros(count), np.zeros(count)
        ended, states = np.zeros(count, np.uint8), np.zeros(count, np.uint8)
        masks, numbers = np.zeros((count, ACTIONS), np.int8), np.zeros(count, np.int64)
        self.native.bind(
            rewards, returns, ended, rows=rows, words=memory if observation == "bits" else None,
            bytes=memory if observation == "belief" else None, masks=masks, states=states, mazes=numbers,
        )  # fmt: skip
        self.observations, self.rows, self.masks = shown(memory), shown(rows), shown(masks)
        self.rewards, self.returns = shown(rewards), shown(returns)
        self.ended = shown(ended.view(np.bool_))
        self.states, self.numbers = shown(states), shown(numbers)

    def infos(self) -> Dict[str, NDArray[Any]]:
        """The infos of all contests, see ContestEnv."""
        return {"action_mask": self.masks, "return": self.returns, "state": self.states, "maze": self.numbers}

    def take(self, name: str, values: Any, kind: Any = np.int64) -> NDArray[Any]:
        """Converts `values` to an array (count,), if possible without a copy. Raises Error for other values."""
        try:
            array = np.ascontiguousarray(values, dtype=kind)
        except (TypeError, ValueError):
            raise Error(f"{name} are whole numbers, not {words_of(values)}") from None
        if array.shape != self.rewards.shape:
            raise Error(f"{name} have the shape {array.shape}; give the shape {self.rewards.shape}")
        return array

    def seed(self, contest: int, seed: Optional[int]) -> None:
        if seed is not None:
            self.native.seed(contest, seed)
