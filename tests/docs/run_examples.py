#!/usr/bin/env python3
"""Runs the examples of a Markdown page and compares what they print with what the page says.

usage: run_examples.py PAGE.md PROGRAM

In a block marked `console`, each line after `$ ` is a command, which lines after `> ` right below it continue, and the
lines below it are what it prints. A line `...` stands for any lines; `...` at the end of a line for any rest of it, the
blanks before it among them. All blocks of a page run in one new folder that has the project's `templates`,
`include` and `firmware`, in order, by `sh`; `labmouse` is PROGRAM. A block marked with a language and a name, as in `python
robot.py`, is saved as a file of that name. Blocks marked otherwise are not run. A comment `<!-- needs: COMMAND -->` skips
the page, with exit code 77, where that command fails. With LABMOUSE_UPDATE_EXAMPLES=1 in the environment, the page gets
what its commands print today, with `...` where it had them: read the difference before you commit it.
"""

import os
import re
import subprocess
import sys
import tempfile


def examples(page):
    """The examples of a page, each as [line number, command, expected lines]."""
    found = []
    inside = saving = False
    for number, line in enumerate(page.splitlines(), 1):
        if saving:
            found[-1][1] += "\nend of file" if line == "```" else "\n" + line
            saving = line != "```"
        elif line.startswith("```"):
            inside = line == "```console"
            saving = " " in line
            if saving:
                found.append([number, f"cat > {line.split()[1]} <<'end of file'", []])
        elif inside and line.startswith("$ "):
            found.append([number, line[2:], []])
        elif inside and found and (line == ">" or line.startswith("> ")) and not found[-1][2]:
            found[-1][1] += "\n" + line[2:]
        elif inside and found:
            found[-1][2].append(line)
    return found


def agrees(expected, printed):
    """Whether printed lines fit the expected ones with their ellipses."""
    pattern = ""
    for line in expected:
        if line.strip() == "...":
            pattern += r"(?:.*\n)*?"
        elif line.endswith("..."):
            # The blanks before it too: how wide a column of times is depends on the times.
            pattern += re.escape(line[:-3].rstrip()) + r".*\n"
        else:
            pattern += re.escape(line.rstrip()) + r"[ ]*\n"
    return re.fullmatch(pattern, printed) is not None


def updated(expected, printed):
    """What an example's lines would be today, with the ellipses that they have."""
    lines = printed.splitlines()
    whole = [i for i, line in enumerate(expected) if line.strip() == "..."]
    before, after = (whole[0], len(expected) - whole[-1] - 1) if whole else (len(expected), 0)
    if not whole and len(lines) != len(expected):
        return lines
    now = lines[:before] + (["..."] if whole else []) + (lines[len(lines) - after:] if after else [])
    old = expected[:before] + (["..."] if whole else []) + (expected[len(expected) - after:] if after else [])
    return [line[:len(was) - 3] + "..." if was.endswith("...") and was.strip() != "..." and len(line) > len(was) - 3
            else line.rstrip() for line, was in zip(now, old)]


def update(page, changes):
    """Writes the lines of examples anew, from the last to the first, so that earlier numbers stay."""
    with open(page, encoding="utf-8") as file:
        lines = file.read().splitlines()
    for number, expected, printed in reversed(changes):
        first = number
        while lines[first].startswith("> "):
            first += 1
        lines[first:first + len(expected)] = updated(expected, printed)
    with open(page, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


def main():
    page, program = sys.argv[1], os.path.abspath(sys.argv[2])
    with open(page, encoding="utf-8") as file:
        text = file.read()
    found = examples(text)
    failures, changes = 0, []
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(program, os.path.join(folder, "labmouse"))
        environment = dict(os.environ, PATH=folder + ":" + os.environ["PATH"], NO_COLOR="1")
        work = os.path.join(folder, "work")
        os.mkdir(work)
        # The pages name these as one sees them from the project's own folder.
        for name in ("templates", "include", "firmware"):
            project = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
            os.symlink(os.path.join(project, name), os.path.join(work, name))
        for need in re.findall(r"<!-- needs: (.*) -->", text):
            if subprocess.run(["sh", "-c", need], cwd=work, env=environment, capture_output=True).returncode != 0:
                print(f"{page}: skipped: `{need}` fails")
                return 77
        for number, command, expected in found:
            run = subprocess.run(["sh", "-c", command], cwd=work, env=environment, stdin=subprocess.DEVNULL,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120)
            if not agrees(expected, run.stdout):
                failures += 1
                changes.append((number, expected, run.stdout))
                print(f"{page}:{number}: `{command}` prints (exit {run.returncode}):\n{run.stdout}"
                      "where the page says:\n" + "\n".join(expected) + "\n")
    if os.environ.get("LABMOUSE_UPDATE_EXAMPLES"):
        update(page, changes)
    print(f"{page}: {len(found)} examples, {failures} wrong")
    return 1 if failures or not found else 0


if __name__ == "__main__":
    sys.exit(main())
