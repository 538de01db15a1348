"""The package and the command under test are those of PYTHONPATH and PATH: scripts/test-python sets both."""

import subprocess

import pytest


@pytest.fixture
def command():
    """Runs the command with these words; gives its standard output, or its standard error where it fails."""

    def run(*words: str) -> str:
        ran = subprocess.run(["labmouse", *words], capture_output=True, text=True, check=False)
        return ran.stdout if ran.returncode == 0 else ran.stderr

    return run
