"""The part of labmouse that is compiled."""

from collections.abc import Mapping, Sequence
import os
from typing import Annotated, Any, overload

import numpy
from numpy.typing import NDArray


def version() -> str:
    """The release, and the commit where it is known."""

class Error(ValueError):
    """
    What is wrong with a maze, a mouse or an option: the line that the command `labmouse` would print.
    """

def write_file(path: str | os.PathLike[str], text: str) -> None:
    """Writes a file whole or not at all. Raises Error."""

class Maze:
    """
    A maze that never changes: its walls, its start and its goals, under a name.

    Cells are (x, y): x counts eastwards and y northwards from (0, 0), the south-west corner. Two
    mazes are equal where walls, start, heading and goals are, whatever their names.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        """
        Reads a maze file of any format (docs/reference/maze-files.md), or takes a built-in maze by its name.

        Raises Error with file, line, column and reason where there is none.
        """

    @staticmethod
    def parse(text: str, name: str = 'maze') -> Maze:
        """
        The maze of a text in any format. Raises Error with line, column and reason.
        """

    @staticmethod
    def from_walls(north: NDArray[numpy.bool_], east: NDArray[numpy.bool_], start: tuple[int, int] = (0, 0), heading: str = 'north', goals: Sequence[tuple[int, int]] | None = None, name: str = 'maze') -> Maze:
        """
        The maze of two arrays of bool of the shape (height, width).

        north[y, x] says whether there is a wall north of the cell (x, y), and east[y, x] whether there is
        one east of it. The border must be closed: north[-1, :] and east[:, -1] are all True. `goals` is a
        list of cells, or None for the centre. Raises Error where they make no maze.
        """

    @property
    def name(self) -> str:
        """
        What results call it: the path of its file, or the name of a built-in or generated maze.
        """

    @property
    def width(self) -> int:
        """Columns of cells, 1 to 64."""

    @property
    def height(self) -> int:
        """Rows of cells, 1 to 64."""

    @property
    def start(self) -> tuple[int, int]:
        """The cell (x, y) in which a mouse starts."""

    @property
    def heading(self) -> str:
        """Where it looks there: 'north', 'east', 'south' or 'west'."""

    @property
    def goals(self) -> list[tuple[int, int]]:
        """The goal cells, row by row from the south."""

    @property
    def north(self) -> Annotated[NDArray[numpy.bool_], dict(shape=(None, None))]:
        """
        A new array of bool of the shape (height, width): whether there is a wall north of the cell [y, x].
        """

    @property
    def east(self) -> Annotated[NDArray[numpy.bool_], dict(shape=(None, None))]:
        """
        A new array of bool of the shape (height, width): whether there is a wall east of the cell [y, x].
        """

    def text(self, format: str = 'drawing') -> str:
        """
        The maze as a text: 'drawing', 'capstone', 'num' or 'maz'. Raises Error where the format cannot hold it.
        """

    def save(self, path: str | os.PathLike[str], format: str | None = None) -> None:
        """
        Writes it to a file; the format is that of the path's ending (.maz, .num), otherwise a drawing. Raises Error where the format cannot hold it, or the file cannot be written.
        """

    def named(self, name: str) -> Maze:
        """The same maze under another name."""

    def with_start(self, start: tuple[int, int], heading: str = 'north') -> Maze:
        """
        The same maze with another start. Raises Error where that is no cell of the maze.
        """

    def with_goals(self, goals: Sequence[tuple[int, int]]) -> Maze:
        """
        The same maze with other goals, one at least. Raises Error where they are no cells of the maze.
        """

    @property
    def svg(self) -> str:
        """The maze as an SVG picture."""

    def __repr__(self) -> str: ...

    def __str__(self) -> str: ...

    def __eq__(self, arg: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    def __getstate__(self) -> tuple[str, str]: ...

    def __setstate__(self, arg: tuple[str, str], /) -> None: ...

def generate(kind: str = 'contest', size: int | tuple[int, int] = 16, seed: int = 1, loops: float = 0.0) -> Maze:
    """
    A maze from a generator: 'depth-first', 'prim', 'kruskal', 'wilson', 'division', 'empty' or 'contest'.

    `size` is a side in cells or (width, height), 1 to 64. The same seed gives the same maze everywhere.
    `loops` is the share, 0 to 1, of the remaining inner walls that is opened afterwards.
    Raises Error where the generator cannot make such a maze.
    """

def find_mazes(paths: Sequence[str | os.PathLike[str]]) -> list[Maze]: ...

def set_sighting_type(type: type) -> None:
    """Takes the class of which readings are made."""

class Briefing:
    """What a mouse learns of its contest before it is put into the maze."""

    @property
    def width(self) -> int:
        """Columns of cells."""

    @property
    def height(self) -> int:
        """Rows of cells."""

    @property
    def start(self) -> tuple[int, int]:
        """
        The cell (x, y) in which the mouse starts; x counts eastwards and y northwards from (0, 0).
        """

    @property
    def heading(self) -> str:
        """Where it looks there: 'north', 'east', 'south' or 'west'."""

    @property
    def goals(self) -> list[tuple[int, int]]:
        """The goal cells."""

    @property
    def world(self) -> str:
        """'strides' or 'seconds', also for a mouse in the physical world."""

    @property
    def stride(self) -> int:
        """
        The longest movement of a step, in cells: 3 by the rules; in seconds any straight that it has seen to be open.
        """

    @property
    def budget(self) -> int | None:
        """Steps that both runs may take together; None in seconds."""

    @property
    def time_limit(self) -> float | None:
        """Seconds that it may be in the maze; None in steps."""

    @property
    def sight(self) -> int:
        """
        Cells that a reading reaches at most: in a reading of so many, no wall was seen at the end.
        """

    @property
    def seed(self) -> int:
        """
        For a stochastic mouse: the same contest always has the same seed; below 2**64.
        """

    def __getstate__(self) -> tuple[tuple[int, int, tuple[int, int], int, list[tuple[int, int]]], tuple[int, int, int, int], tuple[bool, int]]: ...

    def __setstate__(self, arg: tuple[tuple[int, int, tuple[int, int], int, Sequence[tuple[int, int]]], tuple[int, int, int, int], tuple[bool, int]], /) -> None: ...

    def __repr__(self) -> str: ...

class Strategy:
    """A mouse for another process, which asks it decision by decision."""

    def __init__(self, maker: object, briefing: Briefing) -> None: ...

    @property
    def started(self) -> bool: ...

    def decide(self, left: int, ahead: int, right: int) -> tuple[int, int, int, int]:
        """Kind, rotation, movement and reason."""

    def show(self, x: int, y: int, heading: int, left: int, ahead: int, right: int) -> None: ...

    def carried(self, time: int) -> None: ...

    def last_words(self) -> str: ...

    @property
    def microseconds(self) -> float | None: ...

class HeldRace:
    @property
    def complete(self) -> bool: ...

    @property
    def world(self) -> str: ...

    @property
    def seed(self) -> int: ...

    @property
    def mice(self) -> list[str]: ...

    @property
    def mazes(self) -> list[str]: ...

    @property
    def from_store(self) -> int: ...

    @property
    def contests(self) -> int: ...

    def contest_columns(self) -> dict[str, list[object]]: ...

    def standing_columns(self) -> dict[str, list[object]]: ...

    def maze_columns(self) -> dict[str, list[object]]: ...

    def compare(self, mouse: str, against: str) -> dict[str, Any]: ...

    def leaderboard(self) -> str: ...

    def heading(self) -> str: ...

    def cells(self) -> list[list[str]]: ...

    def notes(self) -> str: ...

    def csv(self) -> str: ...

    def json(self) -> str: ...

class RunningRace:
    def __init__(self, mice: tuple[Sequence[tuple[str, str]], Sequence[tuple[str, object, bool, object, str]], str, str], mazes: Sequence[Maze], world: tuple[str, Mapping[str, str]], runs: int | None, seed: int, jobs: int, out: str, overwrite: bool, store: tuple[str, Sequence[tuple[str, str, int]] | None, str]) -> None: ...

    @property
    def remarks(self) -> list[str]: ...

    @property
    def done(self) -> int: ...

    @property
    def all(self) -> int: ...

    def wait(self, seconds: float) -> bool: ...

    def stop(self) -> None: ...

    def missing(self) -> list[tuple[str, str, int]]: ...

    def spent(self) -> dict[tuple[str, int], tuple[int, float]]:
        """
        Contests and seconds by the name of the mouse and the cells of the maze, of a race in one thread that has ended.
        """

    def result(self) -> HeldRace: ...

def merge_stores(paths: Sequence[str], target: str) -> int:
    """
    As `labmouse store merge`; returns how many contests are new in the target. Raises Error.
    """

class HeldContest:
    @property
    def complete(self) -> bool: ...

    @property
    def world(self) -> str: ...

    @property
    def mouse(self) -> str: ...

    @property
    def maze(self) -> Maze: ...

    @property
    def seed(self) -> int: ...

    @property
    def outcome(self) -> str: ...

    @property
    def score(self) -> float | None: ...

    @property
    def bound(self) -> float | None: ...

    @property
    def last_words(self) -> str: ...

    @property
    def svg(self) -> str: ...

    @property
    def record(self) -> str: ...

    def steps(self) -> bytes | None: ...

    def figures(self) -> dict[str, object]: ...

    def report(self) -> str: ...

class RunningContest:
    def __init__(self, mice: tuple[Sequence[tuple[str, str]], Sequence[tuple[str, object, bool, object, str]], str, str], maze: Maze, world: tuple[str, Mapping[str, str]], seed: int) -> None: ...

    @property
    def remarks(self) -> list[str]: ...

    @property
    def done(self) -> int: ...

    @property
    def all(self) -> int: ...

    def wait(self, seconds: float) -> bool: ...

    def stop(self) -> None: ...

    def result(self) -> HeldContest: ...

def bound(maze: Maze, world: tuple[str, Mapping[str, str]]) -> float | None: ...

def route(maze: Maze, robot: str) -> tuple[str, str, str]: ...

def robot_numbers(name: str) -> tuple[str, str]:
    """A robot's name, and JSON of its numbers. Raises Error."""

def robot_ranges() -> dict[str, tuple[float, float]]:
    """The lowest and the highest value of each key of robot files."""

def robot_file(parameters: str, remarks: Mapping[str, str], otherwise: str) -> tuple[str, str]:
    """The text of a robot file, and the first problem of that robot or ''."""

def turn_curve(turn: str, speed: float, limits: Sequence[float], cell: float) -> list[float]:
    """
    Width, length of the curve, and length with its straights of a turn at a speed in mm/s, in mm.
    """

def turn_clearance(turn: str, speed: float, limits: Sequence[float], cell: float) -> float:
    """
    Distance in mm from the path to the nearest wall or post; 0 where the curve does not fit.
    """

def drive_duties(robot: str, stronger: float, left: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], right: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> tuple[list[float], list[float]]:
    """
    Way (mm) and angle (rad) by tick of a robot under duties, on an open floor and without noise.
    """

def drive_speeds(robot: str, speed: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], speeding: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], turning: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], twisting: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> tuple[list[float], list[float]]:
    """
    The same of a robot whose controller follows speeds (mm/s, mm/s², rad/s, rad/s²).
    """

class MazeFamily:
    """Numbered mazes of one generator and one split."""

    def __init__(self, kind: str, size: tuple[int, int], loops: float, split: str, count: int) -> None: ...

    def maze(self, number: int) -> Maze: ...

def split_of(maze: Maze) -> str:
    """
    The set that a maze belongs to by its content: 'train', 'validation' or 'test'.
    """

def action_of(number: int) -> tuple[int, int] | None:
    """
    The (rotation in degrees, movement in cells) of an action's number; None for the reset.
    """

ACTIONS: int = 22

RESET: int = 21

ROW_COLUMNS: int = 16

BELIEF_PLANES: int = 16

class ContestBatch:
    """Contests in steps, played together."""

    @overload
    def __init__(self, count: int, mazes: Sequence[Maze], in_turn: bool = False, budget: int = 1000) -> None: ...

    @overload
    def __init__(self, count: int, mazes: MazeFamily, in_turn: bool = False, budget: int = 1000) -> None: ...

    @property
    def count(self) -> int: ...

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the largest maze."""

    @property
    def bytes_a_contest(self) -> int:
        """What it holds for each contest besides what it writes to."""

    def bind(self, rewards: Annotated[NDArray[numpy.float64], dict(order='C', device='cpu')], returns: Annotated[NDArray[numpy.float64], dict(order='C', device='cpu')], ended: Annotated[NDArray[numpy.uint8], dict(order='C', device='cpu')], *, rows: Annotated[NDArray[numpy.int16], dict(order='C', device='cpu')] | None = None, words: Annotated[NDArray[numpy.uint16], dict(order='C', device='cpu')] | None = None, bytes: Annotated[NDArray[numpy.uint8], dict(order='C', device='cpu')] | None = None, masks: Annotated[NDArray[numpy.int8], dict(order='C', device='cpu')] | None = None, states: Annotated[NDArray[numpy.uint8], dict(order='C', device='cpu')] | None = None, mazes: Annotated[NDArray[numpy.int64], dict(order='C', device='cpu')] | None = None) -> None:
        """Where to write from now on."""

    def seed(self, contest: int, seed: int) -> None:
        """From which seed a contest draws its mazes."""

    def start(self, which: Annotated[NDArray[numpy.uint8], dict(shape=(None,), order='C', writable=False)] | None = None) -> None:
        """Begins new contests: all, or those where `which` is not 0."""

    def step(self, actions: Annotated[NDArray[numpy.int64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> None:
        """One step of every contest."""

    def seed_choices(self, seed: int) -> None: ...

    def draw_valid_choices(self, into: Annotated[NDArray[numpy.int64], dict(shape=(None,), order='C')]) -> None:
        """Draws a valid action for each contest into an array of int64."""

class HeldStudy:
    @property
    def complete(self) -> bool: ...

    @property
    def from_store(self) -> int: ...

    def table(self) -> str: ...

    def csv(self) -> str: ...

    def json(self) -> str: ...

    def svg(self) -> str: ...

class RunningStudy:
    def __init__(self, mice: tuple[Sequence[tuple[str, str]], Sequence[tuple[str, object, bool, object, str]], str, str], mazes: Sequence[Maze], world: tuple[str, Mapping[str, str]], numbers: tuple[int, bool, int | None, int, int], store: tuple[str, Sequence[tuple[str, str, int]] | None, str]) -> None: ...

    @property
    def remarks(self) -> list[str]: ...

    @property
    def done(self) -> int: ...

    @property
    def all(self) -> int: ...

    def wait(self, seconds: float) -> bool: ...

    def stop(self) -> None: ...

    def missing(self) -> list[tuple[str, str, int]]: ...

    def result(self) -> HeldStudy: ...
