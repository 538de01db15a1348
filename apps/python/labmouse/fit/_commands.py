"""The command lines of `python -m labmouse.fit` and `python -m labmouse.fit.compare`.

Exit codes: 0 success, 1 the robot file may be wrong (a warning says why), 2 bad usage or input.
"""

import argparse
import os
import sys
from typing import Callable, NoReturn, Sequence

from .. import Error, _native
from ._comparison import compare_log
from ._log_fit import fit_log
from ._logs import Log, read_log
from ._plots import save_plot
from ._presets import PRESETS
from ._robots import FittedRobot, base_numbers, robot_numbers, robot_of_header, robot_of_logs
from ._turns import read_header

_COLUMNS = "which column of the log is what: ROLE=COLUMN or ROLE=EXPRESSION (+ - * / and parentheses), separated by commas (docs/how-to/robot-from-a-log.md has the roles)"
_WAY = "how far the mouse came in the whole log, where no column has a way that is known"
_TURNS = "table of turns with the columns turn, speed, ms, x, y, before, after; or a C header of firmware with turns or constants, such as config-robot-*.h of UKMARS"
_CELL = "with --turns: side of a cell; default: what S90 with its straights says, or that of the other robot"
_ROBOT = "built-in robot, or a file with a slash or .toml in its name (default: classic)"
_PRESET = f"format of the log, instead of --columns: {', '.join(PRESETS)}; without both, its first line says it"
_PERIOD = "from one row of the log to the next in ms, where no column has the time"


def _number(low: float, high: float) -> Callable[[str], float]:
    def number(text: str) -> float:
        value = float(text)
        if not low <= value <= high:
            raise argparse.ArgumentTypeError(f"'{text}' must be {low:g} to {high:g}")
        return value

    return number


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        """Prints one line, as for all errors of users, and exits with code 2."""
        self.exit(2, f"error: {message}; {self.prog} --help lists all options\n")


def _parser(name: str, description: str) -> argparse.ArgumentParser:
    parser = _Parser(prog=f"python3 -m labmouse.{name}", description=description, allow_abbrev=False)
    parser.add_argument("--columns", metavar="LIST", default="", help=_COLUMNS)
    parser.add_argument("--preset", metavar="NAME", choices=PRESETS, default="", help=_PRESET)
    parser.add_argument("--period", metavar="MS", type=_number(0.05, 50.0), default=0.0, help=_PERIOD)
    return parser


def _log(path: str, options: argparse.Namespace) -> Log:
    if options.columns and options.preset:
        raise Error("--columns and --preset both say which column is what; give one of them")
    return read_log(path, options.columns, period=options.period, preset=options.preset)


def _run(command: Callable[[], int]) -> int:
    """Runs a command; a user's error becomes a line on standard error and exit code 2."""
    try:
        return command()
    except Error as error:
        text = str(error)
        print(text if ": error: " in text else f"error: {text}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130


def _check_outputs(inputs: Sequence[str], outputs: Sequence[str]) -> None:
    # An input that is no file is the name of a built-in robot.
    places = [os.path.realpath(path) for path in (*filter(os.path.isfile, inputs), *filter(None, outputs))]
    for path in filter(None, outputs):
        if places.count(os.path.realpath(path)) > 1:
            raise Error(f"{path}: error: is named twice, and would be overwritten; give each output a name of its own")


def fit(words: Sequence[str]) -> int:
    """Writes a robot file from logs or from turns; returns the exit code. words: the arguments."""
    parser = _parser("fit", "Write a robot file from published or measured turns, from a header of firmware, or from logs of a mouse")
    parser.add_argument("logs", nargs="*", metavar="LOG", help="one or more logs of one mouse, CSV; fitted together")
    parser.add_argument("--log", metavar="FILE", action="append", default=[], help="a log, too (repeatable)")
    parser.add_argument("--turns", metavar="TABLE", default="", help=_TURNS)
    parser.add_argument("--way", metavar="MM", type=_number(1.0, 1e6), default=0.0, help=_WAY)
    parser.add_argument("--way-error", metavar="MM", type=_number(0.0, 1e4), default=1.0, help="standard error of that (default: 1)")
    parser.add_argument("--base", metavar="ROBOT", default="classic", help="robot that all other numbers are taken from (default: classic)")
    parser.add_argument("--cell", metavar="MM", type=_number(20.0, 1000.0), default=0.0, help=_CELL)
    parser.add_argument("--out", metavar="FILE", default="", help="save the robot file there instead of printing it")
    parser.add_argument("--plot", metavar="FILE", default="", help="save a plot of the fit, too (.svg, .png, .pdf)")
    return _run(lambda: _fit(parser.parse_args(words)))


def _fit(options: argparse.Namespace) -> int:
    paths = [*options.logs, *options.log]
    if bool(options.turns) == bool(paths):
        raise Error("name one of --turns and --log, which say what to fit")
    if options.plot and len(paths) > 1:
        raise Error("--plot shows one log; name one")
    _check_outputs([*paths, options.turns, options.base], [options.out, options.plot])
    if options.out and not options.out.endswith(".toml") and os.path.isfile(options.out) and os.path.getsize(options.out):
        raise Error(f"{options.out}: error: is there, and no robot file, whose name ends in .toml; use another name, or remove the file")
    path = options.turns or ", ".join(paths)
    fitted = _of_turns(options) if options.turns else _of_logs(options, paths)
    if options.plot and not fitted.fits:
        raise Error(f"{path}: error: has no turns with speeds, so there is no fit for --plot; leave it out")
    if options.out:
        _native.write_file(options.out, fitted.text)
    else:
        print(fitted.text, end="")
    if options.plot:
        save_plot(fitted.fits[0], options.plot)
    if fitted.warning:
        print(f"{path}: {fitted.warning}", file=sys.stderr)
    return 1 if fitted.warning else 0


def _of_turns(options: argparse.Namespace) -> FittedRobot:
    header = read_header(options.turns)
    robot_numbers(options.base)  # an error of the base must not be reported as one of the table
    try:
        return robot_of_header(header, options.base, options.cell)
    except Error as error:
        raise Error(f"{options.turns}: error: {error}") from None


def _of_logs(options: argparse.Namespace, paths: Sequence[str]) -> FittedRobot:
    base = base_numbers(options.base)
    return robot_of_logs([fit_log(_log(path, options), base, way=options.way, way_error=options.way_error) for path in paths], options.base)


def compare(words: Sequence[str]) -> int:
    """Prints how far a robot and a log differ; returns the exit code. words: the arguments."""
    parser = _parser("fit.compare", "Drive a robot beside a log of a mouse: how far they differ")
    parser.add_argument("log", metavar="LOG", help="log of a mouse, CSV")
    parser.add_argument("--robot", metavar="ROBOT", default="classic", help=_ROBOT)
    parser.add_argument("--svg", metavar="FILE", default="", help="save a picture of both, too")
    return _run(lambda: _compare(parser.parse_args(words)))


def _compare(options: argparse.Namespace) -> int:
    _check_outputs([options.log, options.robot], [options.svg])
    comparison = compare_log(_log(options.log, options), options.robot)
    print(comparison)
    if options.svg:
        save_plot(comparison, options.svg)
    return 0
