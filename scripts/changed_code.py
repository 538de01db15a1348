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
    """The files of the folders whose code has changed since the commit, under their names of today; None if the commit is not in
    this clone. A file that was only moved is the same."""
    found = git("diff", "--name-status", "--find-renames", commit, "--", *folders)
    if found.returncode:
        return None

    def same(former, name):
        path, before = ROOT / name, git("show", f"{commit}:{former}")
        return path.exists() and before.returncode == 0 and code_of(before.stdout) == code_of(path.read_text())

    names = [line.split("\t")[1:] for line in found.stdout.splitlines()]
    return {of_file[-1] for of_file in names if not same(of_file[0], of_file[-1])}
