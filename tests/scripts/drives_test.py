"""scripts/drives holds a controller to its figures: a program that tells other figures is refused.

usage: drives_test.py ROOT
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop(1))


def row(name, crashed=0, wrong=0, cells=500, aside=1.0):
    """A row as `labmouse drive` tells it, of ten drives."""
    readings = {"all": 1000, "wrong": wrong, "share": wrong / 1000}
    return {"name": name, "mazes": 5, "runs": 10, "crashed": crashed, "cells": cells,
            "truth": {"lateral_mm": aside, "longitudinal_mm": 1.0, "heading_degrees": 1.0},
            "side_readings": readings, "front_readings": {"all": 1000, "wrong": 0, "share": 0.0}}


class Drives(unittest.TestCase):
    def drive(self, part, *rows, mazes=("a.txt", "b.txt")):
        """The exit code of a part, where the program tells these rows."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "classic").mkdir()
            for maze in mazes:
                (folder / "classic" / maze).write_text("")
            program = folder / "program"
            program.write_text(f"#!{sys.executable}\nprint({json.dumps(json.dumps({'drives': rows}))})\n")
            program.chmod(0o755)
            return subprocess.run([sys.executable, "-B", str(ROOT / "scripts" / "drives"), part, "--mazes", name,
                                   "--program", str(program)], capture_output=True, check=False).returncode

    def test_exact_drives_neither_crash_nor_read_wrongly(self):
        self.assertEqual(self.drive("exact", row("noise 0, variation 0")), 0)
        self.assertEqual(self.drive("exact", row("noise 0, variation 0", crashed=1)), 1)
        self.assertEqual(self.drive("exact", row("noise 0, variation 0", wrong=1)), 1)

    def test_measured_noise_has_bars(self):
        self.assertEqual(self.drive("measured", row("noise 1, variation 0")), 0)
        self.assertEqual(self.drive("measured", row("noise 1, variation 0", crashed=1)), 1)
        self.assertEqual(self.drive("measured", row("noise 1, variation 0", wrong=1)), 1)

    def test_blind_mice_crash(self):
        ways = row("noise 0, variation 0", cells=1000)
        self.assertEqual(self.drive("blind", ways, row("none", crashed=9)), 0)
        self.assertEqual(self.drive("blind", ways, row("none", crashed=8)), 1)
        # Ways of 50 cells say nothing.
        self.assertEqual(self.drive("blind", row("noise 0, variation 0", cells=500), row("none", crashed=0)), 0)

    def test_no_cause_is_worse_than_all(self):
        self.assertEqual(self.drive("causes", row("all", crashed=5), row("motors", crashed=5)), 0)
        self.assertEqual(self.drive("causes", row("all", crashed=5), row("motors", crashed=6)), 1)

    def test_corrections_are_worth_something(self):
        best = row("all", crashed=1, wrong=1)
        self.assertEqual(self.drive("corrections", best, row("none", crashed=3, wrong=3, aside=2.0)), 0)
        self.assertEqual(self.drive("corrections", best, row("none", crashed=3, wrong=3, aside=0.9)), 1)
        self.assertEqual(self.drive("corrections", best, row("none", crashed=0, wrong=3, aside=2.0)), 1)

    def test_without_mazes_it_is_skipped(self):
        with tempfile.TemporaryDirectory() as name:
            run = subprocess.run([sys.executable, "-B", str(ROOT / "scripts" / "drives"), "measured", "--mazes", name],
                                 capture_output=True, check=False)
        self.assertEqual(run.returncode, 77)


if __name__ == "__main__":
    unittest.main()
