"""The compiled part of labmouse."""

from collections.abc import Mapping, Sequence
import os
from typing import Annotated, Any, overload

import numpy
from numpy.typing import NDArray


def version() -> str:
    """The release, and the commit where it is known."""

class Error(ValueError):
    """
    An error in a maze, a mouse or an option. Its text is the line that the command `labmouse` would print.
    """

def write_file(path: str | os.PathLike[str], text: str) -> None:
    """
    Writes a file completely or not at all. Raises Error if it cannot be written.
    """

class Maze:
    """
    An immutable maze: walls, start, goals and a name.

    Cells are (x, y): x counts eastwards and y northwards from (0, 0), the south-west corner. Two
    mazes are equal if walls, start, heading and goals are equal; names do not count.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        """
        Reads a maze file of any format (docs/reference/maze-files.md), or takes a built-in maze by its name.

        Raises Error with file, line, column and reason if there is no such maze.
        """

    @staticmethod
    def parse(text: str, name: str = 'maze') -> Maze:
        """
        Reads a maze from text in any format. Raises Error with line, column and reason.
        """

    @staticmethod
    def from_walls(north: NDArray[numpy.bool_], east: NDArray[numpy.bool_], start: tuple[int, int] = (0, 0), heading: str = 'north', goals: Sequence[tuple[int, int]] | None = None, name: str = 'maze') -> Maze:
        """
        Makes a maze from two arrays of bool of the shape (height, width).

        north[y, x] says whether there is a wall north of the cell (x, y), and east[y, x] whether there is
        one east of it. The border must be closed: north[-1, :] and east[:, -1] are all True. `goals` is a
        list of cells, or None for the centre. Raises Error if this is not a valid maze.
        """

    @property
    def name(self) -> str:
        """
        The name in results: the path of its file, or the name of a built-in or generated maze.
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
        """
        The direction that the mouse faces there: 'north', 'east', 'south' or 'west'.
        """

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
        The maze as text in a format: 'drawing', 'capstone', 'num', 'maz', 'blocks', 'hex', 'dump', 'csv', 'steps', 'json' or 'c'. Raises Error if the format cannot hold this maze.
        """

    def save(self, path: str | os.PathLike[str], format: str | None = None) -> None:
        """
        Writes the maze to a file. Without a format, the extension of the path decides (.maz, .num, .hex, .csv, .log, .json, .h; a drawing for all others). Raises Error if the format cannot hold this maze or the file cannot be written.
        """

    def named(self, name: str) -> Maze:
        """The same maze under another name."""

    def with_start(self, start: tuple[int, int], heading: str = 'north') -> Maze:
        """
        The same maze with another start. Raises Error if that is not a cell of the maze.
        """

    def with_goals(self, goals: Sequence[tuple[int, int]]) -> Maze:
        """
        The same maze with other goals, at least one. Raises Error if one is not a cell of the maze.
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
    Generates a maze: 'depth-first', 'prim', 'kruskal', 'wilson', 'division', 'empty' or 'contest'.

    `size` is a side in cells or (width, height), 1 to 64. The same seed gives the same maze everywhere.
    `loops` is the share, 0 to 1, of the remaining inner walls that is opened afterwards.
    Raises Error if the generator cannot make such a maze.
    """

def find_mazes(paths: Sequence[str | os.PathLike[str]]) -> list[Maze]: ...

def set_sighting_type(type: type) -> None:
    """Sets the class of sightings, called with (left, ahead, right)."""

class Briefing:
    """What a mouse knows before its first step."""

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
        """The direction that it faces there: 'north', 'east', 'south' or 'west'."""

    @property
    def goals(self) -> list[tuple[int, int]]:
        """The goal cells."""

    @property
    def world(self) -> str:
        """'steps' or 'seconds'; in the physical world, too, it is 'seconds'."""

    @property
    def stride(self) -> int:
        """
        The longest movement of a step, in cells: 3 by the rules. In seconds 32, the largest side of a maze: there, a mouse may move along any straight that it has seen to be open.
        """

    @property
    def budget(self) -> int | None:
        """The number of steps that both runs may take together; None in seconds."""

    @property
    def time_limit(self) -> float | None:
        """The time limit in the maze, in seconds; None in steps."""

    @property
    def sight(self) -> int:
        """
        The range of the sensors in cells. A reading of this value means that no wall was seen within range.
        """

    @property
    def seed(self) -> int:
        """
        The seed for a stochastic mouse, below 2**64. The same contest always has the same seed.
        """

    def __getstate__(self) -> tuple[tuple[int, int, tuple[int, int], int, list[tuple[int, int]]], tuple[int, int, int, int], tuple[bool, int]]: ...

    def __setstate__(self, arg: tuple[tuple[int, int, tuple[int, int], int, Sequence[tuple[int, int]]], tuple[int, int, int, int], tuple[bool, int]], /) -> None: ...

    def __repr__(self) -> str: ...

class Strategy:
    """A mouse in a worker process, asked for one decision at a time."""

    def __init__(self, maker: object, briefing: Briefing) -> None: ...

    @property
    def started(self) -> bool: ...

    def decide(self, left: int, ahead: int, right: int) -> tuple[int, int, int, int]:
        """
        The action: kind, rotation in degrees, movement in cells, forfeit reason.
        """

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

    def spent(self) -> dict[tuple[str, int], tuple[int, float]]:
        """
        The number of contests and their seconds, by the name of the mouse and the number of cells of the maze. Valid for a race in one thread, once it has ended.
        """

    @property
    def remarks(self) -> list[str]: ...

    @property
    def settings(self) -> dict[str, str]:
        """
        The settings of the world that were given, and the defaults that depend on the mazes.
        """

    @property
    def done(self) -> int: ...

    @property
    def all(self) -> int: ...

    def wait(self, seconds: float) -> bool: ...

    def stop(self) -> None: ...

    def missing(self) -> list[tuple[str, str, int]]: ...

    def result(self) -> HeldRace: ...

def merge_stores(paths: Sequence[str], target: str) -> int:
    """
    Merges stores as `labmouse store merge` does. Returns how many contests are new in the target. Raises Error if stores conflict or cannot be read or written.
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
    """
    A robot's name, and JSON of its parameters. Raises Error if there is no such robot.
    """

def robot_ranges() -> dict[str, tuple[float, float]]:
    """The lowest and the highest value of each key of robot files."""

def robot_file(parameters: str, remarks: Mapping[str, str], otherwise: str) -> tuple[str, str]:
    """The text of a robot file, and the first problem of that robot or ''."""

def turn_curve(turn: str, speed: float, limits: Sequence[float], cell: float) -> list[float]:
    """
    Width of a turn, length of its curve, and length with its straights, in mm; `speed` is in mm/s.
    """

def turn_clearance(turn: str, speed: float, limits: Sequence[float], cell: float) -> float:
    """
    Distance in mm from the path to the nearest wall or post; 0 where the curve does not fit.
    """

def drive_duties(robot: str, stronger: float, left: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], right: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> tuple[list[float], list[float]]:
    """
    Distance (mm) and heading (rad, to the left) of a robot by tick (1 ms) for given PWM duties of its motors, on an open floor and without noise. `stronger`: share by which the right motor is stronger.
    """

def drive_speeds(robot: str, speed: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], speeding: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], turning: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], twisting: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> tuple[list[float], list[float]]:
    """
    The same for a robot whose controller follows speed and its derivative (mm/s, mm/s²) and yaw rate and its derivative (rad/s, rad/s²).
    """

class MazeFamily:
    """Generated mazes of one kind and split, by number."""

    def __init__(self, kind: str, size: tuple[int, int], loops: float, split: str, count: int) -> None: ...

    def maze(self, number: int) -> Maze: ...

def split_of(maze: Maze) -> str:
    """
    The split of a maze: 'train', 'validation' or 'test'. A hash of its content decides.
    """

def action_of(number: int) -> tuple[int, int] | None:
    """
    The (rotation in degrees, movement in cells) of an action, by its number; None for the reset.
    """

ACTIONS: int = 22

RESET: int = 21

ROW_COLUMNS: int = 16

BELIEF_PLANES: int = 16

class ContestBatch:
    """Contests that are stepped together."""

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
        """Bytes of memory for each contest, without the arrays of bind()."""

    def bind(self, rewards: Annotated[NDArray[numpy.float64], dict(order='C', device='cpu')], returns: Annotated[NDArray[numpy.float64], dict(order='C', device='cpu')], ended: Annotated[NDArray[numpy.uint8], dict(order='C', device='cpu')], *, rows: Annotated[NDArray[numpy.int16], dict(order='C', device='cpu')] | None = None, words: Annotated[NDArray[numpy.uint16], dict(order='C', device='cpu')] | None = None, bytes: Annotated[NDArray[numpy.uint8], dict(order='C', device='cpu')] | None = None, masks: Annotated[NDArray[numpy.int8], dict(order='C', device='cpu')] | None = None, states: Annotated[NDArray[numpy.uint8], dict(order='C', device='cpu')] | None = None, mazes: Annotated[NDArray[numpy.int64], dict(order='C', device='cpu')] | None = None) -> None:
        """
        Sets the arrays to write to from now on. Follow it with start(). Raises Error if a size is wrong.
        """

    def seed(self, contest: int, seed: int) -> None:
        """Sets the seed by which a contest draws its mazes."""

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
    def settings(self) -> dict[str, str]:
        """
        The settings of the world that were given, and the defaults that depend on the mazes.
        """

    @property
    def done(self) -> int: ...

    @property
    def all(self) -> int: ...

    def wait(self, seconds: float) -> bool: ...

    def stop(self) -> None: ...

    def missing(self) -> list[tuple[str, str, int]]: ...

    def result(self) -> HeldStudy: ...

class HeldComparison:
    @property
    def complete(self) -> bool: ...

    @property
    def from_store(self) -> int: ...

    def table(self) -> str: ...

    def json(self) -> str: ...

class RunningComparison:
    def __init__(self, mice: tuple[Sequence[tuple[str, str]], Sequence[tuple[str, object, bool, object, str]], str, str], first_is_own: bool, mazes: Sequence[Maze], generator: tuple[str, int, int, int], world: tuple[str, Mapping[str, str]], test: tuple[float, float, float, bool, int, int, int], store: tuple[str, Sequence[tuple[str, str, int]] | None, str], batch: int | None = None) -> None: ...

    @property
    def remarks(self) -> list[str]: ...

    @property
    def settings(self) -> dict[str, str]:
        """
        The settings of the world that were given, and the defaults that depend on the mazes.
        """

    @property
    def done(self) -> int: ...

    @property
    def all(self) -> int: ...

    def wait(self, seconds: float) -> bool: ...

    def stop(self) -> None: ...

    def missing(self) -> list[tuple[str, str, int]]: ...

    def result(self) -> HeldComparison: ...

def batch_of(maze: str) -> int:
    """
    The batch of a comparison in which a drawn maze of that name is raced in.
    """

class HeldSeason:
    @property
    def complete(self) -> bool: ...

    @property
    def from_store(self) -> int: ...

    def table(self) -> str: ...

    def json(self) -> str: ...

class RunningSeason:
    def __init__(self, folder: str, seed: str, python: str, sandbox: bool, jobs: int, records: str, store: tuple[str, Sequence[tuple[str, str, int]] | None, str]) -> None: ...

    @property
    def spent(self) -> float:
        """The seconds of all contests that ran, in one thread."""

    @property
    def remarks(self) -> list[str]: ...

    @property
    def settings(self) -> dict[str, str]:
        """
        The settings of the world that were given, and the defaults that depend on the mazes.
        """

    @property
    def done(self) -> int: ...

    @property
    def all(self) -> int: ...

    def wait(self, seconds: float) -> bool: ...

    def stop(self) -> None: ...

    def missing(self) -> list[tuple[str, str, int]]: ...

    def result(self) -> HeldSeason: ...

def season_seed(folder: str, seed_file: str) -> str:
    """
    The seed of the season in that folder. Raises Error if it has another hash than the season file.
    """

class RealRobot:
    """
    The map of a real robot, from the bytes that it sends (docs/reference/protocols.md).

    Its text is the drawing of `labmouse live`.
    """

    def __init__(self, width: int = 16, height: int = 16, maze: Maze | None = None) -> None:
        """
        A robot in a maze of that size that nobody knows, or in a maze that is known: then width and height do not count, and false and missed walls are findings.
        """

    def feed(self, data: bytes) -> list[dict[str, Any]]:
        """
        Adds bytes, in any pieces. Returns a dict for each line that ends in them and is no noise: its number `line`; `restart`; `cell`, `heading` and `walls` (True: closed) if it has them; `fields`; `drawing` if it ends one; and `findings`, the lines that `labmouse live` prints.
        """

    @property
    def pose(self) -> tuple[int, int, str] | None:
        """Where the robot is: x, y and its heading; None until a line says it."""

    @property
    def fields(self) -> dict[str, str]:
        """The newest value of each field."""

    @property
    def text(self) -> str:
        """
        The map as a drawing, which `labmouse show` and `labmouse inspect` read.
        """

    @property
    def contradictions(self) -> list[str]:
        """The walls that were seen in both states, a line each."""

    @property
    def lines(self) -> int:
        """How many lines have ended."""

    @property
    def noise(self) -> int:
        """How many of them are noise."""

    def __str__(self) -> str: ...
