"""A machine that small programs pretend."""

import os
import pathlib
import shutil
import subprocess


class Machine:
    """A PATH of its own: the usual small tools, and programs that write down how they were called."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.calls = self.folder / "calls"
        self.calls.touch()
        for tool in ("sh", "cat", "chmod", "cmp", "cp", "dirname", "env", "grep", "head", "mkdir", "mktemp", "rm", "sed", "tail"):
            (self.folder / tool).symlink_to(shutil.which(tool))
        self.add("id", "echo 0")

    def add(self, name, script="exit 0"):
        program = self.folder / name
        program.unlink(missing_ok=True)
        program.write_text(f"#!/bin/sh\necho {name} \"$@\" >>'{self.calls}'\n{script}\n")
        program.chmod(0o755)

    def add_build(self, found):
        for name in ("ninja", "python3"):
            self.add(name)
        self.add("cmake", "exit 0" if found else "echo 'CMake Error: Could not find CLI11'; exit 1")

    def add_dpkg(self, missing=()):
        self.add("dpkg-query", "\n".join(f'[ "$3" = {name} ] && exit 1' for name in missing) + "\nprintf installed")
        self.add("apt-get")

    def run(self, *command, **options):
        environment = {**os.environ, "PATH": str(self.folder)}
        return subprocess.run(command, env=environment, capture_output=True, text=True, **options)

    def called(self, name):
        return [line for line in self.calls.read_text().splitlines() if line.startswith(name + " ")]
