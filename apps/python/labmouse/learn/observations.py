"""The meaning of the numbers in an observation, and the observation spaces."""

from typing import Any, Tuple

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from .._native import BELIEF_PLANES

#: The columns of a 'sighting', in order.
COLUMNS = (
    "left", "ahead", "right", "x", "y", "heading", "speed_run", "goal_entered", "steps_left", "blocked",
    "width", "height", "goal_west", "goal_south", "goal_east", "goal_north",
)  # fmt: skip

#: The planes of a 'belief', in order; bit k of a cell of 'bits' is plane k.
PLANES = (
    "open_north", "open_east", "open_south", "open_west",
    "closed_north", "closed_east", "closed_south", "closed_west",
    "visited", "mouse_north", "mouse_east", "mouse_south", "mouse_west", "goal", "speed_run", "goal_entered",
)  # fmt: skip

OBSERVATIONS = ("sighting", "belief", "bits")


def planes_of(bits: NDArray[np.uint16]) -> NDArray[np.uint8]:
    """Converts observations 'bits', shape (..., height, width), to 'belief', shape (..., height, width, 16), 0 or 1."""
    return (bits[..., None] >> np.arange(BELIEF_PLANES, dtype=np.uint16) & 1).astype(np.uint8)


def space_of(observation: str, size: Tuple[int, int], budget: int) -> spaces.Box:
    """The space of one environment's observation."""
    width, height = size
    if observation == "sighting":
        high = np.array([63, 63, 63, 63, 63, 3, 1, 1, budget, 1, 64, 64, 63, 63, 63, 63], np.int16)
        return spaces.Box(np.zeros_like(high), high, dtype=np.int16)
    if observation == "belief":
        return spaces.Box(0, 1, (height, width, BELIEF_PLANES), np.uint8)
    if observation == "bits":
        return spaces.Box(0, 65535, (height, width), np.uint16)
    raise ValueError(observation)


def memory_of(count: int, space: spaces.Box) -> NDArray[Any]:
    """A zeroed array for the observations of `count` environments."""
    return np.zeros((count, *space.shape), space.dtype)
