"""Seasons of a league, whose contests run on a cluster."""

import json
from typing import TYPE_CHECKING, Any

from . import _native
from ._results import Results

if TYPE_CHECKING:
    import pandas


class Season(Results[_native.HeldSeason]):
    """The results of a season; `cluster.league` returns it."""

    def __init__(self, held: _native.HeldSeason, from_store: int) -> None:
        super().__init__(held, from_store)
        #: The content of `results.json` that `labmouse league publish` writes; empty while contests are missing.
        self.data: dict[str, Any] = json.loads(held.json()) if held.complete else {}

    @property
    def table(self) -> "pandas.DataFrame":
        """One row per mouse, the best first: name, rank, share of the best possible score, its interval, finished contests."""
        import pandas

        columns = ["name", "rank", "share_of_best", "share_interval", "finished"]
        return pandas.DataFrame([{column: mouse[column] for column in columns} for mouse in self.data.get("mice", [])],
                                columns=columns)

    def __str__(self) -> str:
        return self._held.table() if self.complete else "contests are missing: nobody is ranked"

    def __repr__(self) -> str:
        mice = self.data.get("mice", [])
        return f"<labmouse.Season: {len(mice)} mice{'' if self.complete else ', stopped early'}>"
