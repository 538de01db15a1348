"""The capstone contest as a Gymnasium environment: docs/how-to/train-with-gymnasium.md has examples.

Importing this package registers the environment ``labmouse/Contest-v0``.
"""

try:
    import gymnasium
except ImportError as error:  # pragma: no cover - depends on what is installed
    raise ImportError("labmouse.learn needs gymnasium: run pip install -v '.[learn]' in the source folder of labmouse") from error

from .._native import split_of
from .environment import ContestEnv
from .mazes import MazeSet
from .mouse import Learned, LearnedMouse
from .observations import COLUMNS, PLANES, planes_of
from .spaces import ACTIONS, RESET, action_of, number_of
from .vector import ContestVectorEnv

__all__ = [
    "ACTIONS",
    "COLUMNS",
    "ContestEnv",
    "ContestVectorEnv",
    "Learned",
    "LearnedMouse",
    "MazeSet",
    "PLANES",
    "RESET",
    "action_of",
    "number_of",
    "planes_of",
    "split_of",
]

if "labmouse/Contest-v0" not in gymnasium.registry:
    gymnasium.register(
        id="labmouse/Contest-v0",
        entry_point="labmouse.learn:ContestEnv",
        vector_entry_point="labmouse.learn:ContestVectorEnv",
    )
