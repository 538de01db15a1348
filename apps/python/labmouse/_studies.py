"""Studies: paired comparisons of mice on mazes that they were not trained on (cross-validation)."""

import io
import json
import os
from typing import TYPE_CHECKING, Any

from . import _native
from ._arguments import LARGEST_SEED, path, runs_given, whole
from ._mice import Mice, given
from ._progress import result_of
from ._results import Results
from ._workers import for_mice
from ._worlds import Mazes, Setting, mazes_of, world_with

if TYPE_CHECKING:
    import pandas


class Study(Results[_native.HeldStudy]):
    """The results of a study; `study` returns it. A notebook shows its picture."""

    def __init__(self, held: _native.HeldStudy, from_store: "int | None" = None) -> None:
        super().__init__(held, from_store)
        #: The output of `labmouse study --format json`.
        self.data: dict[str, Any] = json.loads(held.json())

    @property
    def table(self) -> "pandas.DataFrame":
        """One row per maze: its fold, its bound, and the mean score of each mouse in steps, seconds or points."""
        import pandas

        return pandas.read_csv(io.StringIO(self._held.csv()))

    @property
    def comparisons(self) -> "pandas.DataFrame":
        """One row per pair of mice: the mean of the paired differences, its interval, p-values and verdict."""
        import pandas

        return pandas.DataFrame(self.data["comparisons"])

    @property
    def svg(self) -> str:
        """The picture of the differences and the scores, as SVG."""
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
    """Compares mice by cross-validation, as `labmouse study` does: each maze is held out in one of the folds.

    folds: number of folds, at least 2.
    learning: whether mice that learn are trained for each fold, on the mazes of all other folds.

    The other arguments are those of `race`. Raises Error for a wrong argument. Ctrl-C raises Interrupted, whose
    `partial` is the Study of the folds that are done.
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
