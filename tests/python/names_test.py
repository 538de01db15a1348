"""Every public name has a docstring and types."""

import inspect
import subprocess
import sys
from importlib import resources
from typing import get_origin

import labmouse
import pytest

learn = pytest.importorskip("labmouse.learn")
cluster = pytest.importorskip("labmouse.cluster")
PUBLIC = [(module, name) for module in (labmouse, learn, cluster) for name in module.__all__]


def members_of(thing):
    """The public members that a class itself defines."""
    for name, member in vars(thing).items():
        if not name.startswith("_") and (callable(member) or isinstance(member, (property, classmethod, staticmethod))):
            yield name, member


def docs_of(member):
    return inspect.getdoc(member.__func__ if isinstance(member, (classmethod, staticmethod)) else member) or ""


@pytest.mark.parametrize("module, name", PUBLIC, ids=lambda part: getattr(part, "__name__", part))
def test_every_public_name_says_what_it_is(module, name):
    thing = getattr(module, name)
    if inspect.isclass(thing):
        assert docs_of(thing)
        for member_name, member in members_of(thing):
            inherited = next((vars(base)[member_name] for base in thing.__mro__[1:] if member_name in vars(base)), None)
            assert docs_of(member) or (inherited is not None and docs_of(inherited)), f"{name}.{member_name}"
    elif callable(thing) and get_origin(thing) is None:
        assert docs_of(thing)


def test_nothing_is_named_to_install_that_nobody_owns_on_an_index():
    # This package is not on an index, where anybody could take its name: hints must install from the source folder.
    program = "import sys; sys.modules['gymnasium'] = None; import labmouse.learn"
    failed = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert failed.returncode == 1 and "'.[learn]'" in failed.stderr
    for text in (failed.stderr, docs_of(cluster)):
        assert "labmouse[" not in text


def test_the_stub_is_that_of_the_compiled_part():
    # mypy, editors and the documentation site read the stub. docs/contributing/building.md has the command for it.
    stubs = pytest.importorskip("nanobind.stubgen").StubGen(labmouse._native)
    stubs.put(labmouse._native)
    assert resources.files("labmouse").joinpath("_native.pyi").read_text(encoding="utf-8") == stubs.get()
    assert resources.files("labmouse").joinpath("py.typed").is_file()
