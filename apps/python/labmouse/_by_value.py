"""Pickles mice by value, with their closures, the globals that they use, and the user's own modules.

cloudpickle pickles only notebook code by value, and refers to code in files by its module. Here, code in the user's
files goes by value, too. After unpickling, a module object and its functions share one dictionary of globals again.
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
#: Attributes that are set when a module is made again, and attributes that belong to the import and are not sent.
_FIRST = ("__package__", "__path__", "__file__", "__doc__")
_LEFT_OUT = ("__getattr__", "__builtins__", "__loader__", "__spec__", "__cached__", "__name__")


class _Shell:
    """Pickles as an empty module with the name in `space`, the globals of a module."""

    def __init__(self, space: "dict[str, Any]") -> None:
        self.name = space.get("__name__", "")
        self.first = {name: space[name] for name in _FIRST if name in space}
        if "__path__" in self.first:
            self.first["__path__"] = list(self.first["__path__"])


class _Globals(dict):  # type: ignore[type-arg]
    """Stands for the globals of a module. Pickles as those of the module that _Shell makes, or of an installed one."""

    def __init__(self, space: "dict[str, Any]") -> None:
        super().__init__(stands_for=space.get("__name__", ""))
        self.installed = installed_with(space)
        self.shell = self.installed or _Shell(space)


def _module(name: str, first: "dict[str, Any]") -> ModuleType:
    """Makes an empty module and registers it in sys.modules, but not as __main__ or over an installed module. A
    variable that could not be sent is then looked up by importing the module's file."""
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


def _shared_rngs() -> "list[tuple[ModuleType, str]]":
    """The global random generators of the process. They are never sent by value, since each contest seeds them."""
    numpy = sys.modules.get("numpy.random.mtrand")
    return [(random, "_inst"), *([(numpy, "_rand")] if numpy is not None else [])]


def reduced(thing: Any) -> "tuple[Any, ...] | None":
    """The __reduce__ value of an object that pickle cannot handle, or None for all others. Locks arrive unlocked."""
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
        self.rng = _shared_rngs()

    def reducer_override(self, thing: Any) -> Any:
        """Overrides pickle.Pickler.reducer_override."""
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
        for module, name in self.rng:
            shared = getattr(module, name)
            if thing is shared:
                return getattr, (module, name)
            if callable(thing) and getattr(thing, "__self__", None) is shared:
                return getattr, (module if module is random else sys.modules["numpy.random"], thing.__name__)
        return super().reducer_override(thing)

    def _function(self, function: FunctionType) -> Any:
        """Reduces a function as cloudpickle does, and adds the globals that class bodies inside it use."""
        space = function.__globals__
        known = self._globals_of(space)
        parts = self._dynamic_function_reduce(function)
        used = parts[2][1]["__globals__"]
        used.update({name: space[name] for name in sorted(global_names(function.__code__)) if name in space})
        if known.installed is not None:
            used.clear()
        return parts

    def _globals_of(self, space: "dict[str, Any]") -> _Globals:
        """The stand-in for these globals. cloudpickle looks it up in globals_ref by the id of the dictionary."""
        known = self.globals_ref.get(id(space))
        if not isinstance(known, _Globals):
            known = self.globals_ref[id(space)] = _Globals(space)
        return known

    def _state_of(self, module: ModuleType) -> "dict[str, Any]":
        state = {name: value for name, value in vars(module).items() if name not in _LEFT_OUT}
        return {name: value for name, value in state.items() if _can_leave(value)} if self.careful else state


def _can_leave(thing: Any) -> bool:
    """Whether a variable of a module can be pickled. Always True for code, which must not be left out."""
    if isinstance(thing, (FunctionType, type, ModuleType)):
        return True
    try:
        _Pickler(io.BytesIO(), False).dump(thing)
    except Exception:  # what a user's object raises can be anything
        return False
    return True


def dumps(thing: Any) -> bytes:
    """Pickles an object by value, without variables of the user's modules that cannot be pickled. Raises if any other
    part cannot be pickled, such as a connection or a generator."""
    file = io.BytesIO()
    try:
        _Pickler(file, False).dump(thing)
    except Exception:  # as above
        file = io.BytesIO()
        _Pickler(file, True).dump(thing)
    return file.getvalue()


def loads(data: bytes) -> Any:
    """Unpickles an object. Its classes are new ones, even if the same bytes were unpickled before."""
    cloudpickle.cloudpickle._DYNAMIC_CLASS_TRACKER_BY_ID.clear()
    return pickle.loads(data)
