"""scripts/quietly on builds that a small program pretends: what it says in a pipe and on a terminal, and how it ends.

usage: quietly_test.py SOURCE_DIR
"""

import os
import pathlib
import pty
import re
import subprocess
import sys
import tempfile
import unittest

QUIETLY = pathlib.Path(sys.argv.pop(1)).resolve() / "scripts" / "quietly"

# Prints what ninja prints of that many steps, and ends with that exit code.
NINJA = """
steps=$1 folder=labmouse/maze/in/a/folder/that/lies/so/deep/that/its/name/fills/a/terminal
for step in $(seq "$steps"); do
  echo "[$step/$steps] Building CXX object CMakeFiles/labmouse_maze.dir/$folder/file_$step.cpp.o"
done
echo "what the compiler says"
exit "$2"
"""


def command(steps, code=0):
    return [str(QUIETLY), "sh", "-c", NINJA, "ninja", str(steps), str(code)]


def in_pipe(steps, code=0):
    return subprocess.run(command(steps, code), stdin=subprocess.DEVNULL, capture_output=True, text=True)


def on_terminal(steps, code=0):
    """The exit code and all that a terminal of 80 columns is sent."""
    child, terminal = pty.fork()
    if child == 0:
        os.execv(QUIETLY, command(steps, code))
    shown = b""
    while True:
        try:
            part = os.read(terminal, 4096)
        except OSError:  # Linux's end of a terminal
            part = b""
        if not part:
            break
        shown += part
    os.close(terminal)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), shown.decode()


class InAPipe(unittest.TestCase):
    def test_a_long_build_says_how_much_there_is_and_then_every_tenth_part(self):
        result = in_pipe(200)
        self.assertEqual((result.returncode, result.stdout), (0, ""))
        first, *lines = result.stderr.splitlines()
        self.assertIn("200", first)
        self.assertEqual([line.split()[0] for line in lines], [f"[{20 * part}/200]" for part in range(1, 11)])
        self.assertRegex(lines[0], r"compiling labmouse/maze/.*/file_20\.cpp$")

    def test_a_step_that_jumps_over_tenth_parts_says_one_line(self):
        result = in_pipe(13)
        self.assertEqual(len(result.stderr.splitlines()), 1 + 10)

    def test_a_build_of_few_steps_goes_unsaid(self):
        result = in_pipe(2)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))

    def test_a_failure_shows_the_whole_log_and_keeps_the_exit_code(self):
        for steps in (2, 200):
            result = in_pipe(steps, 7)
            self.assertEqual(result.returncode, 7)
            self.assertIn("what the compiler says", result.stderr)
            self.assertIn(f"[1/{steps}] Building", result.stderr)

    def test_a_long_step_says_how_much_time_is_left(self):
        # The clock of this program is a file's: it stands at 0 s, 6 s and 16 s.
        with tempfile.TemporaryDirectory() as folder:
            clock = pathlib.Path(folder) / "date"
            clock.write_text(f'#!/bin/sh\ncat {folder}/now\nhead -n 1 {folder}/times >{folder}/now; sed -i 1d {folder}/times\n')
            clock.chmod(0o755)
            (pathlib.Path(folder) / "now").write_text("0\n")
            (pathlib.Path(folder) / "times").write_text("\n".join(map(str, range(6, 3000, 10))) + "\n")
            path = {"PATH": folder + ":" + os.environ["PATH"]}
            result = subprocess.run(command(100), env=path, stdin=subprocess.DEVNULL, capture_output=True, text=True)
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), 1 + 99)  # one every ten seconds
        self.assertRegex(lines[1], r"^\[2/100\].* 13 min ")
        self.assertRegex(lines[-2], r"^\[99/100\].* 9 s ")

    def test_the_log_is_kept_where_it_is_asked_for(self):
        with tempfile.TemporaryDirectory() as folder:
            for _ in range(2):
                subprocess.run([str(QUIETLY), "--log", folder + "/log", "echo", "said"], check=True)
            self.assertEqual((pathlib.Path(folder) / "log").read_text(), "said\nsaid\n")

    def test_a_last_line_without_its_end_is_kept(self):
        result = subprocess.run([str(QUIETLY), "sh", "-c", "printf 'no end'; exit 1"], capture_output=True, text=True)
        self.assertIn("no end", result.stderr)

    def test_arguments_with_blanks_stay_whole(self):
        result = subprocess.run([str(QUIETLY), "test", "a b", "=", "a b"], capture_output=True, text=True)
        self.assertEqual((result.returncode, result.stderr), (0, ""))


def has_terminals():
    try:
        for end in pty.openpty():
            os.close(end)
    except OSError:
        return False
    return True


@unittest.skipUnless(has_terminals(), "this system has no pseudo-terminals (/dev/pts is not mounted)")
class OnATerminal(unittest.TestCase):
    def test_one_line_is_rewritten_and_at_last_erased(self):
        code, shown = on_terminal(200)
        self.assertEqual(code, 0)
        self.assertNotIn("\n", shown)
        self.assertEqual(re.findall(r"\r\[(\d+)/200\]", shown), [str(step) for step in range(1, 201)])
        self.assertTrue(shown.endswith("\r\x1b[K"))

    def test_no_line_is_wider_than_the_terminal(self):
        for line in re.split(r"\r", on_terminal(200)[1]):
            self.assertLess(len(line.replace("\x1b[K", "")), 80)

    def test_nothing_to_build_shows_nothing(self):
        self.assertEqual(on_terminal(2), (0, ""))

    def test_a_failure_shows_the_log_below_the_line(self):
        code, shown = on_terminal(200, 3)
        self.assertEqual(code, 3)
        self.assertIn("what the compiler says\r\n", shown)


unittest.main()
