"""Decides which modules are the user's own: these are sent to other processes by value, and identities include them."""

import dis
import functools
import os
import site
import sys
import sysconfig
from importlib.machinery import SOURCE_SUFFIXES, ModuleSpec
from types import CodeType, ModuleType
from typing import Any

_GLOBAL = ("LOAD_GLOBAL", "STORE_GLOBAL", "DELETE_GLOBAL", "LOAD_NAME", "LOAD_FROM_DICT_OR_GLOBALS")


@functools.lru_cache(maxsize=None)
def _installed() -> "tuple[str, ...]":
    """The folders of installed packages and of Python itself."""
    folders = [sysconfig.get_path(name) for name in ("stdlib", "platstdlib", "purelib", "platlib")]
    folders += [*site.getsitepackages(), site.getusersitepackages()]
    return tuple(os.path.join(os.path.realpath(folder), "") for folder in folders if folder)


@functools.lru_cache(maxsize=None)
def _is_installed(file: str) -> bool:
    return os.path.realpath(file).startswith(_installed())


def is_own(module: ModuleType) -> bool:
    """Whether a module is the user's own Python source: not part of Python, not of labmouse, not installed."""
    name = module.__name__
    top = name.partition(".")[0]
    if name == "__main__":
        return True
    if top in sys.stdlib_module_names or top == "labmouse" or name in sys.builtin_module_names:
        return False
    file = getattr(module, "__file__", None)
    if file:
        return file.endswith(tuple(SOURCE_SUFFIXES)) and not _is_installed(file)
    folders = list(getattr(module, "__path__", []))
    return not any(_is_installed(folder) for folder in folders)


def is_of_own(thing: object) -> bool:
    """Whether a function or class must be sent by value: its module is the user's own, or does not contain it.

    The latter holds for closures of installed modules and for classes that `exec` makes in a namespace without a name.
    """
    module = sys.modules.get(getattr(thing, "__module__", None) or "")
    return module is None or is_own(module) or not _has(module, thing)


def _has(module: ModuleType, thing: object) -> bool:
    """Whether a thing can be found in the module by its qualified name. True if it has no name."""
    place: Any = module
    for name in getattr(thing, "__qualname__", "").split("."):
        place = getattr(place, name, None) if name else thing
    return place is thing


def installed_with(space: "dict[str, Any]") -> "ModuleType | None":
    """The module of these globals if it is not the user's own, otherwise None.

    A function that a decorator of an installed module made has such globals, although it is sent by value.
    """
    module = sys.modules.get(space.get("__name__", ""))
    return module if module is not None and vars(module) is space and not is_own(module) else None


def own_file_of(name: str, spec: "ModuleSpec | None" = None) -> "str | None":
    """The file of a module, source or compiled; None if it is installed, or part of Python or labmouse."""
    if name.partition(".")[0] in sys.stdlib_module_names or name.partition(".")[0] == "labmouse":
        return None
    file = spec.origin if spec is not None else getattr(sys.modules.get(name), "__file__", None)
    return file if file and os.path.isfile(file) and not _is_installed(file) else None


@functools.lru_cache(maxsize=4096)
def global_names(code: CodeType, nested: bool = True) -> "frozenset[str]":
    """The global names that code uses, class bodies included. `nested`: also those of functions defined in it."""
    found = {str(instruction.argval) for instruction in dis.get_instructions(code) if instruction.opname in _GLOBAL}
    for part in code.co_consts if nested else ():
        if isinstance(part, CodeType):
            found |= global_names(part)
    return frozenset(found)
