"""The identity of a mouse in Python in a store covers its name and all that decides how it plays, and nothing else."""

import functools
import importlib
import os
import platform
import py_compile
import subprocess
import sys
import textwrap
import types

import labmouse
import numpy as np
import pytest
from labmouse._identity import Walk, identity_of

MAZE = "contest-01"
wait = 1
table = {"wait": 1}


class Waiter:
    """Waits for `wait` steps, then gives up."""

    wait = 1

    def __init__(self):
        self.left = self.steps()

    def steps(self):
        return self.wait

    def decide(self, seen):
        self.left -= 1
        return "forfeit" if self.left < 0 else (0, 0)


def by_closure(number):
    class Mouse(Waiter):
        def steps(self):
            return number

    return Mouse


def by_default(number):
    class Mouse(Waiter):
        def steps(self, number=number):
            return number

    return Mouse


def by_type(number):
    return type("Mouse", (Waiter,), {"wait": number})


def by_attribute(number):
    class Mouse(Waiter):
        pass

    Mouse.wait = number
    return Mouse


def by_global(number):
    globals()["wait"] = number

    class Mouse(Waiter):
        def steps(self):
            return wait

    return Mouse


def by_part_of_a_global(number):
    table["wait"] = number

    class Mouse(Waiter):
        def steps(self):
            return table["wait"]

    return Mouse


def by_base_class(number):
    Base = type("Base", (Waiter,), {"wait": number})
    return type("Mouse", (Base,), {})


def by_helper(number):
    def helper():
        return number

    class Mouse(Waiter):
        def steps(self):
            return helper()

    return Mouse


def by_module(number):
    module = types.ModuleType("settings_of_a_test")
    module.wait = number

    class Mouse(Waiter):
        def steps(self):
            return module.wait

    return Mouse


def by_literal(number):
    space = {"Waiter": Waiter}
    exec(f"class Mouse(Waiter):\n    def steps(self):\n        return {number}", space)
    return space["Mouse"]


def by_closure_of_an_installed_module(number):
    # As in an installed module with a factory of policies.
    space = vars(textwrap)
    exec("def made_by_a_test(number):\n    return lambda: number", space)
    ask = space.pop("made_by_a_test")(number)

    class Mouse(Waiter):
        def steps(self):
            return ask()

    return Mouse


def by_bound_method(number):
    class Keeper:
        def __init__(self, number):
            self.number = number

        def ask(self):
            return self.number

    ask = Keeper(number).ask

    class Mouse(Waiter):
        def steps(self):
            return ask()

    return Mouse


def by_object(number):
    class Maker:
        def __init__(self, number):
            self.number = number

        def __call__(self):
            return by_type(self.number)()

    return Maker(number)


def by_partial(number):
    return functools.partial(lambda number: by_type(number)(), number)


def by_cache(number):
    @functools.lru_cache
    def cached():
        return number

    class Mouse(Waiter):
        def steps(self):
            return cached()

    return Mouse


WAYS = [by_closure, by_default, by_type, by_attribute, by_global, by_part_of_a_global, by_base_class, by_helper, by_module, by_literal,
        by_bound_method, by_closure_of_an_installed_module, by_object, by_partial, by_cache]


def held(mouse, store, name="mouse", **options):
    """Runs a contest. Returns its steps, and whether it came from the store."""
    race = labmouse.race({name: mouse}, MAZE, store=store, **options)
    return int(race.table["search_steps"][0]) - 1, race.from_store > 0


@pytest.mark.parametrize("way", WAYS, ids=lambda way: way.__name__)
@pytest.mark.parametrize("label", [None, "v1"])
def test_a_mouse_with_another_parameter_is_another_mouse(tmp_path, way, label):
    store = tmp_path / "results.db"
    assert [held(way(number), store, label=label) for number in (1, 2, 1, 2)] == [(1, False), (2, False), (1, True), (2, True)]


@pytest.mark.parametrize("label", [None, "v1"])
def test_a_name_and_a_label_are_a_part_of_it(tmp_path, label):
    store = tmp_path / "results.db"
    mice = {"one": by_type(1), "two": by_type(2)}
    for from_store in (0, 2):
        race = labmouse.race(mice, MAZE, store=store, label=label)
        assert race.from_store == from_store and race.table["search_steps"].tolist() == [2, 3]
    assert held(by_type(1), store, name="other", label=label) == (1, False)
    assert held(by_type(1), store, name="one", label="v2") == (1, False)


PROGRAM = """
import importlib, sys
from pathlib import Path
folder = Path({folder!r})
sys.path.insert(0, str(folder))
import labmouse

def race(file=None, before="", after=""):
    for name in [name for name in sys.modules if name.partition(".")[0] == "mine"]:
        del sys.modules[name]
    importlib.invalidate_caches()
    text = (folder / file).read_text() if file else ""
    if file:
        (folder / file).write_text(text.replace(before, after))
    held = labmouse.race(importlib.import_module("mine.mouse").Mouse, "contest-01", store=folder / "results.db")
    header, contest = (line.split(",") for line in held.to_csv().splitlines())
    print(int(contest[header.index("search_steps")]) - 1, held.from_store)
    if file:
        (folder / file).write_text(text)

for change in {changes!r}:
    race(*change)
"""
#: A mouse with a base class in another file, an imported helper, and modules that are imported only during a contest.
FILES = {
    "mine/__init__.py": "",
    "mine/mouse.py": """
        from . import base
        from .helper import helped
        unrelated = 1

        class Mouse(base.Base):
            def steps(self):
                from . import late
                return helped() + late.more() + self.wait
        """,
    "mine/base.py": """
        class Base:
            wait = 100

            def __init__(self):
                self.left = self.steps()

            def decide(self, seen):
                self.left -= 1
                return "forfeit" if self.left < 0 else (0, 0)
        """,
    "mine/helper.py": """
        from .numbers import number

        def helped():
            return number
        """,
    "mine/numbers.py": "number = 10",
    "mine/late.py": "from mine.later import MORE\n\ndef more():\n    return MORE",
    "mine/later.py": "MORE = 1",
}
CHANGES = [
    ("mine/base.py", "wait = 100", "wait = 200", 211), ("mine/numbers.py", "10", "20", 121), ("mine/later.py", "1", "2", 112),
    ("mine/helper.py", "return number", "return number + 5", 116),
]


def raced_elsewhere(folder, hash_seed, changes):
    """Runs a contest in another process for each change of the files: a list of (steps, contests from the store)."""
    code = PROGRAM.format(folder=str(folder), changes=changes)
    environment = {**os.environ, "PYTHONHASHSEED": hash_seed, "PYTHONDONTWRITEBYTECODE": "1"}
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, env=environment)
    assert ran.returncode == 0, ran.stderr
    return [tuple(map(int, line.split())) for line in ran.stdout.splitlines()]


def test_another_process_knows_it_again(tmp_path):
    (tmp_path / "mine").mkdir()
    for name, text in FILES.items():
        (tmp_path / name).write_text(textwrap.dedent(text))
    assert raced_elsewhere(tmp_path, "1", [()]) == [(111, 0)]
    # Comments and line numbers do not count.
    remark = ("mine/mouse.py", "unrelated = 1", "# mine\n\nunrelated = 2")
    assert raced_elsewhere(tmp_path, "2", [remark, *(change[:3] for change in CHANGES)]) == [
        (111, 1), *((change[3], 0) for change in CHANGES)]


def test_what_reads_something_from_outside_states_a_version(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    store, data = tmp_path / "results.db", tmp_path / "wait.txt"
    data.write_text("1")

    class Reader(Waiter):
        def steps(self):
            with open("wait.txt") as file:
                return int(file.read())

    class Environment(Waiter):
        def steps(self):
            return int(os.environ["HOME"] == "")

    for mouse in (Reader, Environment):
        with pytest.raises(labmouse.Error, match="^[^\n]*'mouse'[^\n]*version[^\n]*$"):
            held(mouse, store)
        assert not labmouse.race(mouse, MAZE).from_store
    assert [held(Reader, store, label="v1") for _ in range(2)] == [(1, False), (1, True)]
    # The content of a file that the code names counts.
    data.write_text("2")
    assert held(Reader, store, label="v1") == (2, False)
    Reader.version = 1
    assert [held(Reader, store) for _ in range(2)] == [(2, False), (2, True)]
    Reader.version = 2
    assert held(Reader, store) == (2, False)


def test_a_learned_mouse_is_told_by_its_weights(tmp_path):
    learn = pytest.importorskip("labmouse.learn")
    learned = learn.Learned.load()
    mice = {"one": learned, "two": learned.shuffled()}
    options = dict(mazes=MAZE, budget=30, store=tmp_path / "results.db", label="v1")
    assert labmouse.race(mice, **options).from_store == 0
    assert labmouse.race({"one": learned.shuffled()}, **options).from_store == 0
    assert labmouse.race({"one": learn.Learned.load()}, **options).from_store > 0


def test_a_mouse_with_dice_has_several_contests():
    import random
    from random import choice

    import numpy

    class Dicer(Waiter):
        def steps(self):
            return random.randrange(3)

    class Chooser(Waiter):
        def steps(self):
            return choice((1, 2))

    class Numpy(Waiter):
        def steps(self):
            return int(numpy.random.default_rng(1).integers(3))

    class Told(Waiter):
        def __init__(self, told):
            self.left = told.seed % 3

    class Held(Waiter):
        dice = random.Random(1)

        def steps(self):
            return self.dice.randrange(3)

    class Sober(Dicer):
        uses_chance = False

    counts = labmouse.race([Dicer, Chooser, Numpy, Told, Held, Sober, Waiter], MAZE, runs=2).table["mouse"].value_counts()
    assert counts.to_dict() == {"Dicer": 2, "Chooser": 2, "Numpy": 2, "Told": 2, "Held": 2, "Sober": 1, "Waiter": 1}


def test_versions_of_python_and_of_packages_are_a_part_of_it():
    class Mouse(Waiter):
        def steps(self):
            return int(np.int64(1)) + len(labmouse.__name__)

    lines = identity_of(Walk().go(Mouse), "mouse", Mouse, None).splitlines()
    assert any(platform.python_version() in line for line in lines)
    assert any("numpy" in line and np.__version__ in line for line in lines)
    assert any(line.startswith("labmouse ") for line in lines)


def test_a_compiled_module_is_known_by_its_file(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(tmp_path)
    source, name = tmp_path / "source_of_a_test.py", "compiled_of_a_test"

    def digest(number):
        source.write_text(f"def steps():\n    return {number}\n")
        py_compile.compile(str(source), cfile=str(tmp_path / f"{name}.pyc"))
        importlib.invalidate_caches()
        monkeypatch.delitem(sys.modules, name, raising=False)
        module = importlib.import_module(name)

        class Mouse(Waiter):
            def steps(self):
                return module.steps()

        return Walk().go(Mouse).digest.hexdigest()

    assert digest(1) == digest(1) != digest(2)
