"""The identity of a mouse in Python for stores of contests: a digest of all that decides how it plays.

The digest changes whenever the mouse may play differently. It covers the content of code, closures, attributes, globals
that code uses, base classes and the user's modules, and the versions of installed packages. File names and line numbers
do not count.
"""

import copyreg
import functools
import hashlib
import importlib.util
import os
import platform
import random
import sys
from pathlib import Path
from types import BuiltinFunctionType, CellType, CodeType, FunctionType, MappingProxyType, MethodType, ModuleType
from typing import Any

from ._by_value import reduced
from ._modules import global_names, installed_with, is_of_own, is_own, own_file_of
from ._packages import imports_of, versions_of
from ._workers import HASH_ORDERS

#: Names, attributes and modules by which code may reach things outside of it, such as files and the clock.
_OUTSIDE_NAMES = frozenset({"open", "exec", "eval", "__import__", "input"})
_OUTSIDE_ATTRIBUTES = frozenset({
    "environ", "environb", "getenv", "read_text", "read_bytes", "fromfile", "memmap", "load", "loadtxt", "genfromtxt", "read_csv",
    "read_json", "read_pickle", "read_parquet", "listdir", "scandir", "walk", "iterdir", "import_module", "argv", "stdin", "getcwd",
    "getpid", "cpu_count", "urandom", "system", "popen", "now", "today", "InferenceSession"})
_OUTSIDE_MODULES = frozenset({
    "time", "datetime", "subprocess", "socket", "ctypes", "urllib", "http", "requests", "sqlite3", "shelve", "dbm", "mmap",
    "multiprocessing", "tempfile", "glob", "fileinput", "runpy", "pathlib", "io", "gzip", "bz2", "lzma", "zipfile", "tarfile",
    "secrets", "uuid"})
#: Attributes and modules by which code may reach random numbers.
_CHANCE_ATTRIBUTES = frozenset({"random", "seed", "default_rng", "RandomState", "SystemRandom", "urandom", "uuid4", "secrets"})
_CHANCE_MODULES = ("random", "secrets", "uuid", "numpy.random")
#: A longer string constant is not taken for a file name.
_LONGEST_NAME = 300
#: Attributes that every class has, or that depend on how it was used.
_NO_PART_OF_A_CLASS = frozenset({"__dict__", "__weakref__", "_abc_impl", "__firstlineno__", "__static_attributes__"})


class Walk:
    """Walks through an object and all its parts. Computes their `digest`, and notes names of things `outside` of the
    code, the use of random numbers (`chance`), installed `packages`, and files of imported modules (`sources`)."""

    def __init__(self) -> None:
        self.digest = hashlib.sha256()
        self.outside: set[str] = set()
        self.chance = False
        self.packages: set[str] = set()
        self.sources: set[str] = set()
        self._numbers: dict[int, int] = {}
        self._kept: list[object] = []
        self._in_modules = 0

    def go(self, thing: Any) -> "Walk":
        """Adds a thing and its parts."""
        if thing is None or isinstance(thing, (bool, int, float, complex, str, bytes)) and type(thing).__module__ == "builtins":
            self._add(type(thing).__name__, thing if isinstance(thing, bytes) else repr(thing))
        elif type(thing) is tuple:
            self._several("tuple", thing)
        elif type(thing) in (set, frozenset):
            self._add(type(thing).__name__, *sorted(self._apart(part) for part in thing))
        elif type(thing) is CodeType:
            self._code(thing)
        elif id(thing) in self._numbers:
            self._add("again", str(self._numbers[id(thing)]))
        else:
            self._numbers[id(thing)] = len(self._numbers)
            self._kept.append(thing)
            self._whole(thing)
        return self

    def _add(self, *texts: "str | bytes") -> None:
        for text in texts:
            data = text if isinstance(text, bytes) else text.encode("utf-8", "surrogatepass")
            self.digest.update(b"%d:" % len(data) + data)

    def _several(self, kind: str, things: Any) -> None:
        parts = list(things)
        self._add(kind, str(len(parts)))
        for part in parts:
            self.go(part)

    def _apart(self, thing: Any) -> str:
        """The digest of a part of an unordered set, computed apart so that the parts can be sorted."""
        other = Walk()
        other.outside, other.packages, other.sources = self.outside, self.packages, self.sources
        other._in_modules = self._in_modules
        other.go(thing)
        self.chance = self.chance or other.chance
        return other.digest.hexdigest()

    def _whole(self, thing: Any) -> None:
        if type(thing) is list:
            self._several("list", thing)
        elif type(thing) in (dict, MappingProxyType):
            self._several("dict", [part for item in thing.items() for part in item])
        elif isinstance(thing, FunctionType):
            self._function(thing) if is_of_own(thing) else self._reference(thing)
        elif isinstance(thing, type):
            self._class(thing) if is_of_own(thing) and thing.__flags__ & 1 << 9 else self._reference(thing)
        elif isinstance(thing, ModuleType):
            self._module(thing)
        elif isinstance(thing, CellType):
            self._several("cell", self._contents(thing))
        elif isinstance(thing, (staticmethod, classmethod)):
            self._several(type(thing).__name__, [thing.__func__])
        elif isinstance(thing, property):
            self._several("property", [thing.fget, thing.fset, thing.fdel])
        elif isinstance(thing, (MethodType, BuiltinFunctionType)) and not isinstance(thing.__self__, (ModuleType, type(None))):
            self._method(thing)
        elif isinstance(thing, BuiltinFunctionType):
            self._reference(thing)
        else:
            self._object(thing)

    @staticmethod
    def _contents(cell: CellType) -> "list[object]":
        try:
            return [cell.cell_contents]
        except ValueError:  # it has none yet
            return []

    def _method(self, method: Any) -> None:
        owner = method.__self__
        self._add("method", method.__name__)
        numpy = sys.modules.get("numpy.random.mtrand")
        if owner is random._inst or numpy is not None and owner is numpy._rand:
            self.chance = True
        else:
            self._several("of", [owner, getattr(method, "__func__", None)])

    def _function(self, function: FunctionType) -> None:
        code, space = function.__code__, function.__globals__
        self._add("function", function.__name__)
        self._code(code, space.get("__package__") or "", space.get("__file__"))
        self._several("defaults", [function.__defaults__, function.__kwdefaults__, function.__dict__])
        self._several("closure", [part for cell in function.__closure__ or () for part in self._contents(cell)])
        installed = installed_with(space)
        if installed is not None:
            self._installed(installed.__name__)
        for name in sorted(global_names(code)) if installed is None else ():
            if name in space:
                self._add("global", name)
                self.go(space[name])
            elif name in _OUTSIDE_NAMES:
                self.outside.add(name)

    def _class(self, kind: type) -> None:
        self._add("class", kind.__name__)
        self._several("bases", (type(kind), *kind.__bases__))
        for name in sorted(set(vars(kind)) - _NO_PART_OF_A_CLASS):
            value = vars(kind)[name]
            if type(value).__name__ in ("member_descriptor", "getset_descriptor"):  # of __slots__
                continue
            self._add("attribute", name)
            self.go(value)

    def _module(self, module: ModuleType) -> None:
        if not is_own(module):
            self._installed(module.__name__)
            return
        self._add("module", module.__name__)
        # Variables that cannot be pickled, such as open files, are not sent, so they are not noted in `outside`.
        self._in_modules += 1
        for name in sorted(vars(module)):
            if not (name.startswith("__") and name.endswith("__")):
                self._add("variable", name)
                self.go(vars(module)[name])
        self._in_modules -= 1

    def _reference(self, thing: Any) -> None:
        self._installed(getattr(thing, "__module__", None) or "builtins")
        self._add(getattr(thing, "__qualname__", type(thing).__name__))

    def _object(self, thing: Any) -> None:
        if type(thing).__name__ in ("Random", "SystemRandom", "Generator", "RandomState"):
            self.chance = True
        try:
            reduce = copyreg.dispatch_table.get(type(thing))
            parts = reduced(thing) or (reduce(thing) if reduce is not None else thing.__reduce_ex__(4))
        except Exception:  # what a user's object raises can be anything
            self._add("unknown", type(thing).__name__)
            if not self._in_modules:
                self.outside.add(f"a {type(thing).__name__}")
            return
        if isinstance(parts, str):
            self._add("named", parts)
            self._reference(type(thing))
            return
        # The fourth and fifth parts of a __reduce__ value are iterators over items; a sixth is callable.
        whole = [part if number < 3 or part is None or callable(part) else list(part) for number, part in enumerate(parts)]
        self._kept.append(whole)
        self._several("object", [type(thing), *whole])

    def _installed(self, name: str) -> None:
        """Adds a module that other processes import, by the version of its package or by the content of its file."""
        self._add("installed", name)
        top = name.partition(".")[0]
        if name == "random" or name.startswith(_CHANCE_MODULES[1:]):
            self.chance = True
        if top in _OUTSIDE_MODULES and name != "io.StringIO":
            self.outside.add(f"the module {top}")
        if top not in sys.stdlib_module_names and top != "builtins":
            self.packages.add(top)
        file = own_file_of(name)
        if file:
            self._file(file)

    def _file(self, file: str) -> None:
        try:
            self._add("file", os.path.basename(file), hashlib.sha256(Path(file).read_bytes()).hexdigest())
        except OSError:
            self.outside.add(f"the file {file}")

    def _code(self, code: CodeType, package: str = "", file: "str | None" = None) -> None:
        self._add("code", code.co_name, code.co_code, getattr(code, "co_exceptiontable", b""))
        self._several("names", [code.co_names, code.co_varnames, code.co_freevars, code.co_cellvars, code.co_flags,
                                code.co_argcount, code.co_kwonlyargcount, code.co_posonlyargcount])
        self._several("constants", [part for part in code.co_consts if not isinstance(part, CodeType)])
        attributes = set(code.co_names) - global_names(code, nested=False)
        self.outside |= attributes & _OUTSIDE_ATTRIBUTES
        self.chance = self.chance or bool(set(code.co_names) & _CHANCE_ATTRIBUTES)
        for name in sorted(imports_of(code, package)):
            self._import(name)
        for part in code.co_consts:
            if isinstance(part, CodeType):
                self._code(part, package, file)
            elif isinstance(part, str):
                self._named_file(part, file)

    def _named_file(self, text: str, beside: "str | None") -> None:
        """Adds the content of a file if a string constant is its path from the working folder or the code's folder."""
        if not text or len(text) > _LONGEST_NAME or "\0" in text or "." not in text and "/" not in text:
            return
        for folder in ("", os.path.dirname(beside or "")):
            if os.path.isfile(os.path.join(folder, text)):
                self._file(os.path.join(folder, text))

    def _import(self, name: str) -> None:
        """Adds a module that code imports when it runs, with its source file and what that imports."""
        try:
            spec = importlib.util.find_spec(name)
        except (ImportError, ValueError, AttributeError):
            spec = None
        file = own_file_of(name, spec)
        if not file:
            self._installed(name)
            return
        if file in self.sources:
            return
        self.sources.add(file)
        self._file(file)
        try:
            code = compile(Path(file).read_bytes(), file, "exec", dont_inherit=True)
        except (OSError, SyntaxError, ValueError):
            return
        self._code(code, (spec.parent if spec is not None else "") or "", file)
        if _OUTSIDE_NAMES & global_names(code):
            self.outside |= _OUTSIDE_NAMES & global_names(code)


@functools.lru_cache(maxsize=None)
def _labmouse() -> str:
    """A digest of the Python files of this package, for mice that use it."""
    digest = hashlib.sha256()
    for file in sorted(Path(__file__).parent.rglob("*.py")):
        digest.update(file.read_bytes())
    return digest.hexdigest()


def identity_of(walk: Walk, name: str, maker: Any, label: "str | None") -> str:
    """The identity of a mouse as text. It differs if the mouse may play differently."""
    kind = str(getattr(maker, "__qualname__", type(maker).__qualname__))
    lines = ["python", f"name {name!r}", f"made by {kind!r}", f"digest {walk.digest.hexdigest()}",
             f"interpreter {platform.python_implementation()} {platform.python_version()}", f"orders {HASH_ORDERS}"]
    lines += [f"package {line}" for line in versions_of(walk.packages - {"labmouse"})]
    if "labmouse" in walk.packages:
        lines.append(f"labmouse {_labmouse()}")
    return "\n".join([*lines, *([f"label {label!r}"] if label else []), ""])
