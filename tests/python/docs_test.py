"""The Python examples of the documentation run, print what the page says, and pass mypy --strict.

All blocks of a page marked `python` are one program. A block marked `text` directly below one is its output, with `...`
for any lines or for the rest of a line, as in tests/docs/run_examples.py.
"""

import contextlib
import io
import os
import re
import subprocess
import sys
from pathlib import Path

import labmouse
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "docs"))
from run_examples import agrees  # noqa: E402

BLOCK = re.compile(r"^```python\n(.*?)^```\n(?:\n```text\n(.*?)^```\n)?", re.MULTILINE | re.DOTALL)
PAGES = [page for page in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))] if BLOCK.search(page.read_text())]


def blocks_of(page):
    """For each block of Python: the line of the page where it begins, its code, and its output or None."""
    text = page.read_text(encoding="utf-8")
    for found in BLOCK.finditer(text):
        yield text.count("\n", 0, found.start()) + 1, found[1], found[2]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_the_examples_print_what_the_page_says(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names = {"__name__": "__main__"}
    for line, code, expected in blocks_of(page):
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile("\n" * line + code, str(page), "exec"), names)
        if expected is not None:
            assert agrees(expected.splitlines(), printed.getvalue()), f"{page}:{line} prints\n{printed.getvalue()}"


def test_the_examples_are_typed(tmp_path):
    files = []
    for page in PAGES:
        file = tmp_path / f"{page.stem.lower()}_examples.py"
        file.write_text("\n".join(code for _, code, _ in blocks_of(page)), encoding="utf-8")
        files.append(file)
    checked = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--untyped-calls-exclude=distributed", *map(str, files)],
                             capture_output=True, text=True, check=False)
    assert checked.returncode == 0, checked.stdout


def test_the_package_itself_is_typed(tmp_path):
    checked = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--package", "labmouse"], capture_output=True, text=True, check=False,
                             cwd=tmp_path)
    assert checked.returncode == 0, checked.stdout


def test_the_page_on_logs_shows_what_the_program_prints_with_this_python(tmp_path):
    program = Path(labmouse.__file__).parent / "bin" / "labmouse"
    ran = subprocess.run([sys.executable, ROOT / "tests/docs/run_examples.py", ROOT / "docs/how-to/robot-from-a-log.md", program], capture_output=True, text=True,
                         check=False, cwd=tmp_path, env={**os.environ, "LABMOUSE_PYTHON": sys.executable})
    assert ran.returncode == 0, ran.stdout + ran.stderr
