"""Comparisons until a verdict: mice race against a first one until it is decided which is better."""

import json
import os
from typing import TYPE_CHECKING, Any

from . import _native
from ._arguments import LARGEST_SEED, path, shown, whole
from ._mice import AnyMouse, Given, Mice, given
from ._native import Error
from ._progress import result_of
from ._results import Results
from ._workers import for_mice
from ._worlds import Mazes, Setting, mazes_of, world_with

if TYPE_CHECKING:
    import pandas


class Verdicts(Results[_native.HeldComparison]):
    """The results of a comparison; `compare` returns it."""

    def __init__(self, held: _native.HeldComparison, from_store: "int | None" = None) -> None:
        super().__init__(held, from_store)
        #: The output of `labmouse compare --format json`.
        self.data: dict[str, Any] = json.loads(held.json())

    @property
    def verdict(self) -> str:
        """That of the only candidate: 'better', 'worse', 'no difference' or 'undecided'. Raises Error for several."""
        if len(self.data["candidates"]) != 1:
            raise Error("there are several candidates; their verdicts are in `table`")
        return str(self.data["candidates"][0]["verdict"])

    @property
    def table(self) -> "pandas.DataFrame":
        """One row per candidate: verdict, pairs of contests, both mean shares, their difference and its interval."""
        import pandas

        return pandas.DataFrame(self.data["candidates"])

    def __str__(self) -> str:
        return self._held.table()

    def __repr__(self) -> str:
        found = ", ".join(f"{one['mouse']} {one['verdict']}" for one in self.data["candidates"])
        return f"<labmouse.Verdicts against {self.data['first']}: {found}>"


def _share(name: str, value: Any, low: float, high: float) -> float:
    """The value as a float from `low` to `high`. Raises Error, with the argument's name, for any other value."""
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not low <= value <= high:
        raise Error(f"{name} is a number from {low:g} to {high:g}, not {shown(value)}")
    return float(value)


def compared(first: AnyMouse, candidates: Mice) -> "tuple[Given, bool]":
    """All mice, the first one in front of its kind, and whether it is one in Python."""
    one, others = given(first), given(candidates)
    if len(one.specs) + len(one.own) != 1:
        raise Error("'first' is one mouse; the others are 'candidates'")
    return Given(one.specs + others.specs, one.own + others.own), bool(one.own)


def test_of(better_by: float, alpha: float, beta: float, test: str, most: int) -> "tuple[float, float, float, bool, int]":
    """The checked numbers of the test."""
    if test not in ("bets", "gsprt"):
        raise Error(f"test is 'bets' or 'gsprt', not {shown(test)}")
    return (_share("better_by", better_by, 0.0001, 0.5), _share("alpha", alpha, 1e-6, 0.5), _share("beta", beta, 1e-6, 0.5),
            test == "gsprt", whole("most", most, 1, 1_000_000))


def generator_of(generator: str, size: "int | tuple[int, int]", loops: float) -> "tuple[str, int, int, int]":
    """The checked generator of mazes."""
    width, height = size if isinstance(size, tuple) and len(size) == 2 else (size, size)
    return generator, whole("size", width, 1, 64), whole("size", height, 1, 64), int(_share("loops", loops, 0.0, 1.0) * 1000 + 0.5)


def compare(
    first: AnyMouse,
    candidates: Mice,
    mazes: "Mazes | None" = None,
    *,
    better_by: float = 0.02,
    alpha: float = 0.05,
    beta: float = 0.05,
    test: str = "bets",
    most: int = 5000,
    generator: str = "contest",
    size: "int | tuple[int, int]" = 16,
    loops: float = 0.0,
    world: "str | None" = None,
    robot: "str | os.PathLike[str] | None" = None,
    rules: "str | os.PathLike[str] | None" = None,
    budget: "int | None" = None,
    seed: int = 1,
    jobs: int = 0,
    progress: "bool | None" = None,
    store: "str | os.PathLike[str] | None" = None,
    label: "str | None" = None,
    **settings: Setting,
) -> Verdicts:
    """Races mice against a first one until it is decided which is better, as `labmouse compare` does.

    first: the mouse that others are compared with: a SPEC or a class.
    candidates: one or more mice, as in `race`.
    mazes: mazes to draw from; None to generate them with `generator`, `size` and `loops`.
    better_by: the smallest difference that matters, in shares of the best possible score.
    alpha: largest probability of 'better' or 'worse' without a difference.
    beta: largest probability of 'no difference' where there is one of `better_by` or more.
    test: 'bets', which keeps both whatever the scores, or 'gsprt', the test of chess engines, which is approximate.
    most: the most mazes to race in.

    The other arguments are those of `race`. Raises Error for a wrong argument. Ctrl-C raises Interrupted, whose
    `partial` is the Verdicts so far.
    """
    chosen = world_with(world, {"robot": robot, "rules": rules, "budget": budget, **settings})
    who, first_is_own = compared(first, candidates)
    numbers = (*test_of(better_by, alpha, beta, test, most), whole("seed", seed, 0, LARGEST_SEED), whole("jobs", jobs, 0, 1024))
    kind = generator_of(generator, size, loops)
    kept = path("store", "" if store is None else store)
    workers = for_mice(who.own, numbers[-1])
    return result_of(
        lambda: _native.RunningComparison(who.native(workers, label, store is not None), first_is_own,
                                          [] if mazes is None else mazes_of(mazes), kind, chosen, numbers, (kept, None, "keep")),
        Verdicts, progress, workers)
