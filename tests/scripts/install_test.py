"""scripts/install on machines that small programs pretend: with and without dpkg, with and without what the build needs.

usage: install_test.py SOURCE_DIR
"""

import pathlib
import shutil
import sys
import tempfile
import unittest

from machine import Machine

SOURCE = pathlib.Path(sys.argv.pop(1)).resolve()
INSTALL = SOURCE / "scripts" / "install"
SYSTEMS = ("Debian", "Fedora", "Arch", "Homebrew")


class Install(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.machine = Machine(folder.name)

    def install(self, part="race"):
        return self.machine.run(INSTALL, part)

    def assert_quiet(self, result):
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))

    def test_without_dpkg_it_is_content_where_cmake_finds_everything(self):
        self.machine.add_build(found=True)
        self.assert_quiet(self.install())

    def test_without_dpkg_it_names_the_packages_of_each_system_and_what_cmake_misses(self):
        self.machine.add_build(found=False)
        result = self.install()
        self.assertEqual(result.returncode, 2)
        lines = result.stderr.splitlines()
        for system in SYSTEMS:
            (line,) = [line for line in lines if line.lstrip().startswith(system)]
            self.assertIn("cmake", line)
            self.assertEqual(f"{system} (not tested)" in line, system != "Debian", line)
        self.assertIn("Could not find CLI11", result.stderr)

    def test_a_program_of_readmes_first_screen_is_asked_for_too(self):
        self.machine.add_build(found=True)
        (self.machine.folder / "python3").unlink()
        result = self.install()
        self.assertEqual(result.returncode, 2)
        self.assertIn("python3 is not in PATH", result.stderr)

    def test_the_documentation_needs_no_build(self):
        self.machine.add_build(found=True)
        result = self.install("docs")
        self.assertEqual((result.returncode, self.machine.called("cmake")), (2, []))
        self.assertIn("doxygen is not in PATH", result.stderr)

    def test_with_dpkg_and_all_packages_nothing_else_is_asked(self):
        self.machine.add_build(found=False)
        self.machine.add_dpkg()
        self.assert_quiet(self.install())
        self.assertEqual(self.machine.called("cmake") + self.machine.called("apt-get"), [])

    def test_with_dpkg_nothing_is_installed_where_cmake_finds_it_elsewhere(self):
        self.machine.add_build(found=True)
        self.machine.add_dpkg(missing=["libcli11-dev"])
        self.assert_quiet(self.install())
        self.assertEqual(self.machine.called("apt-get"), [])

    def test_with_dpkg_only_what_is_missing_is_installed(self):
        self.machine.add_build(found=False)
        self.machine.add_dpkg(missing=["libcli11-dev", "python3"])
        result = self.install()
        self.assertEqual(result.returncode, 0)
        words = self.machine.called("apt-get")[-1].split()
        self.assertIn("install", words)
        self.assertEqual([word for word in words if word in ("libcli11-dev", "python3", "cmake")],
                         ["libcli11-dev", "python3"])

    def test_who_is_not_root_installs_through_sudo(self):
        self.machine.add_dpkg(missing=["g++"])
        self.machine.add("id", "echo 1000")
        result = self.install()
        self.assertEqual(result.returncode, 2)
        self.assertIn("sudo", result.stderr)
        self.machine.add("sudo", 'exec "$@"')
        self.assertEqual(self.install().returncode, 0)
        self.assertTrue(self.machine.called("sudo"))

    def test_the_tests_need_more_than_the_program(self):
        self.machine.add_build(found=True)
        self.install("check")
        self.assertIn("-DLABMOUSE_TESTS=ON", self.machine.called("cmake")[-1])
        self.machine.add_build(found=False)
        self.assertIn("rapidcheck", self.install("check").stderr)

    def test_the_page_needs_less_than_the_program(self):
        self.machine.add_build(found=False)
        for name in ("em++", "node", "npm"):
            self.machine.add(name)
        result = self.install("page")
        self.assertIn("--preset web", self.machine.called("cmake")[-1])
        self.assertIn("emscripten", result.stderr)
        for package in ("cli11", "tbb", "g++"):
            self.assertNotIn(package, result.stderr)

    def test_an_unknown_set_is_refused(self):
        self.assertEqual(self.install("everything").returncode, 2)


class PythonPackages(unittest.TestCase):
    """For CI, in a clone of which no more is there than this needs."""

    def setUp(self):
        for name in ("machine", "clone"):
            folder = tempfile.TemporaryDirectory()
            self.addCleanup(folder.cleanup)
            setattr(self, name, pathlib.Path(folder.name))
        self.machine = Machine(self.machine)
        self.machine.add_dpkg()
        self.requirements = self.clone / "scripts" / "python-requirements.txt"
        page = self.clone / "apps" / "web" / "page"
        (page / "node_modules").mkdir(parents=True)
        for file in (page / "package-lock.json", page / "node_modules" / ".installed-lock.json"):
            file.touch()
        shutil.copytree(SOURCE / "scripts", self.requirements.parent)

    def add_python(self, pip="exit 0"):
        """A python3 that makes an environment whose pip does that; compileall does nothing there."""
        self.machine.add("pip", pip)
        self.machine.add("python3", "mkdir -p $4/bin; "
                         "printf '#!/bin/sh\\n[ $2 != pip ] || exec pip \"$@\"\\n' >$4/bin/python; chmod +x $4/bin/python")

    def install(self, part="ci"):
        return self.machine.run(self.clone / "scripts" / "install", part)

    def test_are_installed_with_hashes_and_only_once(self):
        self.add_python()
        self.assertEqual(self.install().returncode, 0)
        calls = self.machine.called("pip")
        self.assertEqual(len(calls), 2)  # what robots of tests import, and what builds the package
        for call in calls:
            self.assertIn("--require-hashes", call)
        result = self.install()
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(len(self.machine.called("pip")), 2)

    def test_for_the_package_alone(self):
        self.add_python()
        self.assertEqual(self.install("python").returncode, 0)
        (call,) = self.machine.called("pip")
        self.assertIn("python-tools.txt", call)

    def test_are_installed_again_where_others_are_wanted(self):
        self.add_python()
        self.install()
        self.requirements.write_text("numpy==2.0.0\n")
        self.assertEqual(self.install().returncode, 0)
        self.assertEqual(len(self.machine.called("pip")), 3)

    def test_that_cannot_be_installed_are_an_error_each_time(self):
        self.add_python(pip="echo 'no such wheel'; exit 1")
        for _ in range(2):
            result = self.install()
            self.assertEqual(result.returncode, 2)
            self.assertIn("no such wheel", result.stderr)
            self.assertIn("scripts/install: error: ", result.stderr.splitlines()[-1])

    def test_are_for_ci_alone(self):
        self.machine.add_build(found=True)
        self.add_python(pip="exit 1")
        for part in ("race", "check", "page"):
            self.assertEqual(self.install(part).returncode, 0)
        self.assertEqual(self.machine.called("pip"), [])


unittest.main()
