"""Mice as they are at one moment, as bytes: with their closures, the globals that they use, and modules of the user's own.

cloudpickle sends what was written in a notebook by value. Here, so is what lies in files of the user, and module objects
and the functions in them share one set of globals again where they are made.
"""

import functools
import importlib
import io
import pickle
import random
import sys
import threading
import weakref
from types import FunctionType, ModuleType
from typing import Any, Callable, TypeVar

import cloudpickle  # type: ignore[import-untyped,unused-ignore]

from ._modules import global_names, installed_with, is_of_own, is_own

_LOCK, _RLOCK = type(threading.Lock()), type(threading.RLock())
#: What a module is made with where it is made again, and what belongs to the import alone.
_FIRST = ("__package__", "__path__", "__file__", "__doc__")
_LEFT_OUT = ("__getattr__", "__builtins__", "__loader__", "__spec__", "__cached__", "__name__")


class _Shell:
    """Stands for an empty module of that name."""

    def __init__(self, space: "dict[str, Any]") -> None:
        self.name = space.get("__name__", "")
        self.first = {name: space[name] for name in _FIRST if name in space}
        if "__path__" in self.first:
            self.first["__path__"] = list(self.first["__path__"])


class _Globals(dict):  # type: ignore[type-arg]
    """Stands for the globals of such a module, or of one that is installed."""

    def __init__(self, space: "dict[str, Any]") -> None:
        super().__init__(stands_for=space.get("__name__", ""))
        self.installed = installed_with(space)
        self.shell = self.installed or _Shell(space)


def _module(name: str, first: "dict[str, Any]") -> ModuleType:
    """An empty module, which code that is run later finds by its name. What it is sent without, its file has."""
    module = ModuleType(name)
    vars(module).update(first)
    known = sys.modules.get(name)
    if known is not None and (name == "__main__" or not is_own(known)):
        return module

    def in_file(variable: str) -> Any:
        if variable.startswith("__"):
            raise AttributeError(f"module '{name}' has no attribute '{variable}'")
        made = sys.modules.pop(name)
        try:
            return getattr(importlib.import_module(name), variable)
        except ImportError:
            raise AttributeError(f"module '{name}' has no attribute '{variable}'") from None
        finally:
            sys.modules[name] = made

    vars(module)["__getattr__"] = in_file
    sys.modules[name] = module
    return module


def _same(thing: Any) -> Any:
    return thing


def _cached(function: Callable[..., Any], size: "int | None", typed: bool) -> Any:
    return functools.lru_cache(size, typed)(function)


def _shared_dice() -> "list[tuple[ModuleType, str]]":
    """The random numbers that all of a process share: never by value, since each contest seeds them."""
    numpy = sys.modules.get("numpy.random.mtrand")
    return [(random, "_inst"), *([(numpy, "_rand")] if numpy is not None else [])]


def reduced(thing: Any) -> "tuple[Any, ...] | None":
    """How to make things again that pickle does not know, as of __reduce__; None of others. Locks are open there."""
    if isinstance(thing, functools._lru_cache_wrapper):
        given = thing.cache_parameters()
        return _cached, (thing.__wrapped__, given["maxsize"], given["typed"])
    if isinstance(thing, _LOCK):
        return threading.Lock, ()
    if isinstance(thing, _RLOCK):
        return threading.RLock, ()
    if type(thing) is threading.local:
        return threading.local, ()
    if isinstance(thing, (weakref.WeakKeyDictionary, weakref.WeakValueDictionary)):
        return type(thing), (), None, None, iter(list(thing.items()))
    if type(thing) is weakref.ReferenceType and thing() is not None:
        return weakref.ref, (thing(),)
    return None


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
            return _module, (thing.name, thing.first)
        if isinstance(thing, ModuleType):
            return (_same, (self._globals_of(vars(thing)).shell,), self._state_of(thing)) if is_own(thing) else NotImplemented
        if isinstance(thing, FunctionType):
            return self._function(thing) if is_of_own(thing) else super().reducer_override(thing)
        if isinstance(thing, type):
            by_value = is_of_own(thing) and bool(thing.__flags__ & 1 << 9)  # made by a statement `class`
            return cloudpickle.cloudpickle._dynamic_class_reduce(thing) if by_value else super().reducer_override(thing)
        if isinstance(thing, TypeVar) and is_of_own(thing):
            return cloudpickle.cloudpickle._make_typevar, cloudpickle.cloudpickle._decompose_typevar(thing)
        special = reduced(thing) if is_of_own(thing) or not hasattr(thing, "__wrapped__") else None
        if special is not None:
            return special
        for module, name in self.dice:
            shared = getattr(module, name)
            if thing is shared:
                return getattr, (module, name)
            if callable(thing) and getattr(thing, "__self__", None) is shared:
                return getattr, (module if module is random else sys.modules["numpy.random"], thing.__name__)
        return super().reducer_override(thing)

    def _function(self, function: FunctionType) -> Any:
        """As cloudpickle has it, with the globals that bodies of classes in it use."""
        space = function.__globals__
        known = self._globals_of(space)
        parts = self._dynamic_function_reduce(function)
        used = parts[2][1]["__globals__"]
        used.update({name: space[name] for name in sorted(global_names(function.__code__)) if name in space})
        if known.installed is not None:
            used.clear()
        return parts

    def _globals_of(self, space: "dict[str, Any]") -> _Globals:
        """Functions find theirs in globals_ref, by the address of the dictionary."""
        known = self.globals_ref.get(id(space))
        if not isinstance(known, _Globals):
            known = self.globals_ref[id(space)] = _Globals(space)
        return known

    def _state_of(self, module: ModuleType) -> "dict[str, Any]":
        state = {name: value for name, value in vars(module).items() if name not in _LEFT_OUT}
        return {name: value for name, value in state.items() if _can_leave(value)} if self.careful else state


def _can_leave(thing: Any) -> bool:
    """Whether a variable of a module can; code cannot be left out."""
    if isinstance(thing, (FunctionType, type, ModuleType)):
        return True
    try:
        _Pickler(io.BytesIO(), False).dump(thing)
    except Exception:  # what a user's object raises can be anything
        return False
    return True


def dumps(thing: Any) -> bytes:
    """A thing by value. Raises where a part of it cannot leave this process: connections, generators. Modules of the user's own
    go without such variables."""
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
