"""`make page` where small programs pretend to build: what it asks them for.

usage: page_test.py SOURCE_DIR
"""

import pathlib
import shutil
import sys
import tempfile
import unittest

from machine import Machine

SOURCE = pathlib.Path(sys.argv.pop(1)).resolve()


class MakePage(unittest.TestCase):
    def setUp(self):
        for name in ("machine", "clone"):
            folder = tempfile.TemporaryDirectory()
            self.addCleanup(folder.cleanup)
            setattr(self, name, pathlib.Path(folder.name))
        self.machine = Machine(self.machine)
        self.machine.add_dpkg()
        for name in ("cmake", "node", "npm", "em++"):
            self.machine.add(name)
        for tool in ("make", "cut", "stty"):
            (self.machine.folder / tool).symlink_to(shutil.which(tool))
        shutil.copy(SOURCE / "Makefile", self.clone)
        shutil.copytree(SOURCE / "scripts", self.clone / "scripts")
        page = self.clone / "apps" / "web" / "page"
        (page / "node_modules" / "vite").mkdir(parents=True)
        for file in (page / "package-lock.json", page / "node_modules" / ".installed-lock.json"):
            file.touch()

    def test_builds_the_page_and_not_the_program(self):
        result = self.machine.run("make", "--no-print-directory", "page", cwd=self.clone)
        self.assertEqual((result.returncode, result.stdout), (0, "build/page/labmouse.html\n"), result.stderr)
        built = self.machine.called("cmake")
        self.assertEqual([" ".join(call.split()[1:]) for call in built], ["--preset web", "--build --preset web"])
        self.assertEqual(len(self.machine.called("npm")), 1)


unittest.main()
