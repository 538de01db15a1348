"""scripts/mutate finds programs that end badly, makes the same files of the same seed, and finds nothing in labmouse.

usage: mutate_test.py ROOT [PROGRAM]
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop(1))
PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else None


class Mutate(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def mutate(self, program, *options):
        return subprocess.run([sys.executable, "-B", str(ROOT / "scripts" / "mutate"), "--program", str(program), "--one",
                               "--keep", str(self.folder / "kept"), *options], capture_output=True, text=True, check=False)

    def with_program(self, script, *options):
        program = self.folder / "program"
        program.write_text(f"#!/bin/sh\n{script}\n")
        program.chmod(0o755)
        return self.mutate(program, "--files", "3", *options)

    def kept(self):
        return list((self.folder / "kept").glob("*"))

    def test_success_and_messages_are_good(self):
        for script in ("exit 0", "exit 1", "echo 'x: error: y' >&2; exit 2"):
            self.assertEqual(self.with_program(script).returncode, 0, script)
        self.assertEqual(self.kept(), [])

    def test_other_ends_are_findings(self):
        for script in ("kill -SEGV $$", "exit 3", "exit 2", "echo 'error: std::bad_alloc' >&2; exit 2",
                       "echo 'error: [json.exception.type_error.302] type' >&2; exit 2"):
            self.assertEqual(self.with_program(script).returncode, 1, script)
        self.assertEqual(len(self.kept()), 3)

    def test_a_seed_gives_the_same_files(self):
        seen = []
        for seed in ("1", "1", "2"):
            log = self.folder / f"log{len(seen)}"
            self.with_program(f"for word; do [ -f \"$word\" ] && cksum < \"$word\"; done >>'{log}'\nexit 0",
                              "--seed", seed, "--jobs", "1", "--files", "13")
            seen.append(log.read_text())
        self.assertEqual(seen[0], seen[1])
        self.assertNotEqual(seen[0], seen[2])

    @unittest.skipIf(PROGRAM is None, "no program was named")
    def test_labmouse_ends_well(self):
        run = self.mutate(PROGRAM, "--files", "60", "--jobs", "1")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)


if __name__ == "__main__":
    unittest.main()
