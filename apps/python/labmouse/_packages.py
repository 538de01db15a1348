"""Finds what code imports, and the versions of installed packages."""

import dis
import functools
import importlib.util
import re
import sys
from importlib import metadata
from types import CodeType
from typing import Any


def imports_of(code: CodeType, package: str) -> "set[str]":
    """The modules that code imports. `from a import b` adds a.b, too, if that is a module."""
    found: set[str] = set()
    level: Any = 0
    before: "list[Any]" = [None, None]
    module = ""
    for instruction in dis.get_instructions(code):
        if instruction.opname == "IMPORT_NAME":
            level = before[0] if isinstance(before[0], int) else 0
            module = str(instruction.argval)
            if level:
                try:
                    module = importlib.util.resolve_name("." * level + module, package)
                except (ImportError, ValueError):
                    module = ""
            if module:
                found.add(module)
        elif instruction.opname == "IMPORT_FROM" and module and _is_module(f"{module}.{instruction.argval}"):
            found.add(f"{module}.{instruction.argval}")
        before = [before[1], instruction.argval]
    return found


def _is_module(name: str) -> bool:
    try:
        return name in sys.modules or importlib.util.find_spec(name) is not None
    except (ImportError, ValueError, AttributeError):
        return False


@functools.lru_cache(maxsize=None)
def _distributions() -> "dict[str, list[str]]":
    return dict(metadata.packages_distributions())


def versions_of(packages: "set[str]") -> "list[str]":
    """Lines "name version" of packages and of all that they require; the version is "none" if it is not installed."""
    waiting = {name for package in packages for name in _distributions().get(package, [package])}
    found: dict[str, str] = {}
    while waiting:
        name = waiting.pop()
        if name in found:
            continue
        try:
            found[name] = metadata.version(name)
            required = metadata.requires(name) or []
        except metadata.PackageNotFoundError:
            found[name] = "none"
            continue
        for line in required:
            match = re.match(r"[A-Za-z0-9._-]+", line)
            if match and "extra ==" not in line:
                waiting.add(match[0])
    return [f"{name} {version}" for name, version in sorted(found.items())]
