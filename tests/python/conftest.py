"""Fixtures. The tested package and command are those of PYTHONPATH and PATH, which scripts/test-python sets."""

import subprocess

import labmouse
import pytest


@pytest.fixture
def command():
    """Runs the command with these words. Returns its standard output or, if it fails, its standard error."""

    def run(*words: str) -> str:
        ran = subprocess.run(["labmouse", *words], capture_output=True, text=True, check=False)
        return ran.stdout if ran.returncode == 0 else ran.stderr

    return run


@pytest.fixture
def programs():
    """Skips a test of external mice if the package was built without them."""
    with pytest.raises(labmouse.Error) as error:
        labmouse.race("program:no-such-program")
    if "starts no programs" in str(error.value):
        pytest.skip("this package starts no programs: LABMOUSE_EXTERNAL is off")
