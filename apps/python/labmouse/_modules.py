"""Which modules are the user's own: they are sent to other processes by value, and tell one mouse from another."""

import functools
import os
import site
import sys
import sysconfig
from importlib.machinery import SOURCE_SUFFIXES
from types import ModuleType


@functools.lru_cache(maxsize=None)
def _installed() -> "tuple[str, ...]":
    """Folders of what was installed, and of Python itself."""
    folders = [sysconfig.get_path(name) for name in ("stdlib", "platstdlib", "purelib", "platlib")]
    folders += [*site.getsitepackages(), site.getusersitepackages()]
    return tuple(os.path.join(os.path.realpath(folder), "") for folder in folders if folder)


@functools.lru_cache(maxsize=None)
def _is_installed(file: str) -> bool:
    return os.path.realpath(file).startswith(_installed())


def is_own(module: ModuleType) -> bool:
    """Whether a module of Python source was written by the user: neither Python's, nor labmouse's, nor installed."""
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
    """Whether a function or class was written in a module of the user's own, or in none that is left."""
    module = sys.modules.get(getattr(thing, "__module__", None) or "")
    return module is None or is_own(module)
