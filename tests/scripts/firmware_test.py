"""The archives of scripts/firmware: what they hold, their versions, and whether their examples compile.

usage: firmware_test.py SOURCE_DIR
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv.pop(1)).resolve()


def archives_in(folder):
    subprocess.run([SOURCE / "scripts/firmware", "--archives", folder], check=True, stdout=subprocess.DEVNULL)
    return sorted(pathlib.Path(folder).iterdir())


class Archives(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.archives = archives_in(self.folder / "archives")
        self.libraries = []
        for archive in self.archives:
            place = self.folder / archive.name.split("-")[1]
            shutil.unpack_archive(archive, place)
            self.libraries.append(next(place.rglob("library.json")).parent)

    def test_there_is_one_for_arduino_and_one_for_platformio(self):
        self.assertEqual([archive.name.split("-")[1] for archive in self.archives], ["arduino", "platformio"])

    def test_all_versions_are_that_of_the_project(self):
        version = re.search(r"project\(labmouse VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text())[1]
        for archive, library in zip(self.archives, self.libraries):
            self.assertIn(f"-{version}.", archive.name)
            self.assertEqual(json.loads((library / "library.json").read_text())["version"], version)
            self.assertIn(f"version={version}", (library / "library.properties").read_text().splitlines())

    def test_both_hold_the_same_files_and_these_are_all_exported(self):
        for library in self.libraries:
            files = sorted(str(file.relative_to(library)) for file in library.rglob("*") if file.is_file())
            description = json.loads((library / "library.json").read_text())
            self.assertEqual(sorted(description["export"]["include"]), files)
            for header in description["headers"]:
                self.assertIn(f"src/{header}", files)
            for example in description["examples"]:
                for file in example["files"]:
                    self.assertIn(f"{example['base']}/{file}", files)

    def test_they_hold_the_header_for_small_chips_and_every_example_as_they_are(self):
        sources = [SOURCE / "firmware/labmouse_tiny.h", *(SOURCE / "firmware").rglob("*.ino")]
        for library in self.libraries:
            theirs = {file.name: file.read_bytes() for kind in ("*.h", "*.ino") for file in library.rglob(kind)}
            self.assertEqual(theirs, {file.name: file.read_bytes() for file in sources})

    def test_the_description_for_arduino_has_what_its_specification_requires(self):
        for library in self.libraries:
            lines = (library / "library.properties").read_text().splitlines()
            keys = [line.split("=")[0] for line in lines]
            for key in ("name", "version", "author", "maintainer", "sentence", "paragraph", "category", "architectures"):
                self.assertIn(key, keys)

    def test_their_examples_compile_outside_of_the_sources(self):
        for library in self.libraries:
            for example in library.rglob("*.ino"):
                subprocess.run(["c++", "-std=c++11", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-I", library / "src",
                                "-I", SOURCE / "tests/firmware/arduino", "-x", "c++", example], check=True)

    def test_they_are_the_same_bytes_each_time(self):
        for archive, again in zip(self.archives, archives_in(self.folder / "again")):
            self.assertEqual(archive.read_bytes(), again.read_bytes())


if __name__ == "__main__":
    unittest.main()
