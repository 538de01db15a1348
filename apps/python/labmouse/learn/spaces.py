"""The 22 numbered actions: 7 * turn + movement + 3, with turn 0 left, 1 none, 2 right and movement -3 to 3 cells; 21 is
the reset."""

from typing import Optional

from .._native import ACTIONS, RESET, Error, action_of

__all__ = ["ACTIONS", "RESET", "action_of", "number_of"]


def number_of(rotation: Optional[int], movement: int = 0) -> int:
    """The number of the action with this rotation (-90, 0 or 90 degrees) and movement (-3 to 3 cells).

    A rotation of None stands for the reset. Raises labmouse.Error if there is no such action.
    """
    if rotation is None:
        return RESET
    if rotation not in (-90, 0, 90) or not -3 <= movement <= 3:
        raise Error(f"no action turns by {rotation} degrees and moves by {movement} cells")
    return 7 * (rotation // 90 + 1) + movement + 3
