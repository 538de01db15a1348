"""The mazes of an environment: a list, folders, or generated sets."""

import os
from typing import Iterator, List, Optional, Sequence, Tuple, Union, overload

from .. import Maze
from .._arguments import shown, whole
from .._native import Error, MazeFamily
from .._worlds import mazes_of

SPLITS = ("train", "validation", "test")


class MazeSet:
    """A sequence of generated mazes, made on access. The same number gives the same maze on every machine.

    The sets 'train', 'validation' and 'test' of one kind and size share no maze. A hash of a maze's content,
    not its seed, decides to which set it belongs, so this holds even for sizes with few mazes.

    Args:
        split: 'train', 'validation' or 'test'.
        kind: a generator, as for labmouse.generate.
        size: the side in cells, or (width, height).
        loops: the share, 0 to 1, of the remaining inner walls that is opened afterwards.
        count: mazes have the numbers 0 to count - 1; None: any number below 2**63.

    Raises:
        labmouse.Error: if there are no such mazes.
    """

    def __init__(
        self,
        split: str = "train",
        *,
        kind: str = "contest",
        size: Union[int, Tuple[int, int]] = 16,
        loops: float = 0.0,
        count: Optional[int] = None,
    ) -> None:
        if count is not None and count < 1:
            raise Error(f"count is the number of mazes, at least 1, not {count}")
        self.split, self.kind, self.loops, self.count = split, kind, loops, count
        sides = tuple(size) if isinstance(size, (tuple, list)) else (size, size)
        if len(sides) != 2:
            raise Error(f"size is a number of cells, or (width, height), not {shown(size)}")
        self.size = whole("a side", sides[0], 1, 64), whole("a side", sides[1], 1, 64)
        self._family = MazeFamily(kind, self.size, loops, split, count or 0)

    def __len__(self) -> int:
        if self.count is None:
            raise TypeError("this set has no end; MazeSet(..., count=n) has n mazes")
        return self.count

    @overload
    def __getitem__(self, number: int) -> Maze: ...
    @overload
    def __getitem__(self, number: slice) -> List[Maze]: ...
    def __getitem__(self, number: Union[int, slice]) -> Union[Maze, List[Maze]]:
        if isinstance(number, slice):
            if self.count is None and number.stop is None:
                raise TypeError("this set has no end; the slice needs one")
            end = self.count if self.count is not None else number.stop
            return [self[i] for i in range(*number.indices(end))]
        number = whole("the number of a maze", number, 0 if self.count is None else -(2**63), 2**63 - 1)
        if self.count is not None and not -self.count <= number < self.count:
            raise IndexError(f"the set has {self.count} mazes; there is no maze {number}")
        return self._family.maze(number + self.count if self.count is not None and number < 0 else number)

    def __iter__(self) -> Iterator[Maze]:
        return (self[number] for number in range(len(self)))

    def __repr__(self) -> str:
        count = "" if self.count is None else f", count={self.count}"
        loops = "" if self.loops == 0 else f", loops={self.loops}"
        return f"MazeSet('{self.split}', kind='{self.kind}', size={self.size}{loops}{count})"


#: A set or its name, a maze, a list of mazes, or paths of files and folders.
Mazes = Union[MazeSet, str, "os.PathLike[str]", Maze, Sequence[Union[Maze, str, "os.PathLike[str]"]]]


def source_of(mazes: Mazes) -> Union[MazeFamily, List[Maze]]:
    """Converts `mazes` to the types of the compiled part: a family or a list."""
    if isinstance(mazes, str) and mazes in SPLITS:
        mazes = MazeSet(mazes)
    if isinstance(mazes, MazeSet):
        return mazes._family
    return mazes_of(mazes)
