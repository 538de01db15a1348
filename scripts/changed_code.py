"""Which files have changed since a commit in more than comments and layout: a comment cannot need an #include, and holds
nothing that clang-tidy finds."""

import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TOKENS = re.compile(r'''
    (?P<kept>R"(?P<mark>[^()\\\s]{0,16})\(.*?\)(?P=mark)"   # a raw string
           | "(?:\\.|[^"\\\n])*" | (?<![0-9A-Fa-f])'(?:\\.|[^'\\\n])+')
  | (?://[^\n]* | /\*.*?\*/ | \s)+''', re.DOTALL | re.VERBOSE)


def code_of(text):
    """The text without comments, with one blank for each gap."""
    return TOKENS.sub(lambda token: token["kept"] or " ", text)


def git(*words):
    return subprocess.run(["git", *words], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)


def changed_code(commit, *folders):
    """The files of the folders whose code has changed since the commit; None if the commit is not in this clone."""
    names = git("diff", "--name-only", "--no-renames", commit, "--", *folders)
    if names.returncode:
        return None

    def same(name):
        path, before = ROOT / name, git("show", f"{commit}:{name}")
        return path.exists() and before.returncode == 0 and code_of(before.stdout) == code_of(path.read_text())

    return {name for name in names.stdout.split() if not same(name)}
