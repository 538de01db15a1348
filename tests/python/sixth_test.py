"""A package with a sixth world (tests/sixth), which only its own file and the list of worlds name, can race in it."""

import os
import pathlib
import subprocess
import sys

import labmouse
import pytest

SIX_WORLDS = pathlib.Path(labmouse.__file__).parents[2] / "tests/python"


def printed(program: str) -> "list[str]":
    """The words that a program prints which uses the package with six worlds."""
    if not (SIX_WORLDS / "labmouse").is_dir():
        pytest.skip("the package with six worlds is built with the tests: LABMOUSE_TESTS")
    environment = {**os.environ, "PYTHONPATH": str(SIX_WORLDS)}
    ran = subprocess.run(
        [sys.executable, "-B", "-c", "import labmouse\n" + program],
        capture_output=True, text=True, check=False, env=environment,
    )  # fmt: skip
    assert ran.returncode == 0, ran.stderr
    return ran.stdout.split()


def test_is_raced_with_its_noise():
    finished = printed("""
import json
for noise in (0, 9):
    race = labmouse.race("flood", "contest-01", world="battery", robot="half", noise=noise, runs=20, progress=False)
    print(race.world, json.loads(race.to_json())["groups"][0]["mice"][0]["finished"])
""")
    assert finished[:3] == ["battery", "20", "battery"]
    assert int(finished[3]) < 20


def test_asks_a_mouse_in_python():
    assert printed("""
class Still:
    def __init__(self, briefing):
        self.world = briefing.world

    def decide(self, seen):
        return "forfeit"

record = labmouse.run(Still, "contest-01", world="battery", debug=True)
print(record.world)
""") == ["battery"]
