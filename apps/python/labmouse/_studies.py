"""Studies: mice compared in pairs on mazes that they have not learned from."""

import io
import json
import os
from typing import TYPE_CHECKING, Any

from . import _native
from ._arguments import LARGEST_SEED, path, runs_given, whole
from ._mice import Mice, given
from ._progress import result_of
from ._workers import for_mice
from ._worlds import Mazes, Setting, mazes_of, world_with

if TYPE_CHECKING:
    import pandas


class Study:
    """A study that was held; `study` makes it. Shown in a notebook as its picture."""

    def __init__(self, held: _native.HeldStudy, from_store: "int | None" = None) -> None:
        self._held = held
        self._from_store = held.from_store if from_store is None else from_store
        #: All of it, as `labmouse study --format json` has it.
        self.data: dict[str, Any] = json.loads(held.json())

    @property
    def complete(self) -> bool:
        """Whether all folds were done: False where Ctrl-C stopped the study before."""
        return self._held.complete

    @property
    def from_store(self) -> int:
        """Contests that were not held, because the store had them."""
        return self._from_store

    @property
    def table(self) -> "pandas.DataFrame":
        """One line a maze, with its fold, its bound and the mean score of each mouse: steps, seconds or points."""
        import pandas

        return pandas.read_csv(io.StringIO(self._held.csv()))

    @property
    def comparisons(self) -> "pandas.DataFrame":
        """One line a pair of mice: the mean of the paired differences, its interval, p-values and verdict."""
        import pandas

        return pandas.DataFrame(self.data["comparisons"])

    @property
    def svg(self) -> str:
        """The picture of the differences and the scores."""
        return self._held.svg()

    def __str__(self) -> str:
        return self._held.table()

    def __repr__(self) -> str:
        mice = [mouse for group in self.data["groups"] for mouse in group["mice"]]
        return f"<labmouse.Study of {', '.join(mouse['name'] for mouse in mice)}>"

    def _repr_svg_(self) -> str:
        return self.svg


def study(
    mice: Mice,
    mazes: "Mazes | None" = None,
    *,
    folds: int = 5,
    learning: bool = True,
    world: "str | None" = None,
    robot: "str | os.PathLike[str] | None" = None,
    rules: "str | os.PathLike[str] | None" = None,
    budget: "int | None" = None,
    runs: "int | None" = None,
    seed: int = 1,
    jobs: int = 0,
    progress: "bool | None" = None,
    store: "str | os.PathLike[str] | None" = None,
    label: "str | None" = None,
    **settings: Setting,
) -> Study:
    """Compares mice as `labmouse study` does: each maze is held out once, in one of the folds.

    Mice that learn are taught anew for each fold, from the mazes of the others, unless `learning` is False. The other
    arguments are those of `race`. Raises Error. Ctrl-C raises Interrupted, which has the folds that are done as `partial`.
    """
    chosen = world_with(world, {"robot": robot, "rules": rules, "budget": budget, **settings})
    who = given(mice)
    runs, seed, jobs = runs_given(runs), whole("seed", seed, 0, LARGEST_SEED), whole("jobs", jobs, 0, 1024)
    folds, kept = whole("folds", folds, 2, 1_000_000), path("store", "" if store is None else store)
    workers = for_mice(who.own, jobs)
    return result_of(
        lambda: _native.RunningStudy(who.native(workers, label, store is not None), mazes_of(mazes), chosen,
                                     (folds, learning, runs, seed, jobs), (kept, None, "keep")),
        Study, progress, workers)
