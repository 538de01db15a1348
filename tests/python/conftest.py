"""The package and the command under test are those of PYTHONPATH and PATH: scripts/test-python sets both."""

import subprocess

import labmouse
import pytest


@pytest.fixture
def command():
    """Runs the command with these words; gives its standard output, or its standard error where it fails."""

    def run(*words: str) -> str:
        ran = subprocess.run(["labmouse", *words], capture_output=True, text=True, check=False)
        return ran.stdout if ran.returncode == 0 else ran.stderr

    return run


@pytest.fixture
def programs():
    """For mice that are programs: skips the test where the package was built without them."""
    with pytest.raises(labmouse.Error) as error:
        labmouse.race("program:no-such-program")
    if "starts no programs" in str(error.value):
        pytest.skip("this package starts no programs: LABMOUSE_GUESTS is off")
