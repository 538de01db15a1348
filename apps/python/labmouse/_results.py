"""What the results of all long work have in common."""

from typing import Generic, Protocol, TypeVar


class HeldResults(Protocol):
    """Results in the compiled part."""

    @property
    def complete(self) -> bool: ...
    @property
    def from_store(self) -> int: ...


Held = TypeVar("Held", bound=HeldResults)


class Results(Generic[Held]):
    """Results of contests, whole or as far as they were run."""

    def __init__(self, held: Held, from_store: "int | None" = None) -> None:
        self._held = held
        self._from_store = held.from_store if from_store is None else from_store

    @property
    def complete(self) -> bool:
        """Whether all contests were run: False if Ctrl-C stopped it."""
        return self._held.complete

    @property
    def from_store(self) -> int:
        """The number of contests that were taken from the store and not run."""
        return self._from_store
