"""Mice as they are at one moment, as bytes: with their closures, the globals that they use, and modules of the user's own.

cloudpickle sends what was written in a notebook by value. Here, so is what lies in files of the user, and module objects
and the functions in them share one set of globals again where they are made.
"""

import functools
import io
import pickle
import random
import sys
from types import FunctionType, ModuleType
from typing import Any, Callable

import cloudpickle  # type: ignore[import-untyped,unused-ignore]

from ._modules import global_names, is_of_own, is_own

#: What a module is made with where it is made again, and what belongs to the import alone.
_FIRST = ("__package__", "__path__", "__file__", "__doc__")
_LEFT_OUT = ("__builtins__", "__loader__", "__spec__", "__cached__", "__name__")


class _Shell:
    """Stands for an empty module of that name."""

    def __init__(self, space: "dict[str, Any]") -> None:
        self.name = space.get("__name__", "")
        self.first = {name: space[name] for name in _FIRST if name in space}


class _Globals(dict):  # type: ignore[type-arg]
    """Stands for the globals of such a module."""

    def __init__(self, shell: _Shell) -> None:
        super().__init__(stands_for=shell.name)
        self.shell = shell


def _same(thing: Any) -> Any:
    return thing


def _cached(function: Callable[..., Any], size: "int | None", typed: bool) -> Any:
    return functools.lru_cache(size, typed)(function)


def _shared_dice() -> "list[tuple[ModuleType, str]]":
    """The random numbers that all of a process share: never by value, since each contest seeds them."""
    numpy = sys.modules.get("numpy.random.mtrand")
    return [(random, "_inst"), *([(numpy, "_rand")] if numpy is not None else [])]


class _Pickler(cloudpickle.Pickler):  # type: ignore[misc,unused-ignore]
    def __init__(self, file: io.BytesIO, careful: bool) -> None:
        super().__init__(file)
        self.careful = careful
        self.dice = _shared_dice()

    def reducer_override(self, thing: Any) -> Any:
        """As of pickle."""
        if isinstance(thing, _Globals):
            return vars, (thing.shell,)
        if isinstance(thing, _Shell):
            return ModuleType, (thing.name,), thing.first
        if isinstance(thing, ModuleType):
            return (_same, (self._globals_of(vars(thing)).shell,), self._state_of(thing)) if is_own(thing) else NotImplemented
        if isinstance(thing, FunctionType):
            self._globals_of(thing.__globals__)
            return self._function(thing) if is_of_own(thing) else super().reducer_override(thing)
        if isinstance(thing, type):
            by_value = is_of_own(thing) and bool(thing.__flags__ & 1 << 9)  # made by a statement `class`
            return cloudpickle.cloudpickle._dynamic_class_reduce(thing) if by_value else super().reducer_override(thing)
        if isinstance(thing, functools._lru_cache_wrapper) and is_of_own(thing):
            given = thing.cache_parameters()
            return _cached, (thing.__wrapped__, given["maxsize"], given["typed"])
        for module, name in self.dice:
            shared = getattr(module, name)
            if thing is shared:
                return getattr, (module, name)
            if callable(thing) and getattr(thing, "__self__", None) is shared:
                return getattr, (module if module is random else sys.modules["numpy.random"], thing.__name__)
        return super().reducer_override(thing)

    def _function(self, function: FunctionType) -> Any:
        """As cloudpickle has it, with the globals that bodies of classes in it use."""
        reduced = self._dynamic_function_reduce(function)
        used, space = reduced[2][1]["__globals__"], function.__globals__
        used.update({name: space[name] for name in sorted(global_names(function.__code__)) if name in space})
        return reduced

    def _globals_of(self, space: "dict[str, Any]") -> _Globals:
        """Functions find theirs in globals_ref, by the address of the dictionary."""
        known = self.globals_ref.get(id(space))
        if not isinstance(known, _Globals):
            known = self.globals_ref[id(space)] = _Globals(_Shell(space))
        return known

    def _state_of(self, module: ModuleType) -> "dict[str, Any]":
        state = {name: value for name, value in vars(module).items() if name not in _LEFT_OUT}
        return {name: value for name, value in state.items() if _can_leave(value)} if self.careful else state


def _can_leave(thing: Any) -> bool:
    try:
        _Pickler(io.BytesIO(), False).dump(thing)
    except Exception:  # what a user's object raises can be anything
        return isinstance(thing, ModuleType) and is_own(thing)
    return True


def dumps(thing: Any) -> bytes:
    """A thing by value. Raises where a part of it cannot leave this process: locks, open files. Modules of the user's own go
    without such parts."""
    file = io.BytesIO()
    try:
        _Pickler(file, False).dump(thing)
    except Exception:  # as above
        file = io.BytesIO()
        _Pickler(file, True).dump(thing)
    return file.getvalue()


def loads(data: bytes) -> Any:
    """The thing anew: no class of it is one of those that were made before."""
    cloudpickle.cloudpickle._DYNAMIC_CLASS_TRACKER_BY_ID.clear()
    return pickle.loads(data)
