"""Fixtures. The tested package and command are those of PYTHONPATH and PATH, which scripts/test-python sets."""

import signal
import subprocess

import labmouse
import pytest


@pytest.fixture(autouse=True, scope="session")
def interruptible():
    """Lets Ctrl-C interrupt, also where a shell started the tests in the background and so lets them ignore it."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)


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
